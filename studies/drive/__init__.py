"""One material point driven through a test: the test asked for, its run, its table, files and figure."""
