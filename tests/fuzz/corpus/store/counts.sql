UPDATE study SET value = 9223372036854775807 WHERE key = 'rows'; UPDATE batches SET rows = 2; DELETE FROM samples WHERE row > 2
