"""Many pairs: read, registered side by side, and recorded so that a run can be resumed. Private;
:func:`pyemtr.register_many` is the way in, and docs/MANY_PAIRS.md the page."""
