"""Which effects a scene calls for: decided beforehand by its own numbers, verified afterwards by what was found."""
