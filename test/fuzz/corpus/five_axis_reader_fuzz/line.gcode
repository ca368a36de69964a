;FIVE_AXIS:tool_tip X Y Z A C
; start of the part
G0 A17.2 C0
G0 X20 Y0
G0 Z0.2
G94
;LAYER:0
;HEIGHT:0.2
;TYPE:infill
G1 X30 C30 E0.29691 F1800
; end of the part
