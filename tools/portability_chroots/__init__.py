"""What tools/portability does."""
