"""A declaration that contradicts itself is refused in one sentence that says what to do."""
