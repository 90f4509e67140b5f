"""The studies of matpoint: scenes, runs, quantities, comparison, report and the command line."""
