; The installer of the program for Windows. makensis -DVERSION=... -DFILES=folder -DOUTPUT=file app/packaging/installer.nsi
; For the user alone, without an administrator. Silent with /S; into another folder with /D=folder as the last word.
Target amd64-unicode
!include MUI2.nsh

Name "Meltpool"
OutFile "${OUTPUT}"
InstallDir "$LOCALAPPDATA\Programs\Meltpool"
InstallDirRegKey HKCU "Software\Meltpool" "Folder"
RequestExecutionLevel user
SetCompressor /SOLID lzma
VIProductVersion "${VERSION}.0"
VIAddVersionKey ProductName "Meltpool"
VIAddVersionKey FileDescription "Meltpool welding trainer, installer"
VIAddVersionKey FileVersion "${VERSION}"
VIAddVersionKey LegalCopyright "MIT licence"

!define MUI_ICON "meltpool.ico"
!define MUI_UNICON "meltpool.ico"
!define UNINSTALL "Software\Microsoft\Windows\CurrentVersion\Uninstall\Meltpool"
!define CLASSES "Software\Classes"
!insertmacro MUI_PAGE_LICENSE "${FILES}\handbook\LICENSE"
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!define MUI_FINISHPAGE_RUN "$INSTDIR\meltpool-window.exe"
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_COMPONENTS
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"

!macro TellShell
    System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)'
!macroend

Section "Meltpool"
    SetOutPath "$INSTDIR"
    File /r "${FILES}\*.*"
    WriteUninstaller "$INSTDIR\uninstall.exe"
    CreateDirectory "$SMPROGRAMS\Meltpool"
    CreateShortcut "$SMPROGRAMS\Meltpool\Meltpool.lnk" "$INSTDIR\meltpool-window.exe"
    CreateShortcut "$SMPROGRAMS\Meltpool\Uninstall Meltpool.lnk" "$INSTDIR\uninstall.exe"
    WriteRegStr HKCU "Software\Meltpool" "Folder" "$INSTDIR"
    WriteRegStr HKCU "${CLASSES}\.meltpool" "" "Meltpool.Lesson"
    WriteRegStr HKCU "${CLASSES}\Meltpool.Lesson" "" "Lesson of the welding trainer"
    WriteRegStr HKCU "${CLASSES}\Meltpool.Lesson\DefaultIcon" "" "$INSTDIR\meltpool-window.exe,0"
    WriteRegStr HKCU "${CLASSES}\Meltpool.Lesson\shell\open\command" "" \
        '"$INSTDIR\meltpool-window.exe" --lesson "%1"'
    WriteRegStr HKCU "${UNINSTALL}" "DisplayName" "Meltpool"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayVersion" "${VERSION}"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayIcon" "$INSTDIR\meltpool-window.exe"
    WriteRegStr HKCU "${UNINSTALL}" "Publisher" "The Meltpool authors"
    WriteRegStr HKCU "${UNINSTALL}" "UninstallString" '"$INSTDIR\uninstall.exe"'
    WriteRegStr HKCU "${UNINSTALL}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
    WriteRegDWORD HKCU "${UNINSTALL}" "NoModify" 1
    WriteRegDWORD HKCU "${UNINSTALL}" "NoRepair" 1
    !insertmacro TellShell
SectionEnd

Section "un.Meltpool"
    SectionIn RO
    ; Only what was installed: the folder may be one that holds other things too.
    Delete "$INSTDIR\meltpool.exe"
    Delete "$INSTDIR\meltpool-window.exe"
    Delete "$INSTDIR\licences.txt"
    RMDir /r "$INSTDIR\shaders"
    RMDir /r "$INSTDIR\data"
    RMDir /r "$INSTDIR\validation"
    RMDir /r "$INSTDIR\fonts"
    RMDir /r "$INSTDIR\handbook"
    Delete "$INSTDIR\uninstall.exe"
    RMDir "$INSTDIR"
    ; The picture of the workshop can be painted again; the folder goes only if it holds nothing else.
    Delete "$LOCALAPPDATA\meltpool\workshop.bin"
    RMDir "$LOCALAPPDATA\meltpool"
    RMDir /r "$SMPROGRAMS\Meltpool"
    DeleteRegKey HKCU "${UNINSTALL}"
    DeleteRegKey HKCU "${CLASSES}\Meltpool.Lesson"
    DeleteRegKey HKCU "${CLASSES}\.meltpool"
    DeleteRegKey HKCU "Software\Meltpool"
    !insertmacro TellShell
SectionEnd

; Not chosen unless asked for: attempts, results, settings and lessons are the user's work.
Section /o "un.Recordings, results, settings and own lessons"
    RMDir /r "$APPDATA\meltpool"
    RMDir /r "$LOCALAPPDATA\meltpool"
SectionEnd
