;Layer height: 0.2
;LAYER_CHANGE
;Z:.4
;TYPE:External perimeter
G1 X9 E1 ; perimeter
;LAYER:3
G1 X1 E2 ; move to next layer (4)
