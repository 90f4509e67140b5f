"""Where results are kept and how they are shown: folders, JSON, tables, numbers, progress of a study."""
