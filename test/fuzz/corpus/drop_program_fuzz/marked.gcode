;drop_diameter=0.4
;layer_height=0.3
;strategy=drops_raster
;units=mm
G28
G21
G90
;LAYER:0
G1 X1 Y1 Z0.3 F600
;TYPE:CONTOUR
M780
G1 X1.4
M780 P3
;TYPE:INFILL
G0 Y1.4
M780
;LAYER:1
G1 Z0.6
X1
M780
;end of the part
M84
