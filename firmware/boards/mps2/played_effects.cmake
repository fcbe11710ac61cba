# Effects::bits of the program zstrip_played_m0_* that is built for a test: light on plain surfaces.
set(ZSTRIP_PLAYED_EFFECTS 00400000000003)
