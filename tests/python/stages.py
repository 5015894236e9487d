"""The stages of a registration that a progress callback sees, in their order."""

STAGES = [
    "normalization",
    "downsampling",
    "features",
    "matching",
    "seeds",
    "evolution",
    "candidates",
    "fallback_search",
    "refinement",
    "verdict",
]
