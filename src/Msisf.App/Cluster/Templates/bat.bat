@echo off
setlocal EnableExtensions DisableDelayedExpansion
chcp 65001 >nul
rem @HEAD@
rem The pieces of a run, one after another. Run again, it makes what is missing. The variable MSIS names another program to run.
if not defined MSIS set "MSIS=@LAUNCHER@"
ver >nul
pushd @WORKING_FOLDER@
if errorlevel 1 exit /b 2
set worst=0
@PIECES@
popd
exit /b %worst%

:piece
"%MSIS%" @ARGUMENTS@ --frames %1
set code=%errorlevel%
rem a program that crashed has a negative code
if %code% lss 0 set code=70
if %code% gtr %worst% set worst=%code%
exit /b 0
