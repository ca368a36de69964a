0M83
G1 Z0 F7800 ; move to next layer (0)
G1X0Y10
G1 X5 E1 ; perimeter
; Filament-specific end gcode 
G1 X0
