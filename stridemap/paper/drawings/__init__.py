"""The figures of the paper: what each is drawn from, and how."""
