"""What is observed and measured along a step."""
