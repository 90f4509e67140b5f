"""Taylor impact experiments: measured shots against what flow laws and both methods predict."""
