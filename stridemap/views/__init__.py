"""What draws from tables and motions: the paper's figures, and walkers in motion.

Only here is matplotlib imported, and only when something is drawn.
"""
