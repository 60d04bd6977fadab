UPDATE study SET value = replace(value, 'impactor.speed', 'pad.thickness') WHERE key = 'resolved';
UPDATE factors SET key = 'pad.thickness', unit = 'm';
