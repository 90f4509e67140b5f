"""Objective rates of the hypoelastic update other than that of Green and Naghdi."""
