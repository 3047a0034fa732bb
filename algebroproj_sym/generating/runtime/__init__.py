"""What generated packages need at run time: these modules are copied into them as they are."""
