UPDATE samples SET peak_force = -1, status = 'bottomed out', error = 1e9 WHERE row = 1
