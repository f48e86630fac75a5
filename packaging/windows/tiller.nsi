; SPDX-License-Identifier: MIT
; Installer for the output of build.ps1. NOT TESTED.
Unicode true
!include "MUI2.nsh"
Name "Tiller"
OutFile "..\..\build\windows\tiller-setup.exe"
InstallDir "$PROGRAMFILES64\Tiller"
!insertmacro MUI_PAGE_LICENSE "..\..\app\LICENSE"
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"

Section
  SetOutPath "$INSTDIR"
  File /r "..\..\build\windows\tiller\*"
  CreateShortcut "$SMPROGRAMS\Tiller.lnk" "$INSTDIR\bin\tiller.exe"
  WriteRegStr HKLM "Software\Classes\.tiller" "" "Tiller.Project"
  WriteRegStr HKLM "Software\Classes\Tiller.Project\shell\open\command" "" '"$INSTDIR\bin\tiller.exe" "%1"'
  WriteRegStr HKLM "Software\Microsoft\Windows\CurrentVersion\Uninstall\Tiller" "DisplayName" "Tiller"
  WriteRegStr HKLM "Software\Microsoft\Windows\CurrentVersion\Uninstall\Tiller" "UninstallString" '"$INSTDIR\uninstall.exe"'
  WriteUninstaller "$INSTDIR\uninstall.exe"
SectionEnd

Section "Uninstall"
  RMDir /r "$INSTDIR\bin"
  RMDir /r "$INSTDIR\share"
  Delete "$INSTDIR\uninstall.exe"
  RMDir "$INSTDIR"
  Delete "$SMPROGRAMS\Tiller.lnk"
  DeleteRegKey HKLM "Software\Classes\.tiller"
  DeleteRegKey HKLM "Software\Classes\Tiller.Project"
  DeleteRegKey HKLM "Software\Microsoft\Windows\CurrentVersion\Uninstall\Tiller"
SectionEnd
