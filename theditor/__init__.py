"""theditor: an interactive editor for TH-type uniform B-splines."""
