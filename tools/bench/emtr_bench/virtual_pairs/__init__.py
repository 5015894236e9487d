"""Ten generated pairs, which need no download: what a benchmark runs on where no others are."""
