"""What the reproduction is made of; the standard library alone."""

#: Name: what it is, as --help says it.
SECTIONS = {
    "library": "EMTR-SSC as published, with parts off, and the presets default and fast",
    "evolving": "the eight evolving methods and two controls, with EMTR-SSC's queries",
    "evaluations": "the same with its evaluations, each on the dense clouds",
    "tasks": "EMTR-SSC in Python: alpha against beta, and rmp and delta adapted",
    "sweep": "success and errors over rmp and delta",
    "traditional": "ICP, NDT and TrICP after RANSAC (PCL), and FGR (Open3D), where they are there",
    "modelnet": "the ModelNet40 protocol, on --modelnet or on shapes that are made",
    "precision": "readings of what the paper leaves open, and their errors",
    "functions": "the evolving methods on functions with known optima",
}
