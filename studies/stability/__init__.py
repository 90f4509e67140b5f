"""Hard cases against variants of both methods: what stays stable, what is rescued, refused, or fails."""
