MODULE line
!# variant powder_5_axes
  CONST speeddata speed_aire:=[100.000,500,5000,1000];
  PROC Haz_ON()
    Set SolicitudLaser;
  ENDPROC
  PROC Haz_OFF()
    Reset SolicitudLaser;
  ENDPROC
  PROC main()
    ConfL\Off;
    deposit_1;
  ENDPROC
!# layer 0.2 0.2
!# path travel open turned 2
!# path infill open 1
!# bead 0.4 0.2 1
  PROC deposit_1()
MoveL [[0.0000,0.0000,5.0000],[0,1,0,0],[-1,0,0,2],[0.000,9e+09,9e+09,9e+09,9e+09,9e+09]],speed_aire,fine,t\WObj:=w;

MoveL [[0.0000,0.0000,0.2000],[0,1,0,0],[-1,0,0,2],[0.000,9e+09,9e+09,9e+09,9e+09,9e+09]],speed_aire,fine,t\WObj:=w;
Haz_ON;
MoveL [[10.0000,0.0000,0.2000],[0,1,0,0],[-1,0,0,2],[0.000,9e+09,9e+09,9e+09,9e+09,9e+09]],v20,fine,t\WObj:=w;
Haz_OFF;WaitTime 1.2;
  ENDPROC
ENDMODULE
