"""The colours of all pictures, and of the lines on the page to explore.

They are from the set of Okabe and Ito (jfly.uni-koeln.de/color), which people with any colour vision can tell
apart.
"""

BLACK, WHITE = "#000000", "#ffffff"
BLUE, VERMILION, GREEN, PURPLE, SKY = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9"
DARK, GREY, PALE = "#404040", "#b4b4b4", "#e6e6e6"
