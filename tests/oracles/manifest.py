"""The manifest of generated files that were never written."""

import hashlib
import json
from dataclasses import replace


def manifest(spec, contents):
    """``manifest.json`` as bytes.

    Parameters
    ----------
    spec : ModelSpec
    contents : dict of str to bytes
        The files that it names.
    """
    hashes = {name: hashlib.sha256(content).hexdigest() for name, content in contents.items()}
    return json.dumps(replace(spec, files=hashes).to_manifest()).encode()
