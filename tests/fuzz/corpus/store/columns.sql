ALTER TABLE samples RENAME COLUMN peak_force TO "peak""force"; UPDATE responses SET name = 'peak"force', meaning = 'x' || char(27) WHERE position = 0;
INSERT INTO responses VALUES (2, 'hic15', '1', ''); ALTER TABLE samples ADD COLUMN hic15 TEXT DEFAULT 'many'
