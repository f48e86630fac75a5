<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>ActionStep</name>
    <message>
        <source>No gripper is configured for this robot. Select a gripper under I/O &gt; Gripper.</source>
        <translation>Für diesen Roboter ist kein Greifer eingerichtet. Wählen Sie ihn unter E/A &gt; Greifer.</translation>
    </message>
    <message>
        <source>Run route</source>
        <translation>Route</translation>
    </message>
    <message>
        <source>%1 did not turn on within %2 s. Check the connected device, then try again.</source>
        <translation>%1 wurde nicht innerhalb von %2 s eingeschaltet. Prüfen Sie das angeschlossene Gerät und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>%1 did not turn off within %2 s. Check the connected device, then try again.</source>
        <translation>%1 wurde nicht innerhalb von %2 s ausgeschaltet. Prüfen Sie das angeschlossene Gerät und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>The action “%1” was not completed. %2</source>
        <translation>Die Aktion „%1“ wurde nicht ausgeführt. %2</translation>
    </message>
    <message>
        <source>The gripper did not stop moving within %1 s. Check the gripper, then try again.</source>
        <translation>Der Greifer kam nicht innerhalb von %1 s zum Stillstand. Prüfen Sie den Greifer und versuchen Sie es erneut.</translation>
    </message>
</context>
<context>
    <name>ActionTable</name>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Power and safety</source>
        <translation>Strom und Sicherheit</translation>
    </message>
    <message>
        <source>Control and programs</source>
        <translation>Steuerung und Programme</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Wegpunkte</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Koordinatensysteme</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/A</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Perspectives</source>
        <translation>Arbeitsansichten</translation>
    </message>
    <message>
        <source>Move panels</source>
        <translation>Bereiche verschieben</translation>
    </message>
    <message>
        <source>Application</source>
        <translation>Anwendung</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Program steps</source>
        <translation>Programmschritte</translation>
    </message>
</context>
<context>
    <name>ActionWords</name>
    <message>
        <source>%1 on</source>
        <translation>%1 an</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1 aus</translation>
    </message>
    <message>
        <source>%1 on for %2 s</source>
        <translation>%1 an für %2 s</translation>
    </message>
    <message>
        <source>%1 off for %2 s</source>
        <translation>%1 aus für %2 s</translation>
    </message>
    <message>
        <source>Wait until %1 is on (max. %2 s)</source>
        <translation>Warten, bis %1 eingeschaltet ist (max. %2 s)</translation>
    </message>
    <message>
        <source>Wait until %1 is off (max. %2 s)</source>
        <translation>Warten, bis %1 ausgeschaltet ist (max. %2 s)</translation>
    </message>
    <message>
        <source>Wait until %1 is on</source>
        <translation>Warten, bis %1 eingeschaltet ist</translation>
    </message>
    <message>
        <source>Wait until %1 is off</source>
        <translation>Warten, bis %1 ausgeschaltet ist</translation>
    </message>
    <message>
        <source>Wait %1 s</source>
        <translation>%1 s warten</translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation>Den Greifer öffnen</translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation>Den Greifer schließen</translation>
    </message>
    <message>
        <source>Set an output</source>
        <translation>Einen Ausgang setzen</translation>
    </message>
    <message>
        <source>Pulse an output</source>
        <translation>Einen Ausgang pulsen</translation>
    </message>
    <message>
        <source>Wait for an input</source>
        <translation>Auf einen Eingang warten</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Warten</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Jog, teach, run and monitor a Universal Robots arm from a PC.</source>
        <translation>Einen Arm von Universal Robots vom PC aus verfahren, teachen, betreiben und beobachten.</translation>
    </message>
    <message>
        <source>Start with the built-in simulated UR5e.</source>
        <translation>Mit dem eingebauten simulierten UR5e beginnen.</translation>
    </message>
    <message>
        <source>Connect to the robot at this address or host name.</source>
        <translation>Mit dem Roboter an dieser Adresse oder diesem Hostnamen verbinden.</translation>
    </message>
    <message>
        <source>Run the scripted demonstration on the simulated robot, write its files to this folder, and exit.</source>
        <translation>Die Vorführung am simulierten Roboter ausführen, ihre Dateien in diesen Ordner schreiben und beenden.</translation>
    </message>
    <message>
        <source>Open this project file (.tiller).</source>
        <translation>Diese Projektdatei (.tiller) öffnen.</translation>
    </message>
    <message>
        <source>Colour theme: light or dark.</source>
        <translation>Farbschema: light (hell) oder dark (dunkel).</translation>
    </message>
    <message>
        <source>see tiller --help</source>
        <translation>siehe tiller --help</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>unerwartetes Argument &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--theme must be light or dark, not &quot;%1&quot;</source>
        <translation>--theme muss light oder dark sein, nicht &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--robot and --simulator cannot be combined</source>
        <translation>--robot und --simulator lassen sich nicht kombinieren</translation>
    </message>
    <message>
        <source>--demo works only on the simulated robot and cannot be combined with --robot</source>
        <translation>--demo läuft nur mit dem simulierten Roboter und lässt sich nicht mit --robot kombinieren</translation>
    </message>
    <message>
        <source>--demo requires a folder</source>
        <translation>--demo benötigt einen Ordner</translation>
    </message>
    <message>
        <source>--robot requires an address, e.g. --robot 192.168.0.10</source>
        <translation>--robot benötigt eine Adresse, z. B. --robot 192.168.0.10</translation>
    </message>
    <message>
        <source>only one project can be opened; remove &quot;%1&quot;</source>
        <translation>es kann nur ein Projekt geöffnet werden; entfernen Sie &quot;%1&quot;</translation>
    </message>
    <message>
        <source>Monitor only: do not change anything on the robot; STOP still works. Cannot be turned off in Settings.</source>
        <translation>Nur beobachten: am Roboter nichts ändern; STOP wirkt weiterhin. Lässt sich in den Einstellungen nicht ausschalten.</translation>
    </message>
    <message>
        <source>--demo moves the simulated robot and cannot be combined with --monitor-only</source>
        <translation>--demo bewegt den simulierten Roboter und lässt sich nicht mit --monitor-only kombinieren</translation>
    </message>
    <message>
        <source>Open these recordings in the plots.</source>
        <translation>Diese Aufzeichnungen in den Diagrammen öffnen.</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>Joint positions</source>
        <translation>Gelenkstellungen</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>TCP-Position</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>Gelenkströme</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Kraft am TCP</translation>
    </message>
    <message>
        <source>%1: not compared</source>
        <translation>%1: nicht verglichen</translation>
    </message>
    <message>
        <source>%1: no values</source>
        <translation>%1: keine Werte</translation>
    </message>
    <message>
        <source>%1: within %2 at all times, maximum %3 at %4 s</source>
        <translation>%1: immer innerhalb von %2, Maximum %3 bei %4 s</translation>
    </message>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>TCP 6.2 mm</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: %2 deviates by %3</source>
        <translation>Arm und Modell weichen ab %1 s voneinander ab: %2 um %3</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the TCP deviates by %2</source>
        <translation>Arm und Modell weichen ab %1 s voneinander ab: TCP um %2</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the current of %2 deviates by %3</source>
        <translation>Arm und Modell weichen ab %1 s voneinander ab: Strom von %2 um %3</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: a force of %2 acts on the TCP</source>
        <translation>Arm und Modell weichen ab %1 s voneinander ab: Auf den TCP wirkt eine Kraft von %2</translation>
    </message>
    <message>
        <source>The motion matches the model of a %1</source>
        <translation>Die Bewegung entspricht dem Modell eines %1</translation>
    </message>
    <message>
        <source>Nothing to compare: the arm was powered off or guided by hand for the whole recording.</source>
        <translation>Kein Vergleich möglich: Der Arm war während der gesamten Aufzeichnung ausgeschaltet oder wurde von Hand geführt.</translation>
    </message>
    <message>
        <source>The arm deviates from the model from the start of the recording. Check the payload and the robot model, and check whether something was touching the arm.</source>
        <translation>Arm und Modell weichen vom Beginn der Aufzeichnung an voneinander ab. Prüfen Sie die Nutzlast, das Robotermodell und ob etwas den Arm berührt hat.</translation>
    </message>
    <message>
        <source>From this time on, the arm was pushed or held, its payload differed, or a joint did not follow its target.</source>
        <translation>Ab diesem Zeitpunkt wurde der Arm geschoben oder festgehalten, seine Nutzlast war eine andere, oder ein Gelenk folgte seinem Sollwert nicht.</translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: its sampling interval is too long. Record every packet.</source>
        <translation>Diese Aufzeichnung lässt sich nicht mit einem Modell vergleichen: Ihr Abtastintervall ist zu lang. Zeichnen Sie jedes Paket auf.</translation>
    </message>
    <message>
        <source>Not compared with the arm model.</source>
        <translation>Nicht mit dem Modell des Arms verglichen.</translation>
    </message>
    <message>
        <source>The compared values match the model of a %1; other values were not recorded</source>
        <translation>Die verglichenen Werte stimmen mit dem Modell eines %1 überein; andere Werte wurden nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>The recorded arm is a %1, but it was compared with the model of a %2</source>
        <translation>Der aufgezeichnete Arm ist ein %1, wurde aber mit dem Modell eines %2 verglichen</translation>
    </message>
    <message>
        <source>No deviation from the model of a %1, but the recorded values may fit other models too</source>
        <translation>Keine Abweichung vom Modell eines %1, aber die aufgezeichneten Werte können auch zu anderen Modellen passen</translation>
    </message>
    <message>
        <source>Compare the recording with the model of a %1.</source>
        <translation>Vergleichen Sie die Aufzeichnung mit dem Modell eines %1.</translation>
    </message>
    <message>
        <source>%1: not compared because the recording has no %2; record all signals to an MCAP file</source>
        <translation>%1: nicht verglichen, da die Aufzeichnung kein Signal %2 enthält; zeichnen Sie alle Signale als MCAP auf</translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: target or actual joint positions are missing. Record all signals to an MCAP file.</source>
        <translation>Diese Aufzeichnung lässt sich nicht mit einem Modell vergleichen: Soll- oder Ist-Gelenkpositionen fehlen. Zeichnen Sie alle Signale als MCAP auf.</translation>
    </message>
    <message>
        <source>%1: exceeds %2 starting at %3 s (%4), maximum %5 at %6 s</source>
        <translation>%1: überschreitet %2 ab %3 s (%4), Maximum %5 bei %6 s</translation>
    </message>
</context>
<context>
    <name>ControllerCodes</name>
    <message>
        <source>Near a joint limit</source>
        <translation>Nahe an einer Gelenkgrenze</translation>
    </message>
    <message>
        <source>A joint came close to its limit.</source>
        <translation>Ein Gelenk kam dem Ende seines Bereichs nahe.</translation>
    </message>
    <message>
        <source>Jog the joint away from the limit, or change the waypoint.</source>
        <translation>Verfahren Sie das Gelenk von der Grenze weg oder ändern Sie den Wegpunkt.</translation>
    </message>
    <message>
        <source>Near a tool orientation limit</source>
        <translation>Nahe an einer Grenze der Werkzeugausrichtung</translation>
    </message>
    <message>
        <source>The tool orientation came close to the limit set in the safety configuration.</source>
        <translation>Die Werkzeugausrichtung kam der Grenze der Sicherheitskonfiguration nahe.</translation>
    </message>
    <message>
        <source>Rotate the tool away from the limit, or change the waypoint.</source>
        <translation>Drehen Sie das Werkzeug zurück oder ändern Sie den Wegpunkt.</translation>
    </message>
    <message>
        <source>Near a safety plane</source>
        <translation>Nahe an einer Sicherheitsebene</translation>
    </message>
    <message>
        <source>The arm came close to a safety plane.</source>
        <translation>Der Arm kam einer Sicherheitsebene nahe.</translation>
    </message>
    <message>
        <source>Jog away from the plane, or change the waypoint.</source>
        <translation>Fahren Sie von der Ebene weg oder ändern Sie den Wegpunkt.</translation>
    </message>
    <message>
        <source>Position deviates from path</source>
        <translation>Position weicht von der Bahn ab</translation>
    </message>
    <message>
        <source>The arm is not at the commanded position.</source>
        <translation>Der Arm ist nicht an der befohlenen Position.</translation>
    </message>
    <message>
        <source>Check for obstacles; check payload, centre of gravity and mounting; reduce the acceleration.</source>
        <translation>Prüfen Sie, ob Hindernisse im Weg sind; prüfen Sie Nutzlast, Schwerpunkt und Montage; verringern Sie die Beschleunigung.</translation>
    </message>
    <message>
        <source>Singularity</source>
        <translation>Singularität</translation>
    </message>
    <message>
        <source>The linear move passes through a singularity of the arm.</source>
        <translation>Die lineare Bewegung führt durch eine Singularität des Arms.</translation>
    </message>
    <message>
        <source>Jog individual joints away from the singularity. Use MoveJ to pass through the region.</source>
        <translation>Verfahren Sie einzelne Gelenke aus der Singularität heraus; durchfahren Sie diesen Bereich mit MoveJ.</translation>
    </message>
    <message>
        <source>Cannot hold position</source>
        <translation>Kann seine Position nicht halten</translation>
    </message>
    <message>
        <source>The arm sagged or was pushed while at standstill.</source>
        <translation>Der Arm ist im Stillstand abgesackt oder wurde geschoben.</translation>
    </message>
    <message>
        <source>Check payload, centre of gravity and mounting.</source>
        <translation>Prüfen Sie Nutzlast, Schwerpunkt und Montage.</translation>
    </message>
    <message>
        <source>Wrong payload or mounting</source>
        <translation>Falsche Nutzlast oder Montage</translation>
    </message>
    <message>
        <source>The measured forces do not match the payload, or the arm was pushed when Freedrive started.</source>
        <translation>Die gemessenen Kräfte passen nicht zur Nutzlast, oder der Arm wurde beim Start von Freedrive geschoben.</translation>
    </message>
    <message>
        <source>Collision detected by a joint</source>
        <translation>Kollision von einem Gelenk erkannt</translation>
    </message>
    <message>
        <source>A joint required more torque than expected for the motion.</source>
        <translation>Ein Gelenk benötigte mehr Drehmoment, als die Bewegung erfordert.</translation>
    </message>
    <message>
        <source>Remove the obstacle. If the arm did not touch anything, check the payload.</source>
        <translation>Entfernen Sie das Hindernis; war keines da, prüfen Sie die Nutzlast.</translation>
    </message>
    <message>
        <source>Collision detected at the tool</source>
        <translation>Kollision am Werkzeug erkannt</translation>
    </message>
    <message>
        <source>The force at the tool exceeded the limit.</source>
        <translation>Die Kraft am Werkzeug hat ihren Grenzwert überschritten.</translation>
    </message>
    <message>
        <source>Position deviation</source>
        <translation>Positionsabweichung</translation>
    </message>
    <message>
        <source>A joint deviated from its commanded position.</source>
        <translation>Ein Gelenk verließ seine Sollposition.</translation>
    </message>
    <message>
        <source>Check for obstacles, and check payload and mounting.</source>
        <translation>Prüfen Sie, ob Hindernisse im Weg sind, und prüfen Sie Nutzlast und Montage.</translation>
    </message>
    <message>
        <source>Too many protective stops</source>
        <translation>Zu viele Schutzstopps</translation>
    </message>
    <message>
        <source>One joint had fifty protective stops within eight hours.</source>
        <translation>Ein Gelenk hatte innerhalb von acht Stunden fünfzig Schutzstopps.</translation>
    </message>
    <message>
        <source>Find and correct the cause of the stops, then restart the controller.</source>
        <translation>Finden und beheben Sie die Ursache der Stopps und starten Sie dann die Steuerung neu.</translation>
    </message>
    <message>
        <source>Sudden change in target position</source>
        <translation>Plötzlicher Sprung der Sollposition</translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in position.</source>
        <translation>Ein Programm hat einen Positionssprung befohlen.</translation>
    </message>
    <message>
        <source>Start the program at the current position of the arm, and send servo targets in small steps.</source>
        <translation>Starten Sie das Programm an der aktuellen Position des Arms und halten Sie die Servo-Schritte klein.</translation>
    </message>
    <message>
        <source>Sudden change in target speed</source>
        <translation>Plötzlicher Sprung der Sollgeschwindigkeit</translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in speed.</source>
        <translation>Ein Programm hat einen Geschwindigkeitssprung befohlen.</translation>
    </message>
    <message>
        <source>Reduce the acceleration, or smooth the path.</source>
        <translation>Verringern Sie die Beschleunigung oder glätten Sie die Bahn.</translation>
    </message>
    <message>
        <source>Protective stop requested by a program</source>
        <translation>Schutzstopp von einem Programm angefordert</translation>
    </message>
    <message>
        <source>The running program requested the stop.</source>
        <translation>Das laufende Programm hat den Stopp angefordert.</translation>
    </message>
    <message>
        <source>See the preceding program messages in the log.</source>
        <translation>Lesen Sie die vorherigen Meldungen des Programms im Protokoll.</translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation>Der Roboter ist in lokaler Steuerung</translation>
    </message>
    <message>
        <source>A script was sent, but the robot accepts commands only from its teach pendant.</source>
        <translation>Ein Skript wurde gesendet, aber der Roboter nimmt nur Befehle vom Teach-Pendant an.</translation>
    </message>
    <message>
        <source>Switch to Remote control on the teach pendant.</source>
        <translation>Schalten Sie am Teach-Pendant auf Fernsteuerung.</translation>
    </message>
    <message>
        <source>Controller message C%1</source>
        <translation>Meldung C%1 der Steuerung</translation>
    </message>
    <message>
        <source>Tiller has no description of this message code.</source>
        <translation>Tiller hat keine Beschreibung für diesen Meldungscode.</translation>
    </message>
    <message>
        <source>Look up C%1 in the manufacturer&apos;s error code directory.</source>
        <translation>Schlagen Sie C%1 im Fehlercode-Verzeichnis des Herstellers nach.</translation>
    </message>
    <message>
        <source>Correct the payload and the mounting, and do not push the arm when Freedrive starts.</source>
        <translation>Korrigieren Sie Nutzlast und Montage, und drücken Sie beim Start von Freedrive nicht gegen den Arm.</translation>
    </message>
</context>
<context>
    <name>DerivedSignal</name>
    <message>
        <source>compute a signal</source>
        <translation>ein Signal berechnen</translation>
    </message>
    <message>
        <source>The signal “%1” does not exist. See the signal list for the names.</source>
        <translation>Es gibt kein Signal „%1“. Die Namen stehen in der Signalliste.</translation>
    </message>
    <message>
        <source>The expression contains no signal. Add the name of a signal.</source>
        <translation>Der Ausdruck enthält kein Signal. Fügen Sie den Namen eines Signals hinzu.</translation>
    </message>
    <message>
        <source>The expression contains too many signals. Use fewer signals.</source>
        <translation>Der Ausdruck enthält zu viele Signale. Verwenden Sie weniger Signale.</translation>
    </message>
    <message>
        <source>The expression must evaluate to one number.</source>
        <translation>Der Ausdruck muss eine Zahl ergeben.</translation>
    </message>
    <message>
        <source>The text is too long. Use a shorter name or expression.</source>
        <translation>Der Text ist zu lang. Verwenden Sie einen kürzeren Namen oder Ausdruck.</translation>
    </message>
    <message>
        <source>Enter a name, an equals sign and an expression, for example |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</source>
        <translation>Geben Sie einen Namen, ein Gleichheitszeichen und einen Ausdruck ein, z. B. |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</translation>
    </message>
    <message>
        <source>Too many equals signs. Use == to compare values.</source>
        <translation>Zu viele Gleichheitszeichen. Verwenden Sie für einen Vergleich ==</translation>
    </message>
    <message>
        <source>The functions are nested too deeply. Use at most %1 levels.</source>
        <translation>Die Funktionen sind zu tief verschachtelt. Verwenden Sie höchstens %1 Ebenen.</translation>
    </message>
    <message>
        <source>The closing parenthesis of “%1” is missing.</source>
        <translation>Die schließende Klammer von „%1“ fehlt.</translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression, a cut-off frequency in Hz and optionally the order (1 to 8), for example %1(actual_q_0, 10, 2).</source>
        <translation>„%1“ benötigt ein Signal oder einen Ausdruck, eine Grenzfrequenz in Hz und optional die Ordnung (1 bis 8), zum Beispiel %1(actual_q_0, 10, 2).</translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression and a time window in seconds, for example %1(actual_q_0, 0.5).</source>
        <translation>„%1“ benötigt ein Signal oder einen Ausdruck und ein Zeitfenster in Sekunden, zum Beispiel %1(actual_q_0, 0.5).</translation>
    </message>
    <message>
        <source>The cut-off frequency of “%1” must be between %2 and %3 Hz.</source>
        <translation>Die Grenzfrequenz von „%1“ muss zwischen %2 und %3 Hz liegen.</translation>
    </message>
    <message>
        <source>The time window of “%1” must be between 0.001 and 60 seconds.</source>
        <translation>Das Zeitfenster von „%1“ muss zwischen 0,001 und 60 Sekunden liegen.</translation>
    </message>
    <message>
        <source>The function “%1” does not exist.</source>
        <translation>Die Funktion „%1“ existiert nicht.</translation>
    </message>
    <message>
        <source>“%1” contains a decimal comma. Write decimal numbers with a point: %2</source>
        <translation>„%1“ enthält ein Dezimalkomma. Schreiben Sie Dezimalzahlen mit einem Punkt: %2</translation>
    </message>
</context>
<context>
    <name>DeviceTrainer</name>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>Device axes</source>
        <translation>Achsen des Geräts</translation>
    </message>
</context>
<context>
    <name>Doctor</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>The robot&apos;s software is too old. Update the software to %1.%2 or newer.</source>
        <translation>Die Software des Roboters ist zu alt. Aktualisieren Sie sie auf %1.%2 oder neuer.</translation>
    </message>
    <message>
        <source>Some values and the control registers are missing. Update the robot&apos;s software to %1.%2 or newer.</source>
        <translation>Einige Werte und die Register zum Steuern fehlen. Aktualisieren Sie die Software des Roboters auf %1.%2 oder neuer.</translation>
    </message>
    <message>
        <source>Inspect the arm and remove the cause. Then press “Recover…” in the Tiller header, or use the teach pendant.</source>
        <translation>Prüfen Sie den Arm, beseitigen Sie die Ursache und stellen Sie den Betrieb wieder her: „Wiederherstellen…“ in der Kopfzeile oder am Teach-Pendant.</translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes, with the button in the Tiller header or on the teach pendant.</source>
        <translation>Schalten Sie den Arm ein und lösen Sie die Bremsen, mit der Schaltfläche in der Kopfzeile von Tiller oder am Teach-Pendant.</translation>
    </message>
    <message>
        <source>the RTDE port accepts connections but does not respond</source>
        <translation>der RTDE-Port nimmt Verbindungen an, antwortet aber nicht</translation>
    </message>
    <message>
        <source>the service on port %1 does not use RTDE</source>
        <translation>der Dienst auf Port %1 verwendet kein RTDE</translation>
    </message>
    <message>
        <source>Too many RTDE clients are connected, or the controller has stopped responding. Close other programs, then restart the controller.</source>
        <translation>Zu viele RTDE-Clients, oder die Steuerung reagiert nicht: Schließen Sie andere Programme und starten Sie dann die Steuerung neu.</translation>
    </message>
    <message>
        <source>Check the address. The address may belong to another device, or another program may be using the port.</source>
        <translation>Prüfen Sie die Adresse: Dort antwortet ein anderes Gerät, oder ein anderes Programm verwendet den Port.</translation>
    </message>
    <message>
        <source>protocol version %1</source>
        <translation>Protokollversion %1</translation>
    </message>
    <message>
        <source>another program uses %1</source>
        <translation>ein anderes Programm verwendet %1</translation>
    </message>
    <message>
        <source>Close the other program that controls this robot (another Tiller window, ROS, ur_rtde).</source>
        <translation>Beenden Sie das andere Programm, das diesen Roboter steuert (ein anderes Fenster, ROS, ur_rtde).</translation>
    </message>
    <message>
        <source>this software version has no registers 24 to 47</source>
        <translation>diese Softwareversion hat keine Register 24 bis 47</translation>
    </message>
    <message>
        <source>Update the robot&apos;s software to 3.9, 5.3 or newer.</source>
        <translation>Aktualisieren Sie die Software des Roboters auf 3.9, 5.3 oder neuer.</translation>
    </message>
    <message>
        <source>registers 24 to 47 are free</source>
        <translation>Register 24 bis 47 sind frei</translation>
    </message>
    <message>
        <source>a fieldbus adapter or another program uses %1</source>
        <translation>ein Feldbus-Adapter oder ein anderes Programm verwendet %1</translation>
    </message>
    <message>
        <source>No action needed for jogging. To use these registers, disable EtherNet/IP, PROFINET or MODBUS in the robot&apos;s installation.</source>
        <translation>Zum Verfahren ist keine Aktion nötig. Um diese Register zu verwenden, deaktivieren Sie EtherNet/IP, PROFINET oder MODBUS in der Installation des Roboters.</translation>
    </message>
    <message>
        <source>registers 0 to 23 are free</source>
        <translation>Register 0 bis 23 sind frei</translation>
    </message>
    <message>
        <source>the robot accepts the subscription but sends no data</source>
        <translation>der Roboter nimmt das Abonnement an, sendet aber keine Daten</translation>
    </message>
    <message>
        <source>Close other RTDE programs, then restart the robot&apos;s controller.</source>
        <translation>Schließen Sie andere RTDE-Programme, starten Sie dann die Steuerung des Roboters neu.</translation>
    </message>
    <message>
        <source>%1 of %2 packets per second</source>
        <translation>%1 von %2 Paketen je Sekunde</translation>
    </message>
    <message>
        <source>Packets are missing. Use a cable instead of a wireless link, and close other programs that put load on the robot or this PC.</source>
        <translation>Es fehlen Pakete. Verwenden Sie ein Kabel statt einer Funkverbindung und schließen Sie andere Programme, die den Roboter oder diesen PC belasten.</translation>
    </message>
    <message>
        <source>priority %1</source>
        <translation>Priorität %1</translation>
    </message>
    <message>
        <source>the system does not grant this user real-time priority</source>
        <translation>das System gewährt diesem Benutzer keine Echtzeitpriorität</translation>
    </message>
    <message>
        <source>CPUs may enter deep sleep states, which delay real-time loops</source>
        <translation>CPUs können in tiefe Ruhezustände wechseln; das verzögert Echtzeitschleifen</translation>
    </message>
    <message>
        <source>TCP %1 mm from the flange, payload %2 kg</source>
        <translation>TCP %1 mm vom Flansch, Nutzlast %2 kg</translation>
    </message>
    <message>
        <source>If a tool is mounted, set the TCP and the payload in the robot&apos;s installation: a wrong payload causes protective stops and makes the arm drift in Freedrive.</source>
        <translation>Ist ein Werkzeug montiert, stellen Sie TCP und Nutzlast in der Installation des Roboters ein: Eine falsche Nutzlast löst Schutzstopps aus und lässt den Arm in Freedrive wegdriften.</translation>
    </message>
    <message>
        <source>“%1” is not a valid address, and no host with this name was found</source>
        <translation>„%1“ ist keine gültige Adresse, und es wurde kein Host mit diesem Namen gefunden</translation>
    </message>
    <message>
        <source>Enter the IP address shown on the teach pendant under About, or ask your network administrator for the host name.</source>
        <translation>Geben Sie die IP-Adresse ein, die das Teach-Pendant unter „Über“ anzeigt, oder fragen Sie Ihre Netzwerkadministration nach dem Hostnamen.</translation>
    </message>
    <message>
        <source>%1 does not respond</source>
        <translation>%1 antwortet nicht</translation>
    </message>
    <message>
        <source>no network route to %1</source>
        <translation>keine Netzwerkroute zu %1</translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and no firewall blocks the connection.</source>
        <translation>Prüfen Sie, ob der Roboter eingeschaltet und das Kabel eingesteckt ist und keine Firewall die Verbindung blockiert.</translation>
    </message>
    <message>
        <source>Assign this PC an address in the robot&apos;s network (the same first three numbers), and check the cable.</source>
        <translation>Geben Sie diesem PC eine Adresse im Netz des Roboters (die gleichen ersten drei Zahlen) und prüfen Sie das Kabel.</translation>
    </message>
    <message>
        <source>%1 responds, but provides no robot services</source>
        <translation>%1 antwortet, bietet aber keine Roboterdienste an</translation>
    </message>
    <message>
        <source>Check that this is the address of the robot. A robot that has just been switched on may need another minute.</source>
        <translation>Prüfen Sie, ob dies die Adresse des Roboters ist. Ein gerade eingeschalteter Roboter benötigt eventuell noch eine Minute.</translation>
    </message>
    <message>
        <source>%1 responds</source>
        <translation>%1 antwortet</translation>
    </message>
    <message>
        <source>dashboard, port %1</source>
        <translation>Dashboard, Port %1</translation>
    </message>
    <message>
        <source>port %1</source>
        <translation>Port %1</translation>
    </message>
    <message>
        <source>port %1 is closed</source>
        <translation>Port %1 ist geschlossen</translation>
    </message>
    <message>
        <source>port %1 does not respond</source>
        <translation>Port %1 antwortet nicht</translation>
    </message>
    <message>
        <source>Enable this interface on the robot under Settings &gt; Security &gt; Services.</source>
        <translation>Aktivieren Sie diese Schnittstelle am Roboter unter Einstellungen &gt; Sicherheit &gt; Dienste.</translation>
    </message>
    <message>
        <source>A firewall may be blocking this port. Allow TCP port %1 to the robot.</source>
        <translation>Möglicherweise blockiert eine Firewall diesen Port. Geben Sie TCP-Port %1 zum Roboter frei.</translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant. Until then, Tiller can only monitor.</source>
        <translation>Schalten Sie den Roboter am Teach-Pendant oben rechts auf Fernsteuerung. Bis dahin kann Tiller nur beobachten.</translation>
    </message>
    <message>
        <source>the dashboard accepts connections but does not respond</source>
        <translation>das Dashboard nimmt Verbindungen an, antwortet aber nicht</translation>
    </message>
    <message>
        <source>the service on port %1 is not a dashboard server</source>
        <translation>der Dienst auf Port %1 ist kein Dashboard-Server</translation>
    </message>
    <message>
        <source>Restart the robot&apos;s controller. If the problem persists, see the controller log.</source>
        <translation>Starten Sie die Steuerung des Roboters neu; wenn das Problem bleibt, lesen Sie ihr Protokoll.</translation>
    </message>
    <message>
        <source>Check the address, and check that no other program is using this port.</source>
        <translation>Prüfen Sie die Adresse und ob ein anderes Programm diesen Port verwendet.</translation>
    </message>
    <message>
        <source>this series has no Local/Remote switch</source>
        <translation>diese Baureihe hat keinen Schalter Lokal/Fern</translation>
    </message>
    <message>
        <source>Remote</source>
        <translation>Fern</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>Lokal</translation>
    </message>
    <message>
        <source>neither the dashboard (port %1) nor the Robot API (port %2) is available</source>
        <translation>weder das Dashboard (Port %1) noch die Robot API (Port %2) ist verfügbar</translation>
    </message>
    <message>
        <source>the primary interface sends no data about the arm</source>
        <translation>die primäre Schnittstelle sendet keine Daten über den Arm</translation>
    </message>
    <message>
        <source>Check that this is the address of the robot, and restart its controller.</source>
        <translation>Prüfen Sie, ob dies die Adresse des Roboters ist, und starten Sie seine Steuerung neu.</translation>
    </message>
    <message>
        <source>robot type %1 is not known to this version of Tiller</source>
        <translation>diese Version von Tiller kennt den Robotertyp %1 nicht</translation>
    </message>
    <message>
        <source>Monitoring works. Limits and previews use the dimensions that the robot reports; jog slowly at first.</source>
        <translation>Beobachten ist möglich. Grenzen und Vorschau verwenden die vom Roboter gemeldeten Maße; verfahren Sie zuerst langsam.</translation>
    </message>
    <message>
        <source>Address resolves</source>
        <translation>Adresse wird aufgelöst</translation>
    </message>
    <message>
        <source>Host responds</source>
        <translation>Host antwortet</translation>
    </message>
    <message>
        <source>RTDE port</source>
        <translation>RTDE-Port</translation>
    </message>
    <message>
        <source>Primary port</source>
        <translation>Primärer Port</translation>
    </message>
    <message>
        <source>Secondary port</source>
        <translation>Sekundärer Port</translation>
    </message>
    <message>
        <source>Real-time port</source>
        <translation>Echtzeit-Port</translation>
    </message>
    <message>
        <source>Dashboard or Robot API</source>
        <translation>Dashboard oder Robot API</translation>
    </message>
    <message>
        <source>RTDE protocol</source>
        <translation>RTDE-Protokoll</translation>
    </message>
    <message>
        <source>Controller software</source>
        <translation>Software der Steuerung</translation>
    </message>
    <message>
        <source>Robot model</source>
        <translation>Robotermodell</translation>
    </message>
    <message>
        <source>Remote control</source>
        <translation>Fernsteuerung</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Power and brakes</source>
        <translation>Strom und Bremsen</translation>
    </message>
    <message>
        <source>Control registers free</source>
        <translation>Register zum Steuern frei</translation>
    </message>
    <message>
        <source>Data rate</source>
        <translation>Datenrate</translation>
    </message>
    <message>
        <source>Real-time priority on this PC</source>
        <translation>Echtzeitpriorität auf diesem PC</translation>
    </message>
    <message>
        <source>TCP and payload</source>
        <translation>TCP und Nutzlast</translation>
    </message>
    <message>
        <source>real-time loops can keep the CPUs out of deep sleep states</source>
        <translation>Echtzeitschleifen können tiefe Ruhezustände der CPUs verhindern</translation>
    </message>
    <message>
        <source>Enable the dashboard server on the robot under Settings &gt; Security &gt; Services. On PolyScope X, the Robot API requires version 10.11 or newer.</source>
        <translation>Aktivieren Sie den Dashboard-Server am Roboter unter Einstellungen &gt; Sicherheit &gt; Dienste. PolyScope X benötigt für die Robot API Version 10.11 oder neuer.</translation>
    </message>
    <message>
        <source>Robot API %1, port %2; popups can be closed only on the teach pendant</source>
        <translation>Robot API %1, Port %2; Popups können nur am Teach-Pendant geschlossen werden</translation>
    </message>
    <message>
        <source>Fieldbus registers free</source>
        <translation>Feldbusregister frei</translation>
    </message>
    <message>
        <source>Wake-up latency on this PC</source>
        <translation>Aufwachlatenz auf diesem PC</translation>
    </message>
</context>
<context>
    <name>Freedrive</name>
    <message>
        <source>All axes</source>
        <translation>Alle Achsen</translation>
    </message>
    <message>
        <source>Position only</source>
        <translation>Nur Position</translation>
    </message>
    <message>
        <source>Orientation only</source>
        <translation>Nur Ausrichtung</translation>
    </message>
    <message>
        <source>XY plane</source>
        <translation>XY-Ebene</translation>
    </message>
    <message>
        <source>Z only</source>
        <translation>Nur Z</translation>
    </message>
    <message>
        <source>Wait for standstill before you start Freedrive.</source>
        <translation>Warten Sie auf Stillstand, bevor Sie Freedrive starten.</translation>
    </message>
    <message>
        <source>The arm would drift: the robot measures %1 with a payload of %2 kg. Do not touch the tool, or correct the payload and the TCP.</source>
        <translation>Der Arm würde wegdriften: Er misst %1 bei einer Nutzlast von %2 kg. Lassen Sie das Werkzeug los oder korrigieren Sie Nutzlast und TCP.</translation>
    </message>
</context>
<context>
    <name>Gamepad</name>
    <message>
        <source>left bumper</source>
        <translation>linke Schultertaste</translation>
    </message>
    <message>
        <source>Left stick: X and Y. Right stick: Z and rotation. Hold the right bumper to rotate with both sticks.</source>
        <translation>Linker Stick: X und Y. Rechter Stick: Z und Drehung. Rechte Schultertaste halten, um mit beiden Sticks zu drehen.</translation>
    </message>
</context>
<context>
    <name>InterfaceSize</name>
    <message>
        <source>This screen has a high resolution. Increase “Interface size” in Settings to enlarge text, controls and plots.</source>
        <translation>Dieser Bildschirm hat eine hohe Auflösung. Erhöhen Sie „Oberflächengröße“ in den Einstellungen, um Text, Bedienelemente und Diagramme zu vergrößern.</translation>
    </message>
</context>
<context>
    <name>JogActions</name>
    <message>
        <source>Jog speed %1</source>
        <translation>Verfahrgeschwindigkeit %1</translation>
    </message>
    <message>
        <source>Jog step %1, %2°</source>
        <translation>Schrittweite %1, %2°</translation>
    </message>
    <message>
        <source>Arm or disarm keyboard jogging</source>
        <translation>Tastatur-Verfahren scharf schalten oder abschalten</translation>
    </message>
    <message>
        <source>While the keyboard is armed, the arrow keys move the arm and a border surrounds the window. The keyboard is disarmed after 30 s without use.</source>
        <translation>Bei scharfer Tastatur bewegen die Pfeiltasten den Arm, und ein Rahmen umgibt das Fenster. Endet nach 30 s ohne Bedienung.</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse…</source>
        <translation>Gamepad und SpaceMouse…</translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation>Zeigt die aktuellen Werte jedes Geräts und die Richtung, in die sich der Arm bewegen würde.</translation>
    </message>
    <message>
        <source>Zero here</source>
        <translation>Hier null</translation>
    </message>
    <message>
        <source>Shows the TCP displacement from the current position. Press again to show the displacement since the start of the last motion.</source>
        <translation>Zeigt die Verschiebung des TCP von dieser Position aus. Noch einmal drücken: seit Beginn der letzten Bewegung.</translation>
    </message>
    <message>
        <source>Stops the arm. The next press uses this speed.</source>
        <translation>Stoppt den Arm; der nächste Druck hat diese Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Moves the arm by this distance while the button is held.</source>
        <translation>Bewegt den Arm um diesen Betrag, solange die Taste gehalten wird.</translation>
    </message>
    <message>
        <source>Each press moves the arm by this distance.</source>
        <translation>Jeder Druck bewegt den Arm um diesen Betrag.</translation>
    </message>
    <message>
        <source>Jog until contact (%1 N)</source>
        <translation>Verfahren bis Kontakt, %1 N</translation>
    </message>
    <message>
        <source>Moves slowly while the button is held and stops when the contact force reaches this value.</source>
        <translation>Fährt langsam, solange die Taste gehalten wird, und stoppt, wenn die Kontaktkraft diesen Wert erreicht.</translation>
    </message>
    <message>
        <source>Other jog speed…</source>
        <translation>Andere Verfahrgeschwindigkeit…</translation>
    </message>
    <message>
        <source>Sets the TCP speed. Rotation and joint speeds change in proportion.</source>
        <translation>Legt die TCP-Geschwindigkeit fest. Dreh- und Gelenkgeschwindigkeiten ändern sich im gleichen Verhältnis.</translation>
    </message>
    <message>
        <source>Other jog step…</source>
        <translation>Andere Schrittweite…</translation>
    </message>
    <message>
        <source>Sets the step length. The step angle does not change.</source>
        <translation>Legt die Schrittlänge fest. Der Schrittwinkel ändert sich nicht.</translation>
    </message>
    <message>
        <source>Other jog angle…</source>
        <translation>Anderer Drehschritt…</translation>
    </message>
    <message>
        <source>Sets the step angle of tool and joint rotations. The step length does not change.</source>
        <translation>Legt den Schrittwinkel für Werkzeug- und Gelenkdrehungen fest. Die Schrittlänge ändert sich nicht.</translation>
    </message>
    <message>
        <source>Other contact force for jogging…</source>
        <translation>Andere Kontaktkraft für Verfahren…</translation>
    </message>
    <message>
        <source>Sets the contact force in N that ends the motion.</source>
        <translation>Legt die Kontaktkraft in N fest, bei der die Bewegung endet.</translation>
    </message>
    <message>
        <source>Freedrive: %1</source>
        <translation>Freedrive: %1</translation>
    </message>
    <message>
        <source>Selects the axes that can be moved by hand during Freedrive.</source>
        <translation>Wählt die Achsen, die bei Freedrive von Hand bewegt werden können.</translation>
    </message>
</context>
<context>
    <name>JogColumn</name>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Blick</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
</context>
<context>
    <name>JointNames</name>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation>Ellbogen</translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation>Handgelenk 1</translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation>Handgelenk 2</translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation>Handgelenk 3</translation>
    </message>
</context>
<context>
    <name>KeyStateProbe</name>
    <message>
        <source>Key-state check unavailable on this platform (%1): Tiller relies on window events to detect key releases.</source>
        <translation>Tastenprüfung auf dieser Plattform nicht verfügbar (%1): Tiller erkennt das Loslassen von Tasten über Fensterereignisse.</translation>
    </message>
    <message>
        <source>Key-state check active: Tiller checks with the display server every 10 ms whether the button or key is still pressed.</source>
        <translation>Tastenprüfung aktiv: Tiller prüft alle 10 ms beim Display-Server, ob die Taste noch gedrückt ist.</translation>
    </message>
    <message>
        <source>Key-state check unavailable: Tiller could not open a second connection to the display server. Tiller relies on window events to detect key releases.</source>
        <translation>Tastenprüfung nicht verfügbar: keine zweite Verbindung zum Display-Server. Tiller erkennt das Loslassen von Tasten über Fensterereignisse.</translation>
    </message>
</context>
<context>
    <name>LimiterAdvice</name>
    <message>
        <source>Elbow almost straight</source>
        <translation>Ellbogen fast gestreckt</translation>
    </message>
    <message>
        <source>Elbow almost straight: %1 speed</source>
        <translation>Ellbogen fast gestreckt: %1 der Geschwindigkeit</translation>
    </message>
    <message>
        <source>bend the elbow</source>
        <translation>Ellbogen beugen</translation>
    </message>
    <message>
        <source>jog %1 or bend the elbow</source>
        <translation>%1 fahren oder den Ellbogen beugen</translation>
    </message>
    <message>
        <source>Wrist near the base axis</source>
        <translation>Handgelenk nahe der Basisachse</translation>
    </message>
    <message>
        <source>Wrist near the base axis: %1 speed</source>
        <translation>Handgelenk nahe der Basisachse: %1 der Geschwindigkeit</translation>
    </message>
    <message>
        <source>move outwards</source>
        <translation>nach außen fahren</translation>
    </message>
    <message>
        <source>jog %1 or rotate the base</source>
        <translation>%1 fahren oder die Basis drehen</translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°</source>
        <translation>Handgelenk 2 nahe 0° oder 180°</translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°: %1 speed</source>
        <translation>Handgelenk 2 nahe 0° oder 180°: %1 der Geschwindigkeit</translation>
    </message>
    <message>
        <source>rotate wrist 2</source>
        <translation>Handgelenk 2 drehen</translation>
    </message>
    <message>
        <source>jog %1 or rotate wrist 2</source>
        <translation>%1 fahren oder Handgelenk 2 drehen</translation>
    </message>
    <message>
        <source>%1 %2° from its limit</source>
        <translation>%1 %2° vor der Grenze</translation>
    </message>
    <message>
        <source>rotate %1 %2</source>
        <translation>%1 %2 drehen</translation>
    </message>
    <message>
        <source>jog %1 or rotate %2 %3</source>
        <translation>%1 fahren oder %2 %3 drehen</translation>
    </message>
    <message>
        <source>TCP at the speed cap: %1 speed</source>
        <translation>TCP an der Geschwindigkeitsgrenze: %1 der Geschwindigkeit</translation>
    </message>
    <message>
        <source>change the cap in Settings</source>
        <translation>Grenze in den Einstellungen ändern</translation>
    </message>
    <message>
        <source>Elbow at the speed cap: %1 speed</source>
        <translation>Ellbogen an der Geschwindigkeitsgrenze: %1 der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Rotation at the speed cap: %1 speed</source>
        <translation>Drehung an der Geschwindigkeitsgrenze: %1 der Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 at its maximum speed: %2 speed</source>
        <translation>%1 an der Höchstgeschwindigkeit: %2 der Geschwindigkeit</translation>
    </message>
    <message>
        <source>choose a lower speed</source>
        <translation>eine niedrigere Geschwindigkeit wählen</translation>
    </message>
    <message>
        <source>move away</source>
        <translation>davon wegbewegen</translation>
    </message>
    <message>
        <source>jog %1</source>
        <translation>%1 verfahren</translation>
    </message>
    <message>
        <source>%1 is %2 from %3: %4 speed</source>
        <translation>%1 ist %2 von %3 entfernt: %4 der Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 is %2 from %3</source>
        <translation>%1 ist %2 von %3 entfernt</translation>
    </message>
</context>
<context>
    <name>LocalSimulator</name>
    <message>
        <source>Simulated UR5e</source>
        <translation>Simulierter UR5e</translation>
    </message>
</context>
<context>
    <name>ModeLook</name>
    <message>
        <source>FREEDRIVE</source>
        <translation>FREEDRIVE</translation>
    </message>
    <message>
        <source>The arm can be moved by hand.</source>
        <translation>Der Arm kann von Hand bewegt werden.</translation>
    </message>
    <message>
        <source>MOVING</source>
        <translation>BEWEGT SICH</translation>
    </message>
    <message>
        <source>The robot reports that the arm is moving.</source>
        <translation>Der Roboter meldet, dass sich der Arm bewegt.</translation>
    </message>
    <message>
        <source>Remote</source>
        <translation>Fern</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>Lokal</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuell</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatik</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>KEINE DATEN</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Übernehme Steuerung…</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>Freedrive</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>In control</source>
        <translation>Gesteuert</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Verweigert</translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation>Nicht gesteuert</translation>
    </message>
    <message>
        <source>Commands take longer than 20 ms: the arm responds with a delay. Jog slowly.</source>
        <translation>Befehle dauern länger als 20 ms: Der Arm reagiert verzögert. Verfahren Sie langsam.</translation>
    </message>
    <message>
        <source>Good: the arm responds immediately and stops within 250 ms if the link fails.</source>
        <translation>Gut: Der Arm reagiert sofort und stoppt innerhalb von 250 ms, wenn die Verbindung ausfällt.</translation>
    </message>
    <message>
        <source>Last 10 s: %1 packets, %2 late, %3 lost</source>
        <translation>Letzte 10 s: %1 Pakete, %2 spät, %3 verloren</translation>
    </message>
    <message>
        <source>Since connecting: %1 packets, %2 late, %3 lost</source>
        <translation>Seit dem Verbinden: %1 Pakete, %2 spät, %3 verloren</translation>
    </message>
    <message>
        <source>A packet counts as late when it arrives more than half a period after its expected time.</source>
        <translation>Ein Paket gilt als spät, wenn es mehr als eine halbe Periode nach der erwarteten Zeit eintrifft.</translation>
    </message>
    <message>
        <source>No robot connected</source>
        <translation>Kein Roboter verbunden</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Verbinde…</translation>
    </message>
    <message>
        <source>Late: %1 s</source>
        <translation>Spät: %1 s</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source> · %1 late</source>
        <translation> · %1 spät</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · %1 verloren</translation>
    </message>
    <message>
        <source>LINK · JOG STOPS</source>
        <translation>LINK · FAHRT STOPPT</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>LINK</translation>
    </message>
    <message>
        <source>LINK · JOG MAY STOP</source>
        <translation>LINK · STOPP MÖGLICH</translation>
    </message>
    <message>
        <source>LINK · ARM LAGS</source>
        <translation>LINK · ARM FOLGT SPÄT</translation>
    </message>
    <message>
        <source>LINK · GOOD</source>
        <translation>LINK · GUT</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Verbinden…</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>Bremsen lösen</translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation>Wiederherstellen…</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Steuerung übernehmen</translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation>Schaltet den Arm ein. Die Bremsen bleiben angezogen.</translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation>Der Arm kann einige Millimeter absacken. Halten Sie Abstand.</translation>
    </message>
    <message>
        <source>Shows the cause of the stop, the five seconds before it, and the recovery steps. The arm does not move.</source>
        <translation>Zeigt die Ursache des Stopps, die fünf Sekunden davor und die Schritte zur Wiederherstellung. Der Arm bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Data late</source>
        <translation>Daten verspätet</translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation>Startet das Steuerprogramm auf dem Roboter. Fragt nach, bevor ein anderes Programm gestoppt wird.</translation>
    </message>
    <message>
        <source>Monitoring</source>
        <translation>Beobachtet</translation>
    </message>
    <message>
        <source>Select the simulator or enter the address of a robot.</source>
        <translation>Wählen Sie den Simulator oder geben Sie die Adresse eines Roboters ein.</translation>
    </message>
    <message>
        <source>Packets are late or lost: jogging may stop and plots may have gaps. Use a cable instead of a wireless link, and close other programs.</source>
        <translation>Pakete kommen spät oder gehen verloren: Das Verfahren kann stoppen, und Diagramme haben Lücken. Verwenden Sie ein Kabel statt einer Funkverbindung und schließen Sie andere Programme.</translation>
    </message>
</context>
<context>
    <name>ModeWords</name>
    <message>
        <source>No controller</source>
        <translation>Keine Steuerung</translation>
    </message>
    <message>
        <source>The robot&apos;s controller is not running. Restart the control box.</source>
        <translation>Die Steuerung des Roboters läuft nicht. Starten Sie die Control-Box neu.</translation>
    </message>
    <message>
        <source>Arm disconnected</source>
        <translation>Arm getrennt</translation>
    </message>
    <message>
        <source>The controller has no connection to the arm. See the teach pendant for the cause.</source>
        <translation>Die Steuerung hat keine Verbindung zum Arm. Sehen Sie auf das Teach-Pendant.</translation>
    </message>
    <message>
        <source>Confirm safety</source>
        <translation>Sicherheit bestätigen</translation>
    </message>
    <message>
        <source>Confirm the safety configuration on the teach pendant.</source>
        <translation>Bestätigen Sie die Sicherheitskonfiguration am Teach-Pendant.</translation>
    </message>
    <message>
        <source>Booting</source>
        <translation>Startet</translation>
    </message>
    <message>
        <source>The arm is starting. Wait a few seconds.</source>
        <translation>Der Arm startet. Warten Sie einige Sekunden.</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>Ausgeschaltet</translation>
    </message>
    <message>
        <source>The arm is powered off. Power on the arm.</source>
        <translation>Der Arm ist ausgeschaltet. Schalten Sie ihn ein.</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Eingeschaltet</translation>
    </message>
    <message>
        <source>The arm is powered on and initializing. Wait a moment.</source>
        <translation>Der Arm ist eingeschaltet und wird initialisiert. Warten Sie einen Moment.</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Leerlauf</translation>
    </message>
    <message>
        <source>The brakes are engaged. Release the brakes.</source>
        <translation>Die Bremsen sind angezogen. Lösen Sie sie.</translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation>Zurückdrücken</translation>
    </message>
    <message>
        <source>The arm is being moved by hand with its brakes released. Release the Freedrive button.</source>
        <translation>Der Arm wird mit gelösten Bremsen von Hand bewegt. Lassen Sie die Freedrive-Taste los.</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Updating firmware</source>
        <translation>Firmware-Update</translation>
    </message>
    <message>
        <source>The joints&apos; firmware is being updated. Do not switch off the power until the update is complete.</source>
        <translation>Die Firmware der Gelenke wird aktualisiert. Schalten Sie nicht aus, bis die Aktualisierung abgeschlossen ist.</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>No safety stop is active.</source>
        <translation>Es ist kein Sicherheitsstopp aktiv.</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reduziert</translation>
    </message>
    <message>
        <source>The reduced safety limits are active.</source>
        <translation>Die reduzierten Sicherheitsgrenzen sind aktiv.</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>Schutzstopp</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Wiederherstellung</translation>
    </message>
    <message>
        <source>The arm is outside a safety limit. Use the teach pendant to move the arm back within the limits.</source>
        <translation>Der Arm ist außerhalb einer Sicherheitsgrenze. Bewegen Sie ihn am Teach-Pendant in seine Grenzen zurück.</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>Safeguard-Stopp</translation>
    </message>
    <message>
        <source>A safeguard is open. Close it and, if a reset is configured, press the reset button.</source>
        <translation>Eine Schutzeinrichtung ist offen. Schließen Sie sie, und drücken Sie die Reset-Taste, falls ein Reset konfiguriert ist.</translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation>System-Not-Halt</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation>Sicherheitsverletzung</translation>
    </message>
    <message>
        <source>A safety limit was exceeded and power was cut. Check the cause, then restart the safety system.</source>
        <translation>Eine Sicherheitsgrenze wurde überschritten und der Strom abgeschaltet. Prüfen Sie die Ursache, dann starten Sie die Sicherheit neu.</translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation>Sicherheitsfehler</translation>
    </message>
    <message>
        <source>The safety system found a fault. Check the robot&apos;s log, then restart the safety system.</source>
        <translation>Die Sicherheit hat einen Fehler gefunden. Prüfen Sie das Protokoll des Roboters, dann starten Sie die Sicherheit neu.</translation>
    </message>
    <message>
        <source>Validate joints</source>
        <translation>Gelenke bestätigen</translation>
    </message>
    <message>
        <source>A joint was replaced. Validate the joints on the teach pendant.</source>
        <translation>Ein Gelenk wurde getauscht. Validieren Sie die Gelenke am Teach-Pendant.</translation>
    </message>
    <message>
        <source>Undefined</source>
        <translation>Unbestimmt</translation>
    </message>
    <message>
        <source>The controller does not report its safety mode. Check the teach pendant.</source>
        <translation>Die Steuerung meldet ihren Sicherheitsmodus nicht. Prüfen Sie das Teach-Pendant.</translation>
    </message>
    <message>
        <source>Automatic safeguard stop</source>
        <translation>Safeguard-Stopp Automatik</translation>
    </message>
    <message>
        <source>The automatic mode safeguard is open. Close it, or switch to manual mode.</source>
        <translation>Die Schutzeinrichtung des Automatikbetriebs ist offen. Schließen Sie sie oder wechseln Sie in den manuellen Modus.</translation>
    </message>
    <message>
        <source>Enabling device stop</source>
        <translation>Stopp Zustimmgerät</translation>
    </message>
    <message>
        <source>The enabling device is not held. Hold it in its middle position.</source>
        <translation>Das Zustimmgerät wird nicht gehalten. Halten Sie es in seiner Mittelstellung.</translation>
    </message>
    <message>
        <source>Pendant enabling stop</source>
        <translation>Stopp Zustimmtaste Pendant</translation>
    </message>
    <message>
        <source>IMMI emergency stop</source>
        <translation>IMMI-Not-Halt</translation>
    </message>
    <message>
        <source>IMMI safeguard stop</source>
        <translation>IMMI-Safeguard-Stopp</translation>
    </message>
    <message>
        <source>The moulding machine&apos;s safeguard is open. Close it.</source>
        <translation>Die Schutzeinrichtung der Spritzgießmaschine ist offen. Schließen Sie sie.</translation>
    </message>
    <message>
        <source>PROFIsafe waiting</source>
        <translation>PROFIsafe wartet</translation>
    </message>
    <message>
        <source>The robot is waiting for the PROFIsafe controller. Check the fieldbus and the PROFIsafe parameters.</source>
        <translation>Der Roboter wartet auf die PROFIsafe-Steuerung. Prüfen Sie den Feldbus und die PROFIsafe-Parameter.</translation>
    </message>
    <message>
        <source>PROFIsafe automatic stop</source>
        <translation>PROFIsafe-Automatik-Stopp</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an automatic mode safeguard stop. Clear the request on that controller.</source>
        <translation>Die PROFIsafe-Steuerung fordert den Safeguard-Stopp des Automatikbetriebs an. Heben Sie die Anforderung dort auf.</translation>
    </message>
    <message>
        <source>PROFIsafe safeguard stop</source>
        <translation>PROFIsafe-Safeguard-Stopp</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests a safeguard stop. Clear the request on that controller.</source>
        <translation>Die PROFIsafe-Steuerung fordert einen Safeguard-Stopp an. Heben Sie die Anforderung dort auf.</translation>
    </message>
    <message>
        <source>PROFIsafe emergency stop</source>
        <translation>PROFIsafe-Not-Halt</translation>
    </message>
    <message>
        <source>Safety API stop</source>
        <translation>Stopp durch Safety API</translation>
    </message>
    <message>
        <source>A program requests a safeguard stop through the safety API. Clear the request in that program.</source>
        <translation>Ein Programm fordert über die Sicherheits-API einen Safeguard-Stopp an. Heben Sie die Anforderung in diesem Programm auf.</translation>
    </message>
    <message>
        <source>I/O plane stop</source>
        <translation>Stopp E/A-Ebene</translation>
    </message>
    <message>
        <source>The tool crossed a safety plane that is enabled by an input. Move the tool back with the teach pendant, or turn the input off.</source>
        <translation>Das Werkzeug hat eine Sicherheitsebene durchquert, die ein Eingang aktiviert. Fahren Sie es mit dem Teach-Pendant zurück oder schalten Sie den Eingang aus.</translation>
    </message>
    <message>
        <source>Program stopping</source>
        <translation>Programm stoppt</translation>
    </message>
    <message>
        <source>The program on the robot is stopping.</source>
        <translation>Das Programm auf dem Roboter stoppt.</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Kein Programm</translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation>Auf dem Roboter läuft kein Programm.</translation>
    </message>
    <message>
        <source>Program running</source>
        <translation>Programm läuft</translation>
    </message>
    <message>
        <source>A program is running on the robot and may move the arm.</source>
        <translation>Auf dem Roboter läuft ein Programm und kann den Arm bewegen.</translation>
    </message>
    <message>
        <source>Program pausing</source>
        <translation>Programm hält an</translation>
    </message>
    <message>
        <source>The program is pausing.</source>
        <translation>Das Programm wird pausiert.</translation>
    </message>
    <message>
        <source>Program paused</source>
        <translation>Programm pausiert</translation>
    </message>
    <message>
        <source>Press “Play” to continue the interrupted motion, or stop the program to discard it.</source>
        <translation>Setzen Sie die unterbrochene Bewegung mit „Abspielen“ fort, oder stoppen Sie das Programm, um sie zu verwerfen.</translation>
    </message>
    <message>
        <source>Program resuming</source>
        <translation>Programm setzt fort</translation>
    </message>
    <message>
        <source>The program is resuming, and the arm may move.</source>
        <translation>Das Programm wird fortgesetzt: Der Arm kann sich bewegen.</translation>
    </message>
    <message>
        <source>Unknown robot mode %1. See the teach pendant.</source>
        <translation>Unbekannter Robotermodus %1. Sehen Sie auf das Teach-Pendant.</translation>
    </message>
    <message>
        <source>Unknown safety mode %1. See the teach pendant.</source>
        <translation>Unbekannter Sicherheitsmodus %1. Sehen Sie auf das Teach-Pendant.</translation>
    </message>
    <message>
        <source>Unknown program state %1. See the teach pendant.</source>
        <translation>Unbekannter Programmzustand %1. Sehen Sie auf das Teach-Pendant.</translation>
    </message>
    <message>
        <source>The brakes are released. The arm is at standstill.</source>
        <translation>Die Bremsen sind gelöst. Der Arm steht still.</translation>
    </message>
    <message>
        <source>The controller stopped the arm. Find the cause, wait 5 s, then unlock the protective stop.</source>
        <translation>Die Steuerung hat den Arm gestoppt. Finden Sie die Ursache, warten Sie 5 s und entriegeln Sie dann den Schutzstopp.</translation>
    </message>
    <message>
        <source>The cell&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation>Der Not-Halt der Zelle ist gedrückt. Lösen Sie ihn, dann schalten Sie ein und lösen die Bremsen.</translation>
    </message>
    <message>
        <source>The emergency stop button of the robot is pressed. Twist it clockwise to release it, then power on the arm and release the brakes.</source>
        <translation>Der Not-Halt-Taster des Roboters ist gedrückt. Drehen Sie ihn im Uhrzeigersinn, um ihn zu entriegeln, dann schalten Sie ein und lösen die Bremsen.</translation>
    </message>
    <message>
        <source>The moulding machine&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation>Der Not-Halt der Spritzgießmaschine ist gedrückt. Lösen Sie ihn, dann schalten Sie ein und lösen die Bremsen.</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an emergency stop. Clear the request on that controller, then power on the arm and release the brakes.</source>
        <translation>Die PROFIsafe-Steuerung fordert einen Not-Halt an. Heben Sie ihn dort auf, schalten Sie dann ein und lösen Sie die Bremsen.</translation>
    </message>
    <message>
        <source>The enabling button of the teach pendant is not held. Hold it in its middle position.</source>
        <translation>Die Zustimmtaste des Pendants wird nicht gehalten. Halten Sie sie in ihrer Mittelstellung.</translation>
    </message>
</context>
<context>
    <name>OutputGripper</name>
    <message>
        <source>The robot did not confirm the outputs. Another program or the installation may control them.</source>
        <translation>Der Roboter hat die Ausgänge nicht bestätigt. Möglicherweise steuert sie ein anderes Programm oder die Installation.</translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation>Greifer: schließen</translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation>Greifer: öffnen</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>steht aus…</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>open requested</source>
        <translation>Öffnen angefordert</translation>
    </message>
    <message>
        <source>close requested</source>
        <translation>Schließen angefordert</translation>
    </message>
    <message>
        <source>both outputs off</source>
        <translation>beide Ausgänge aus</translation>
    </message>
    <message>
        <source>both outputs on</source>
        <translation>beide Ausgänge ein</translation>
    </message>
    <message>
        <source>Choose different outputs for closing and opening.</source>
        <translation>Wählen Sie zwei verschiedene Ausgänge: Einer schließt, der andere öffnet.</translation>
    </message>
</context>
<context>
    <name>PanelActions</name>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Records the robot data to a file until you stop the recording.</source>
        <translation>Zeichnet die Roboterdaten in eine Datei auf, bis Sie die Aufzeichnung beenden.</translation>
    </message>
    <message>
        <source>A recording is already running.</source>
        <translation>Es läuft bereits eine Aufzeichnung.</translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation>Verbinden Sie sich zuerst mit einem Roboter.</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>Stops the recording and completes its file.</source>
        <translation>Beendet die Aufzeichnung und schließt ihre Datei ab.</translation>
    </message>
    <message>
        <source>No recording is running.</source>
        <translation>Es läuft keine Aufzeichnung.</translation>
    </message>
    <message>
        <source>Pause or resume the plots</source>
        <translation>Diagramme anhalten oder fortsetzen</translation>
    </message>
    <message>
        <source>Freezes the plots while data and recording continue. Press again to return to the newest samples.</source>
        <translation>Hält die Diagramme an, während Daten und Aufzeichnung weiterlaufen. Erneut drücken, um zu den neuesten Messwerten zurückzukehren.</translation>
    </message>
    <message>
        <source>Export the plots…</source>
        <translation>Diagramme exportieren…</translation>
    </message>
    <message>
        <source>Saves the visible range as an image, PDF page or table of values.</source>
        <translation>Speichert den sichtbaren Bereich als Bild, PDF-Seite oder Wertetabelle.</translation>
    </message>
    <message>
        <source>Plots: last %1</source>
        <translation>Diagramme: letzte %1</translation>
    </message>
    <message>
        <source>Sets the time range of the plots.</source>
        <translation>Stellt den Zeitbereich der Diagramme ein.</translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation>Ein- und Ausgänge suchen</translation>
    </message>
    <message>
        <source>Finds a terminal or a register by its number or name.</source>
        <translation>Findet eine Klemme oder ein Register nach Nummer oder Namen.</translation>
    </message>
    <message>
        <source>Rename selected input or output</source>
        <translation>Gewählten Ein- oder Ausgang umbenennen</translation>
    </message>
    <message>
        <source>Renames the input or output in the selected row of the I/O tab.</source>
        <translation>Benennt den Eingang oder Ausgang in der gewählten Zeile des Registers E/A um.</translation>
    </message>
    <message>
        <source>Switch selected output</source>
        <translation>Gewählten Ausgang schalten</translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on or off.</source>
        <translation>Schaltet den gewählten Ausgang im Register E/A ein oder aus.</translation>
    </message>
    <message>
        <source>Pulse selected output</source>
        <translation>Gewählten Ausgang pulsen</translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on for 0.5 s, then off.</source>
        <translation>Schaltet den gewählten Ausgang im Register E/A für 0,5 s ein, dann aus.</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>Protokoll durchsuchen</translation>
    </message>
    <message>
        <source>Shows only entries that contain the search text.</source>
        <translation>Zeigt nur Einträge, die den Suchtext enthalten.</translation>
    </message>
    <message>
        <source>Log: show all</source>
        <translation>Protokoll: alles zeigen</translation>
    </message>
    <message>
        <source>Log: show warnings and errors</source>
        <translation>Protokoll: Warnungen und Fehler zeigen</translation>
    </message>
    <message>
        <source>Log: show errors only</source>
        <translation>Protokoll: nur Fehler zeigen</translation>
    </message>
    <message>
        <source>Selects which log entries are shown.</source>
        <translation>Wählt, welche Protokolleinträge angezeigt werden.</translation>
    </message>
    <message>
        <source>Copy the log</source>
        <translation>Protokoll kopieren</translation>
    </message>
    <message>
        <source>Copies the selected entries. If no entry is selected, copies all visible entries.</source>
        <translation>Kopiert die gewählten oder alle sichtbaren Einträge.</translation>
    </message>
    <message>
        <source>Export the log…</source>
        <translation>Protokoll exportieren…</translation>
    </message>
    <message>
        <source>Writes the visible entries to a file.</source>
        <translation>Schreibt die sichtbaren Einträge in eine Datei.</translation>
    </message>
    <message>
        <source>Search plot signals</source>
        <translation>Signale für die Diagramme suchen</translation>
    </message>
    <message>
        <source>Opens the list of all signals. To add a signal to a plot, drag it, double-click it or press Return.</source>
        <translation>Öffnet die Liste aller Signale. Fügen Sie ein Signal durch Ziehen, Doppelklick oder Enter in ein Diagramm ein.</translation>
    </message>
    <message>
        <source>New plot page</source>
        <translation>Neue Diagrammseite</translation>
    </message>
    <message>
        <source>Adds an empty page at the end. All pages share the time axis.</source>
        <translation>Fügt am Ende eine leere Seite hinzu. Alle Seiten haben dieselbe Zeitachse.</translation>
    </message>
    <message>
        <source>Show the entire history</source>
        <translation>Gesamten Verlauf anzeigen</translation>
    </message>
    <message>
        <source>Shows all data in memory and scales each plot automatically.</source>
        <translation>Zeigt alle Daten im Speicher und skaliert jedes Diagramm automatisch.</translation>
    </message>
    <message>
        <source>Add note…</source>
        <translation>Notiz hinzufügen…</translation>
    </message>
    <message>
        <source>Adds a note at the selected cursor if it is visible, otherwise at the end of the plots.</source>
        <translation>Fügt eine Notiz am gewählten Cursor hinzu, falls er sichtbar ist, sonst am Ende der Diagramme.</translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation>%1 zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation>%1 lösen</translation>
    </message>
    <message>
        <source>Moves the panel to a separate window, e.g. on a second screen, or back to the main window.</source>
        <translation>Verschiebt den Bereich in ein eigenes Fenster, z. B. für einen zweiten Bildschirm, oder zurück.</translation>
    </message>
    <message>
        <source>Moves the panel to this side of the main window.</source>
        <translation>Verschiebt diesen Bereich auf diese Seite des Hauptfensters.</translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation>Standard-Diagramme zeigen</translation>
    </message>
    <message>
        <source>Replaces the pages of live data with the standard page. Pages with recordings are kept.</source>
        <translation>Ersetzt die Seiten mit Live-Daten durch die Standardseite. Seiten mit Aufzeichnungen bleiben.</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Aufzeichnung öffnen…</translation>
    </message>
    <message>
        <source>Shows a recording or a table of another program on its own page.</source>
        <translation>Zeigt eine Aufzeichnung oder eine Tabelle eines anderen Programms auf einer eigenen Seite.</translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation>Aufzeichnungen schließen</translation>
    </message>
    <message>
        <source>Removes all opened recordings from the plots. The files are kept.</source>
        <translation>Entfernt alle geöffneten Aufzeichnungen aus den Diagrammen. Die Dateien bleiben.</translation>
    </message>
    <message>
        <source>No recording is open.</source>
        <translation>Es ist keine Aufzeichnung geöffnet.</translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation>Mit dem Modell des Arms vergleichen…</translation>
    </message>
    <message>
        <source>Compares the displayed recording with the model of its arm.</source>
        <translation>Vergleicht die angezeigte Aufzeichnung mit dem Modell ihres Arms.</translation>
    </message>
    <message>
        <source>Show the page of a recording first.</source>
        <translation>Zeigen Sie zuerst die Seite einer Aufzeichnung.</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>Werte an den Cursorn</translation>
    </message>
    <message>
        <source>Shows or hides the table of values at the cursors and between them.</source>
        <translation>Zeigt oder verbirgt die Tabelle der Werte an den Cursorn und zwischen ihnen.</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>Spektrum und XY</translation>
    </message>
    <message>
        <source>Shows or hides the spectrum and the XY plot of two signals.</source>
        <translation>Zeigt oder verbirgt das Spektrum und das XY-Diagramm zweier Signale.</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 nach links</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 nach rechts</translation>
    </message>
    <message>
        <source>%1 to the top</source>
        <translation>%1 nach oben</translation>
    </message>
    <message>
        <source>%1 to the bottom</source>
        <translation>%1 nach unten</translation>
    </message>
    <message>
        <source>Plots: start or stop playback</source>
        <translation>Diagramme: Wiedergabe starten oder beenden</translation>
    </message>
    <message>
        <source>Moves cursor A in real time through the recording or the paused plots. The Layout menu contains other speeds.</source>
        <translation>Bewegt Cursor A in Echtzeit durch die Aufzeichnung oder die pausierten Diagramme. Das Menü „Layout“ enthält weitere Geschwindigkeiten.</translation>
    </message>
</context>
<context>
    <name>PlotMenu</name>
    <message>
        <source>Remove lane %1</source>
        <translation>Spur %1 entfernen</translation>
    </message>
    <message>
        <source>Add note here…</source>
        <translation>Hier Notiz hinzufügen…</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 verbergen</translation>
    </message>
    <message>
        <source>Show values of %1 at the cursors</source>
        <translation>Werte von %1 an den Cursorn anzeigen</translation>
    </message>
    <message>
        <source>Move %1 to a separate plot</source>
        <translation>%1 in ein eigenes Diagramm</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Warn when %1</source>
        <translation>Warnen, wenn %1</translation>
    </message>
    <message>
        <source>Do not warn when %1</source>
        <translation>Nicht warnen, wenn %1</translation>
    </message>
    <message>
        <source>Rate of change of %1</source>
        <translation>Änderungsrate von %1</translation>
    </message>
    <message>
        <source>Moving mean of %1 over 0.5 s</source>
        <translation>Gleitender Mittelwert von %1 über 0,5 s</translation>
    </message>
    <message>
        <source>Mean %1</source>
        <translation>Mittel %1</translation>
    </message>
    <message>
        <source>Norm of the curves in this plot</source>
        <translation>Betrag der Kurven dieses Diagramms</translation>
    </message>
    <message>
        <source>New plot below</source>
        <translation>Neues Diagramm darunter</translation>
    </message>
    <message>
        <source>New plot to the right</source>
        <translation>Neues Diagramm rechts</translation>
    </message>
    <message>
        <source>Remove this plot</source>
        <translation>Dieses Diagramm entfernen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Low-pass filter of %1 at 10 Hz</source>
        <translation>Tiefpassfilter von %1 bei 10 Hz</translation>
    </message>
    <message>
        <source>Filtered %1</source>
        <translation>%1 gefiltert</translation>
    </message>
    <message>
        <source>Left axis</source>
        <translation>Linke Achse</translation>
    </message>
    <message>
        <source>Right axis</source>
        <translation>Rechte Achse</translation>
    </message>
    <message>
        <source>Edit %1…</source>
        <translation>%1 bearbeiten…</translation>
    </message>
    <message>
        <source>Axis limits…</source>
        <translation>Achsengrenzen…</translation>
    </message>
    <message>
        <source>Scale to curves</source>
        <translation>An Kurven anpassen</translation>
    </message>
</context>
<context>
    <name>PlotPane</name>
    <message>
        <source>%1 (right)</source>
        <translation>%1 (rechts)</translation>
    </message>
</context>
<context>
    <name>Practice</name>
    <message>
        <source>Waiting for the protective stop.</source>
        <translation>Warten auf den Schutzstopp.</translation>
    </message>
    <message>
        <source>The arm is in a protective stop. Press “Recover…” in the header.</source>
        <translation>Der Arm ist in einem Schutzstopp. Drücken Sie „Wiederherstellen…“ in der Kopfzeile.</translation>
    </message>
    <message>
        <source>Unlocked. The arm is not running yet: follow the steps on the recovery page.</source>
        <translation>Entriegelt. Der Arm läuft noch nicht: Folgen Sie den Schritten auf der Seite Wiederherstellung.</translation>
    </message>
    <message>
        <source>Unlocked. Take control again.</source>
        <translation>Entriegelt. Übernehmen Sie wieder die Steuerung.</translation>
    </message>
    <message>
        <source>The arm is running and under your control again.</source>
        <translation>Der Arm läuft und wird wieder von Ihnen gesteuert.</translation>
    </message>
    <message>
        <source>No new frame yet. Use “3 points” in the Frames tab.</source>
        <translation>Noch kein neues Koordinatensystem. Verwenden Sie „3 Punkte“ im Register Koordinatensysteme.</translation>
    </message>
    <message>
        <source>“%1” meets the requirements.</source>
        <translation>„%1“ erfüllt die Anforderungen.</translation>
    </message>
    <message>
        <source>The Z axis of “%1” differs from the base Z axis by %2°. The third point must be on the +Y side.</source>
        <translation>Die Z-Achse von „%1“ weicht um %2° von der Z-Achse der Basis ab. Der dritte Punkt muss auf der Seite +Y liegen.</translation>
    </message>
    <message>
        <source>The X axis of “%1” differs from the base Y axis by %2°.</source>
        <translation>Die X-Achse von „%1“ weicht um %2° von der Y-Achse der Basis ab.</translation>
    </message>
    <message>
        <source>“%1” was not taught with the arm: the TCP was never at its origin.</source>
        <translation>„%1“ wurde nicht mit dem Arm geteacht: Der TCP war nie an seinem Ursprung.</translation>
    </message>
    <message>
        <source>The waypoint was deleted. Press “Start” to add a new waypoint.</source>
        <translation>Der Wegpunkt wurde gelöscht. Drücken Sie „Start“, um einen neuen hinzuzufügen.</translation>
    </message>
    <message>
        <source>“%1” has not changed. The arm is %2 away from the waypoint along X.</source>
        <translation>„%1“ wurde nicht geändert. Der Arm ist entlang X %2 davon entfernt.</translation>
    </message>
    <message>
        <source>“%1” has moved by %2 and is %3 from the expected position.</source>
        <translation>„%1“ wurde um %2 verschoben und ist %3 von der erwarteten Position entfernt.</translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the tool orientation changed.</source>
        <translation>„%1“ ist an der erwarteten Position, aber die Werkzeugorientierung hat sich geändert.</translation>
    </message>
    <message>
        <source>“%1” matches the part again.</source>
        <translation>„%1“ stimmt wieder mit dem Teil überein.</translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the arm is not. Touch up the waypoint with the arm at the part.</source>
        <translation>„%1“ ist an der erwarteten Position, der Arm aber nicht. Teachen Sie den Wegpunkt nach, während der Arm am Teil ist.</translation>
    </message>
    <message>
        <source>Slowed down to %1. Continue.</source>
        <translation>Auf %1 verlangsamt. Fahren Sie weiter.</translation>
    </message>
    <message>
        <source>No limit reached yet. The line below the pad will show the limit.</source>
        <translation>Noch keine Grenze erreicht. Die Zeile unter dem Tastenfeld zeigt sie an.</translation>
    </message>
    <message>
        <source>Limit reached. Now jog back: %1 of %2.</source>
        <translation>Grenze erreicht. Fahren Sie nun zurück: %1 von %2.</translation>
    </message>
    <message>
        <source>You reached the limit and moved back.</source>
        <translation>Sie haben die Grenze erreicht und wieder verlassen.</translation>
    </message>
    <message>
        <source>Recording: %1 s of %2 s.</source>
        <translation>Aufzeichnung: %1 s von %2 s.</translation>
    </message>
    <message>
        <source>The recording is too short. Record for at least three seconds.</source>
        <translation>Die Aufzeichnung ist zu kurz. Zeichnen Sie mindestens drei Sekunden lang auf.</translation>
    </message>
    <message>
        <source>No recording yet. Press “Record” above the plots.</source>
        <translation>Noch keine Aufzeichnung. Drücken Sie „Aufzeichnen“ über den Diagrammen.</translation>
    </message>
    <message>
        <source>Recorded. Enter the force shown in the plot.</source>
        <translation>Aufgezeichnet. Geben Sie die Kraft ein, die das Diagramm zeigt.</translation>
    </message>
    <message>
        <source>%1 does not match the recording. Look at the Fz curve.</source>
        <translation>%1 stimmt nicht mit der Aufzeichnung überein. Betrachten Sie die Kurve Fz.</translation>
    </message>
    <message>
        <source>Correct: the force was %1.</source>
        <translation>Richtig: Die Kraft betrug %1.</translation>
    </message>
    <message>
        <source>Recover from a protective stop</source>
        <translation>Aus einem Schutzstopp wiederherstellen</translation>
    </message>
    <message>
        <source>Teach a frame</source>
        <translation>Ein Koordinatensystem teachen</translation>
    </message>
    <message>
        <source>Touch up a waypoint</source>
        <translation>Einen Wegpunkt nachteachen</translation>
    </message>
    <message>
        <source>Find the reach limit</source>
        <translation>Die Grenze der Reichweite finden</translation>
    </message>
    <message>
        <source>Record and measure</source>
        <translation>Aufzeichnen und messen</translation>
    </message>
    <message>
        <source>Press “Start” to simulate a collision that causes a protective stop. Find out what stopped the arm, wait five seconds, unlock the arm and take control again.</source>
        <translation>Drücken Sie „Start“, um eine Kollision mit Schutzstopp zu simulieren. Finden Sie heraus, was den Arm gestoppt hat, warten Sie fünf Sekunden, entriegeln Sie ihn und übernehmen Sie wieder die Steuerung.</translation>
    </message>
    <message>
        <source>Teach a frame from three points in the Frames tab. Its X axis must point along the base Y+ direction and its Z axis up: record the origin, then a point further along Y+, then a point further along X−.</source>
        <translation>Teachen Sie im Register Koordinatensysteme ein Koordinatensystem aus drei Punkten. Seine X-Achse muss entlang Y+ der Basis zeigen, seine Z-Achse nach oben: Nehmen Sie den Ursprung, dann einen Punkt weiter in Y+, dann einen Punkt weiter in X−.</translation>
    </message>
    <message>
        <source>Press “Start” to add a waypoint “part” at the current position of the arm. The part then moves by %1 along the base X+ direction. Jog to the part, select the waypoint and touch it up (U).</source>
        <translation>Drücken Sie „Start“, um an der aktuellen Position des Arms einen Wegpunkt „Teil“ hinzuzufügen. Danach verschiebt sich das Teil um %1 in X+ der Basis. Fahren Sie dorthin, wählen Sie den Wegpunkt und teachen Sie ihn nach (U).</translation>
    </message>
    <message>
        <source>Jog outwards, away from the base, until a limit halves the speed. The line below the pad shows the limit and how to move away from it. Then jog back by %1.</source>
        <translation>Fahren Sie nach außen, weg von der Basis, bis eine Grenze die Geschwindigkeit halbiert. Die Zeile unter dem Tastenfeld nennt die Grenze und wie Sie sie verlassen. Fahren Sie dann um %1 zurück.</translation>
    </message>
    <message>
        <source>Press “Start” to simulate a hand pressing on the tool from above. Record for at least three seconds, then stop. Read the force Fz in the plots and enter the value.</source>
        <translation>Drücken Sie „Start“, um eine Hand zu simulieren, die von oben auf das Werkzeug drückt. Zeichnen Sie mindestens drei Sekunden auf und beenden Sie die Aufzeichnung. Lesen Sie die Kraft Fz in den Diagrammen ab und geben Sie sie ein.</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
</context>
<context>
    <name>ProgramText</name>
    <message>
        <source>Maximum distance</source>
        <translation>Maximaler Weg</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>Fehlschlagen</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortfahren</translation>
    </message>
    <message>
        <source>“%1” is %2. The value must be between %3 and %4.</source>
        <translation>„%1“ ist %2; der Wert muss zwischen %3 und %4 liegen.</translation>
    </message>
    <message>
        <source>The group “%1” contains no waypoints. Add waypoints to the group, or select a different group.</source>
        <translation>Die Gruppe „%1“ enthält keine Wegpunkte. Fügen Sie der Gruppe Wegpunkte hinzu oder wählen Sie eine andere Gruppe.</translation>
    </message>
    <message>
        <source>“%1” refers to an item that was deleted from the project. Select a different item.</source>
        <translation>„%1“ verweist auf ein Element, das aus dem Projekt gelöscht wurde. Wählen Sie ein anderes Element.</translation>
    </message>
    <message>
        <source>“%1” must come directly after “%2”.</source>
        <translation>„%1“ muss direkt nach „%2“ stehen.</translation>
    </message>
    <message>
        <source>“%1” must be inside “%2”.</source>
        <translation>„%1“ muss innerhalb von „%2“ stehen.</translation>
    </message>
    <message>
        <source>Steps in “Watch in parallel” cannot move the arm. Move this step out of the section.</source>
        <translation>Schritte in „Parallel überwachen“ können den Arm nicht bewegen. Verschieben Sie diesen Schritt aus dem Abschnitt heraus.</translation>
    </message>
    <message>
        <source>This version of Tiller does not support the step “%1”. Update Tiller, or delete the step.</source>
        <translation>Diese Version von Tiller unterstützt den Schritt „%1“ nicht. Aktualisieren Sie Tiller oder löschen Sie den Schritt.</translation>
    </message>
    <message>
        <source>A program can start only at a top-level step, and not at a branch such as Else. Select a different step.</source>
        <translation>Ein Programm kann nur an einem Schritt der obersten Ebene beginnen, nicht an einem Zweig wie „Sonst“. Wählen Sie einen anderen Schritt.</translation>
    </message>
    <message>
        <source>The project does not contain this program. Select a different program.</source>
        <translation>Das Projekt enthält dieses Programm nicht. Wählen Sie ein anderes Programm.</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a %2. Use “Adapt project to this robot…” first.</source>
        <translation>Das Projekt wurde mit einem %1 geteacht, aber der Roboter ist ein %2. Verwenden Sie zuerst „Projekt an diesen Roboter anpassen…“.</translation>
    </message>
    <message>
        <source>A program with parameters cannot be started directly. Use a “Call program” step in another program.</source>
        <translation>Ein Programm mit Parametern kann nicht direkt gestartet werden. Verwenden Sie in einem anderen Programm einen Schritt, der es aufruft.</translation>
    </message>
    <message>
        <source>The program has no steps. Add steps first.</source>
        <translation>Das Programm hat keine Schritte. Fügen Sie zuerst Schritte hinzu.</translation>
    </message>
    <message>
        <source>The variable “%1” has a different type elsewhere in the program. Use the same type or a different name.</source>
        <translation>Die Variable „%1“ hat an anderer Stelle im Programm einen anderen Typ. Verwenden Sie denselben Typ oder einen anderen Namen.</translation>
    </message>
    <message>
        <source>Program calls are nested too deeply. Use fewer levels of calls.</source>
        <translation>Die Programmaufrufe sind zu tief verschachtelt. Verwenden Sie weniger Aufrufebenen.</translation>
    </message>
    <message>
        <source>“%1” was taught with a different TCP than the waypoints before it. Set the active TCP, or put the step in a TCP section.</source>
        <translation>„%1“ wurde mit einem anderen TCP geteacht als die vorherigen Wegpunkte. Setzen Sie den aktiven TCP, oder setzen Sie den Schritt in einen TCP-Abschnitt.</translation>
    </message>
    <message>
        <source>The blend radii of this move and the previous move (%1 and %2) exceed the distance of %3 between the two targets. Reduce a blend radius.</source>
        <translation>Die Überschleifradien dieser und der vorherigen Bewegung (%1 und %2) überschreiten den Abstand von %3 zwischen den beiden Zielen. Verringern Sie einen Radius.</translation>
    </message>
    <message>
        <source>The expression is empty. Enter an expression.</source>
        <translation>Der Ausdruck ist leer. Geben Sie einen Ausdruck ein.</translation>
    </message>
    <message>
        <source>An expression must be a single line.</source>
        <translation>Ein Ausdruck muss eine einzige Zeile sein.</translation>
    </message>
    <message>
        <source>“%1” is not a valid variable name. Use letters, digits and underscores, and do not start with a digit.</source>
        <translation>„%1“ ist kein gültiger Variablenname. Verwenden Sie Buchstaben, Ziffern und Unterstriche, und beginnen Sie nicht mit einer Ziffer.</translation>
    </message>
    <message>
        <source>The name “%1” is reserved. Use a different name.</source>
        <translation>Der Name „%1“ ist reserviert. Verwenden Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The arm comes too close to itself.</source>
        <translation>Der Arm kommt sich selbst zu nahe.</translation>
    </message>
    <message>
        <source>The arm comes too close to “%1”.</source>
        <translation>Der Arm kommt „%1“ zu nahe.</translation>
    </message>
    <message>
        <source>The arm comes too close to the floor.</source>
        <translation>Der Arm kommt dem Boden zu nahe.</translation>
    </message>
    <message>
        <source>The step failed and ended the program.</source>
        <translation>Der Schritt ist fehlgeschlagen und hat das Programm beendet.</translation>
    </message>
    <message>
        <source>The program did not end within %1 s.</source>
        <translation>Das Programm endete nicht innerhalb von %1 s.</translation>
    </message>
    <message>
        <source>The preview was cancelled.</source>
        <translation>Die Vorschau wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Ein- und Ausgänge</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Warten</translation>
    </message>
    <message>
        <source>Tool and speed</source>
        <translation>Werkzeug und Geschwindigkeit</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Ablauf</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variablen</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Set variable</source>
        <translation>Variable setzen</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>Ganze Zahl</translation>
    </message>
    <message>
        <source>True or false</source>
        <translation>Wahr oder falsch</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Call program</source>
        <translation>Programm aufrufen</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Parameter values</source>
        <translation>Parameterwerte</translation>
    </message>
    <message>
        <source>The program “%1” requires %2 comma-separated values, but the step passes %3.</source>
        <translation>Das Programm „%1“ erfordert %2 durch Kommas getrennte Werte, aber der Schritt übergibt %3.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>“Default” must be the last branch of a Switch.</source>
        <translation>„Standard“ muss der letzte Teil einer Auswahl sein.</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Else if</source>
        <translation>Sonst wenn</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Else</source>
        <translation>Sonst</translation>
    </message>
    <message>
        <source>End program</source>
        <translation>Programm beenden</translation>
    </message>
    <message>
        <source>The program failed.</source>
        <translation>Das Programm ist fehlgeschlagen.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>For each pattern cell</source>
        <translation>Für jeden Musterplatz</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>For each waypoint</source>
        <translation>Für jeden Wegpunkt</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Force section</source>
        <translation>Kraft-Abschnitt</translation>
    </message>
    <message>
        <source>Reference frame</source>
        <translation>Bezugssystem</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Section frame</source>
        <translation>Koordinatensystem des Abschnitts</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Geschwindigkeitsgrenze</translation>
    </message>
    <message>
        <source>Frame section</source>
        <translation>Koordinatensystem-Abschnitt</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Koordinatensystem</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation>Ausgang zum Schließen</translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation>Ausgang zum Öffnen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Input to check</source>
        <translation>Eingang prüfen</translation>
    </message>
    <message>
        <source>If the input is off</source>
        <translation>Wenn der Eingang aus ist</translation>
    </message>
    <message>
        <source>Select different outputs for opening and closing.</source>
        <translation>Wählen Sie für Öffnen und Schließen verschiedene Ausgänge.</translation>
    </message>
    <message>
        <source>The gripper is not holding an object.</source>
        <translation>Der Greifer hält kein Objekt.</translation>
    </message>
    <message>
        <source>If</source>
        <translation>Wenn</translation>
    </message>
    <message>
        <source>Exit loop</source>
        <translation>Schleife verlassen</translation>
    </message>
    <message>
        <source>“Exit loop” must be inside a loop.</source>
        <translation>„Schleife verlassen“ muss in einer Schleife stehen.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Repetitions (0: endless)</source>
        <translation>Wiederholungen (0: endlos)</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>Zähler</translation>
    </message>
    <message>
        <source>This loop may never end and contains no delay. Add a Wait step.</source>
        <translation>Diese Schleife endet eventuell nie und enthält keine Wartezeit. Fügen Sie einen Schritt „Warten“ hinzu.</translation>
    </message>
    <message>
        <source>A loop can have 1 to %1 positions; this loop has %2.</source>
        <translation>Eine Schleife kann 1 bis %1 Positionen haben; diese hat %2.</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Wait for the operator</source>
        <translation>Auf Bediener warten</translation>
    </message>
    <message>
        <source>MoveC</source>
        <translation>MoveC</translation>
    </message>
    <message>
        <source>Via</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überschleifen</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Fixed to arc</source>
        <translation>Fest am Bogen</translation>
    </message>
    <message>
        <source>Move through a group</source>
        <translation>Gruppe durchfahren</translation>
    </message>
    <message>
        <source>Run waypoint actions</source>
        <translation>Wegpunktaktionen ausführen</translation>
    </message>
    <message>
        <source>MoveJ</source>
        <translation>MoveJ</translation>
    </message>
    <message>
        <source>MoveL</source>
        <translation>MoveL</translation>
    </message>
    <message>
        <source>MoveP</source>
        <translation>MoveP</translation>
    </message>
    <message>
        <source>Relative move</source>
        <translation>Relative Bewegung</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>The distance is zero. Enter a value for X, Y or Z.</source>
        <translation>Die Strecke ist null. Geben Sie einen Wert für X, Y oder Z ein.</translation>
    </message>
    <message>
        <source>The waypoint “%1” moves the gripper. In a program, use the Gripper step and turn off “Run waypoint actions”.</source>
        <translation>Der Wegpunkt „%1“ bewegt den Greifer. Verwenden Sie im Programm den Schritt „Greifer“ und schalten Sie „Wegpunktaktionen ausführen“ aus.</translation>
    </message>
    <message>
        <source>Waypoint</source>
        <translation>Wegpunkt</translation>
    </message>
    <message>
        <source>Approach distance</source>
        <translation>Anfahrabstand</translation>
    </message>
    <message>
        <source>The arm cannot reach “%1”. Change the waypoint, or select a different waypoint.</source>
        <translation>Der Arm kann „%1“ nicht erreichen. Ändern Sie den Wegpunkt oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>Set either a waypoint or a pose, not both.</source>
        <translation>Setzen Sie einen Wegpunkt oder eine Pose, nicht beides.</translation>
    </message>
    <message>
        <source>Set a waypoint or a pose.</source>
        <translation>Setzen Sie einen Wegpunkt oder eine Pose.</translation>
    </message>
    <message>
        <source>Move until</source>
        <translation>Bewegen bis</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Input is on</source>
        <translation>Eingang ist ein</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>If not reached</source>
        <translation>Wenn nicht erreicht</translation>
    </message>
    <message>
        <source>Select an input.</source>
        <translation>Wählen Sie einen Eingang.</translation>
    </message>
    <message>
        <source>The input did not turn on within the maximum distance. Check the sensor and its wiring.</source>
        <translation>Der Eingang wurde innerhalb des maximalen Wegs nicht eingeschaltet. Prüfen Sie den Sensor und seine Verdrahtung.</translation>
    </message>
    <message>
        <source>No contact was detected within the maximum distance.</source>
        <translation>Innerhalb des maximalen Wegs wurde kein Kontakt erkannt.</translation>
    </message>
    <message>
        <source>Write to the log</source>
        <translation>In das Protokoll schreiben</translation>
    </message>
    <message>
        <source>On error</source>
        <translation>Bei Fehler</translation>
    </message>
    <message>
        <source>Set payload</source>
        <translation>Nutzlast setzen</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Nutzlast</translation>
    </message>
    <message>
        <source>Pulse output</source>
        <translation>Ausgang pulsen</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Questions require robot software 5.6 or newer.</source>
        <translation>Fragen benötigen Robotersoftware 5.6 oder neuer.</translation>
    </message>
    <message>
        <source>URScript</source>
        <translation>URScript</translation>
    </message>
    <message>
        <source>Names that begin with “tiller_” are reserved.</source>
        <translation>Namen, die mit „tiller_“ beginnen, sind reserviert.</translation>
    </message>
    <message>
        <source>Each block in the script needs an “end”.</source>
        <translation>Jeder Block des Skripts benötigt ein eigenes „end“.</translation>
    </message>
    <message>
        <source>Set analog output</source>
        <translation>Analogausgang setzen</translation>
    </message>
    <message>
        <source>Set output</source>
        <translation>Ausgang setzen</translation>
    </message>
    <message>
        <source>Set register</source>
        <translation>Register setzen</translation>
    </message>
    <message>
        <source>Integer</source>
        <translation>Integer</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Float</translation>
    </message>
    <message>
        <source>Boolean</source>
        <translation>Boolean</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Programs can set registers only up to %1.</source>
        <translation>Programme können Register bis %1 setzen.</translation>
    </message>
    <message>
        <source>Speed section</source>
        <translation>Geschwindigkeits-Abschnitt</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>A Switch must contain at least one Case.</source>
        <translation>Eine Auswahl muss mindestens einen Fall enthalten.</translation>
    </message>
    <message>
        <source>Only Case and Default can be placed directly in a Switch.</source>
        <translation>Eine Auswahl kann direkt nur „Fall“ und „Standard“ enthalten.</translation>
    </message>
    <message>
        <source>TCP section</source>
        <translation>TCP-Abschnitt</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Versuchen</translation>
    </message>
    <message>
        <source>“Try” must be followed directly by “On error”.</source>
        <translation>Nach „Versuchen“ muss direkt „Bei Fehler“ folgen.</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Warten</translation>
    </message>
    <message>
        <source>Wait for condition</source>
        <translation>Auf Bedingung warten</translation>
    </message>
    <message>
        <source>On timeout</source>
        <translation>Bei Zeitüberschreitung</translation>
    </message>
    <message>
        <source>The condition did not become true before the timeout.</source>
        <translation>Die Bedingung wurde nicht rechtzeitig wahr.</translation>
    </message>
    <message>
        <source>Wait for input</source>
        <translation>Auf Eingang warten</translation>
    </message>
    <message>
        <source>%1 did not change to the expected state before the timeout.</source>
        <translation>%1 hat den erwarteten Zustand nicht vor Ablauf der Zeit erreicht.</translation>
    </message>
    <message>
        <source>Watch in parallel</source>
        <translation>Parallel überwachen</translation>
    </message>
    <message>
        <source>A parallel watch must be at the top level of the program.</source>
        <translation>Eine parallele Überwachung muss auf der obersten Ebene des Programms stehen.</translation>
    </message>
    <message>
        <source>While</source>
        <translation>Solange</translation>
    </message>
    <message>
        <source>At %1 s: %2</source>
        <translation>Nach %1 s: %2</translation>
    </message>
    <message>
        <source>Step %1 (%2) at %3 s: %4</source>
        <translation>Schritt %1 (%2) nach %3 s: %4</translation>
    </message>
    <message>
        <source>“%1” must be between %2 and %3.</source>
        <translation>„%1“ muss zwischen %2 und %3 liegen.</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>The TCP of the robot differs from the TCP of the program&apos;s waypoints. Set the active TCP of the project, or use a TCP section.</source>
        <translation>Der TCP des Roboters weicht vom TCP der Wegpunkte des Programms ab. Legen Sie den aktiven TCP des Projekts fest oder verwenden Sie einen TCP-Abschnitt.</translation>
    </message>
    <message>
        <source>Preview the program first.</source>
        <translation>Zeigen Sie zuerst die Vorschau des Programms an.</translation>
    </message>
    <message>
        <source>The preview found problems. Fix them, then preview the program again.</source>
        <translation>Die Vorschau hat Probleme gefunden. Beheben Sie diese und starten Sie die Vorschau erneut.</translation>
    </message>
    <message>
        <source>Move the arm to the start position first.</source>
        <translation>Fahren Sie den Arm zuerst zur Startposition.</translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation>Ein Programm läuft. Halten Sie zuerst das Programm an.</translation>
    </message>
    <message>
        <source>The program ended after %1 s.</source>
        <translation>Das Programm endete nach %1 s.</translation>
    </message>
    <message>
        <source>Step %1 (%2) failed and ended the program.</source>
        <translation>Schritt %1 (%2) ist fehlgeschlagen und hat das Programm beendet.</translation>
    </message>
    <message>
        <source>Stopped in step %1 (%2): %3</source>
        <translation>Angehalten in Schritt %1 (%2): %3</translation>
    </message>
    <message>
        <source>Stopped before the first step: %1</source>
        <translation>Vor dem ersten Schritt angehalten: %1</translation>
    </message>
    <message>
        <source>Later steps use the variable “%1” from step %2 (%3). Start at that step or earlier.</source>
        <translation>Spätere Schritte verwenden die Variable „%1“ aus Schritt %2 (%3). Beginnen Sie bei diesem Schritt oder davor.</translation>
    </message>
    <message>
        <source>Later steps depend on step %1 (%2). Start at that step or earlier.</source>
        <translation>Spätere Schritte benötigen Schritt %1 (%2). Beginnen Sie bei diesem Schritt oder davor.</translation>
    </message>
    <message>
        <source>The preview does not reach this step. Select a different step.</source>
        <translation>Die Vorschau erreicht diesen Schritt nicht. Wählen Sie einen anderen Schritt.</translation>
    </message>
    <message>
        <source>The simulated program does not complete step %1 (%2).</source>
        <translation>Das simulierte Programm schließt Schritt %1 (%2) nicht ab.</translation>
    </message>
    <message>
        <source>The arm has left the start position of step %1 (%2).</source>
        <translation>Der Arm hat die Startposition von Schritt %1 (%2) verlassen.</translation>
    </message>
    <message>
        <source>The gripper may hold a part and would close again (%1).</source>
        <translation>Der Greifer hält möglicherweise ein Teil und würde erneut schließen (%1).</translation>
    </message>
    <message>
        <source>The gripper may have lost a part (%1).</source>
        <translation>Der Greifer hat möglicherweise ein Teil verloren (%1).</translation>
    </message>
    <message>
        <source>%1 would turn on again.</source>
        <translation>%1 würde erneut eingeschaltet.</translation>
    </message>
    <message>
        <source>%1 would have a different value.</source>
        <translation>%1 hätte einen anderen Wert.</translation>
    </message>
    <message>
        <source>The program would wait in step %1 (%2).</source>
        <translation>Das Programm würde in Schritt %1 (%2) warten.</translation>
    </message>
    <message>
        <source>The program would fail in step %1 (%2).</source>
        <translation>Das Programm würde in Schritt %1 (%2) fehlschlagen.</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>Die Prüfung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>An analog output would have a different value.</source>
        <translation>Ein Analogausgang hätte einen anderen Wert.</translation>
    </message>
    <message>
        <source>A register would have a different value.</source>
        <translation>Ein Register hätte einen anderen Wert.</translation>
    </message>
    <message>
        <source>The variable “%1” would have a different value.</source>
        <translation>Die Variable „%1“ hätte einen anderen Wert.</translation>
    </message>
    <message>
        <source>The TCP or the payload would differ.</source>
        <translation>TCP oder Nutzlast wären anders.</translation>
    </message>
    <message>
        <source>The program would run different steps.</source>
        <translation>Das Programm würde andere Schritte ausführen.</translation>
    </message>
    <message>
        <source>The arm would end at a different position.</source>
        <translation>Der Arm würde an einer anderen Position enden.</translation>
    </message>
    <message>
        <source>✔ Continue</source>
        <translation>✔ Fortsetzen</translation>
    </message>
    <message>
        <source>↩ Move back</source>
        <translation>↩ Zurückfahren</translation>
    </message>
    <message>
        <source>✖ Unsafe</source>
        <translation>✖ Unsicher</translation>
    </message>
    <message>
        <source>Simulated, after a stop in this step:</source>
        <translation>Simuliert, nach einem Stopp in diesem Schritt:</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>nicht erreicht</translation>
    </message>
    <message>
        <source>can continue</source>
        <translation>kann fortgesetzt werden</translation>
    </message>
    <message>
        <source>can continue after moving back</source>
        <translation>nach Zurückfahren fortsetzbar</translation>
    </message>
    <message>
        <source>cannot continue safely</source>
        <translation>nicht sicher fortsetzbar</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>Schutzstopp</translation>
    </message>
    <message>
        <source>Stop by the operator</source>
        <translation>Stopp durch den Bediener</translation>
    </message>
    <message>
        <source>Connection loss</source>
        <translation>Verbindungsverlust</translation>
    </message>
    <message>
        <source>Power loss</source>
        <translation>Stromausfall</translation>
    </message>
    <message>
        <source>Simulated: the program cannot continue safely. %1</source>
        <translation>Simuliert: Das Programm kann nicht sicher fortgesetzt werden. %1</translation>
    </message>
    <message>
        <source>Simulated: the program can continue from step %1 (%2).</source>
        <translation>Simuliert: Das Programm kann ab Schritt %1 (%2) fortgesetzt werden.</translation>
    </message>
    <message>
        <source>The stop was inside a force section, so the contact cannot be restored.</source>
        <translation>Der Stopp lag in einem Kraft-Abschnitt, daher kann der Kontakt nicht wiederhergestellt werden.</translation>
    </message>
    <message>
        <source>The relative move is only partly complete.</source>
        <translation>Die relative Bewegung ist teilweise ausgeführt.</translation>
    </message>
    <message>
        <source>The URScript text was only partly executed.</source>
        <translation>Der URScript-Text ist teilweise ausgeführt.</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Schweregrad</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>Zeitlimit</translation>
    </message>
    <message>
        <source>A program cannot continue inside a section or a called program. The next run starts from the beginning.</source>
        <translation>Ein Programm kann innerhalb eines Abschnitts oder eines aufgerufenen Programms nicht fortgesetzt werden. Der nächste Start beginnt am Anfang.</translation>
    </message>
    <message>
        <source>A program cannot continue in the middle of this step. The next run starts from the beginning.</source>
        <translation>Ein Programm kann mitten in diesem Schritt nicht fortgesetzt werden. Der nächste Start beginnt am Anfang.</translation>
    </message>
    <message>
        <source>paused on the robot</source>
        <translation>auf dem Roboter pausiert</translation>
    </message>
    <message>
        <source>the speed, acceleration or blend is not a number, or a time is set</source>
        <translation>Geschwindigkeit, Beschleunigung oder Überschleifen ist keine Zahl, oder es ist eine Zeit angegeben</translation>
    </message>
    <message>
        <source>not imported</source>
        <translation>nicht importiert</translation>
    </message>
    <message>
        <source>%1, disabled</source>
        <translation>%1, deaktiviert</translation>
    </message>
    <message>
        <source>the program has no name</source>
        <translation>das Programm hat keinen Namen</translation>
    </message>
    <message>
        <source>the project already has a program &apos;%1&apos;; choose another name</source>
        <translation>das Projekt enthält bereits ein Programm „%1“; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>the file is too large for a program</source>
        <translation>die Datei ist zu groß für ein Programm</translation>
    </message>
    <message>
        <source>the file is not text in UTF-8</source>
        <translation>die Datei ist kein Text in UTF-8</translation>
    </message>
    <message>
        <source>this line ends a block that was not opened</source>
        <translation>diese Zeile schließt einen Block, der nicht geöffnet wurde</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>the program contains a return</source>
        <translation>das Programm enthält ein „return“</translation>
    </message>
    <message>
        <source>the program has too many statements</source>
        <translation>das Programm hat zu viele Anweisungen</translation>
    </message>
    <message>
        <source>the script of the steps does not compile</source>
        <translation>das Skript der Schritte lässt sich nicht übersetzen</translation>
    </message>
    <message>
        <source>the program is too complex</source>
        <translation>das Programm ist zu komplex</translation>
    </message>
    <message>
        <source>the file contains no statements</source>
        <translation>die Datei enthält keine Anweisungen</translation>
    </message>
    <message>
        <source>the file contains %1 functions or parameters, but no statement that calls a function; add the call</source>
        <translation>die Datei enthält %1 Funktionen oder Parameter, aber keine Anweisung, die eine Funktion aufruft; fügen Sie den Aufruf hinzu</translation>
    </message>
    <message>
        <source>the program contains no statements</source>
        <translation>das Programm enthält keine Anweisungen</translation>
    </message>
    <message>
        <source>Installation</source>
        <translation>Installation</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>deaktiviert</translation>
    </message>
    <message>
        <source>In this project, programs begin with the TCP of the tool &apos;%1&apos;.</source>
        <translation>In diesem Projekt beginnen Programme mit dem TCP des Werkzeugs „%1“.</translation>
    </message>
    <message>
        <source>The program does not set the TCP. Its waypoints require the TCP %1.</source>
        <translation>Das Programm setzt den TCP nicht. Seine Wegpunkte erfordern den TCP %1.</translation>
    </message>
    <message>
        <source>the TCP applies until the end of the program</source>
        <translation>der TCP gilt bis zum Ende des Programms</translation>
    </message>
    <message>
        <source>the program does not call this function</source>
        <translation>das Programm ruft diese Funktion nicht auf</translation>
    </message>
    <message>
        <source>imported as a program</source>
        <translation>als Programm importiert</translation>
    </message>
    <message>
        <source>part of a waypoint</source>
        <translation>Teil eines Wegpunkts</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a different model. Adapt the project to the robot first.</source>
        <translation>Das Projekt wurde mit einem %1 geteacht, aber der Roboter ist ein anderes Modell. Passen Sie das Projekt zuerst an den Roboter an.</translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>Simuliert: %1</translation>
    </message>
    <message>
        <source>Step %1 failed and ended the program.</source>
        <translation>Schritt %1 ist fehlgeschlagen und hat das Programm beendet.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>step numbers</comment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>steps %1</source>
        <translation>Schritte %1</translation>
    </message>
    <message>
        <source>The position of the arm is unknown because no robot data arrive. Check the connection to the robot.</source>
        <translation>Die Position des Arms ist unbekannt, weil keine Roboterdaten ankommen. Prüfen Sie die Verbindung zum Roboter.</translation>
    </message>
    <message>
        <source>It is unknown whether the program completed, because robot data were missing at its end. Check the workpiece.</source>
        <translation>Es ist unbekannt, ob das Programm vollständig war, weil am Ende Roboterdaten fehlten. Prüfen Sie das Werkstück.</translation>
    </message>
    <message>
        <source>Last known step: %1 (%2). %3</source>
        <translation>Letzter bekannter Schritt: %1 (%2). %3</translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation>Es läuft kein Programm.</translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation>Das Programm ist auf dem Roboter pausiert. Setzen Sie es am Teach-Pendant fort.</translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation>Pausieren Sie zuerst das Programm.</translation>
    </message>
    <message>
        <source>Wait until the robot has confirmed the new value of “%1”.</source>
        <translation>Warten Sie, bis der Roboter den neuen Wert von „%1“ bestätigt hat.</translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation>„%1“ ist keine Zahl. Geben Sie eine Zahl ein.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number. Enter a number without decimals.</source>
        <translation>„%1“ ist keine ganze Zahl. Geben Sie eine Zahl ohne Nachkommastellen ein.</translation>
    </message>
    <message>
        <source>“%1” is not True or False. Enter one of these values.</source>
        <translation>„%1“ ist nicht True oder False. Geben Sie einen dieser Werte ein.</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>A URScript step in this program could move the arm after a change.</source>
        <translation>Ein URScript-Schritt dieses Programms könnte den Arm nach einer Änderung bewegen.</translation>
    </message>
    <message>
        <source>Only numbers and True or False values can be changed.</source>
        <translation>Nur Zahlen und die Werte True und False können geändert werden.</translation>
    </message>
    <message>
        <source>The program has no variable “%1”.</source>
        <translation>Das Programm hat keine Variable „%1“.</translation>
    </message>
    <message>
        <source>Variable “%1”: %2 → %3</source>
        <translation>Variable „%1“: %2 → %3</translation>
    </message>
    <message>
        <source>The robot did not confirm the new value of “%1”. Check the value in the list.</source>
        <translation>Der Roboter hat den neuen Wert von „%1“ nicht bestätigt. Prüfen Sie den Wert in der Liste.</translation>
    </message>
    <message>
        <source>The robot does not report its variables. Wait until the connection is restored.</source>
        <translation>Der Roboter meldet seine Variablen nicht. Warten Sie, bis die Verbindung wiederhergestellt ist.</translation>
    </message>
    <message>
        <source>The recoverability check did not reach step %1 (%2). Check again with the inputs of the run to find out whether the program can continue.</source>
        <translation>Die Prüfung der Fortsetzbarkeit hat Schritt %1 (%2) nicht erreicht. Prüfen Sie erneut mit den Eingängen des Laufs, ob das Programm fortgesetzt werden kann.</translation>
    </message>
    <message>
        <source>This variable is set by URScript text. Only variables of a “Set variable” step can be changed.</source>
        <translation>Diese Variable wird von URScript-Text gesetzt. Nur Variablen eines Schritts „Variable setzen“ können geändert werden.</translation>
    </message>
    <message>
        <source>“%1” is not set. Select or enter a value.</source>
        <translation>„%1“ ist nicht gesetzt. Wählen Sie einen Wert oder geben Sie ihn ein.</translation>
    </message>
    <message>
        <source>“%1” has an invalid value. Enter a different value.</source>
        <translation>„%1“ hat einen ungültigen Wert. Geben Sie einen anderen Wert ein.</translation>
    </message>
    <message>
        <source>“%1” cannot contain steps. Move its steps to another section.</source>
        <translation>„%1“ kann keine Schritte enthalten. Verschieben Sie die Schritte in einen anderen Abschnitt.</translation>
    </message>
    <message>
        <source>A program cannot call itself. Select a different program.</source>
        <translation>Ein Programm kann sich nicht selbst aufrufen. Wählen Sie ein anderes Programm.</translation>
    </message>
    <message>
        <source>Unexpected character “%1”. Remove this character.</source>
        <translation>Unerwartetes Zeichen „%1“. Entfernen Sie dieses Zeichen.</translation>
    </message>
    <message>
        <source>“%1” cannot be part of an expression. Remove this word.</source>
        <translation>„%1“ kann nicht Teil eines Ausdrucks sein. Entfernen Sie dieses Wort.</translation>
    </message>
    <message>
        <source>The brackets do not match. Add or remove a bracket.</source>
        <translation>Die Klammern passen nicht zusammen. Ergänzen oder entfernen Sie eine Klammer.</translation>
    </message>
    <message>
        <source>a Message step cannot have this title</source>
        <translation>ein Schritt „Meldung“ kann diesen Titel nicht haben</translation>
    </message>
    <message>
        <source>the payload is not given as numbers in the permitted range</source>
        <translation>die Nutzlast ist nicht durch Zahlen im zulässigen Bereich angegeben</translation>
    </message>
    <message>
        <source>the target cannot be stored as a waypoint or as the pose of a step</source>
        <translation>das Ziel kann weder Wegpunkt noch Pose eines Schritts sein</translation>
    </message>
    <message>
        <source>the External Control node runs a script from another computer, which cannot be imported. Remove this node from the program.</source>
        <translation>der Knoten „External Control“ führt ein Skript eines anderen Computers aus, das nicht importiert werden kann. Entfernen Sie diesen Knoten aus dem Programm.</translation>
    </message>
    <message>
        <source>the blocks are nested too deeply</source>
        <translation>die Blöcke sind zu tief verschachtelt</translation>
    </message>
    <message>
        <source>a block extends beyond its node</source>
        <translation>ein Block reicht über seinen Knoten hinaus</translation>
    </message>
    <message>
        <source>the line contains several statements</source>
        <translation>mehrere Anweisungen stehen in einer Zeile</translation>
    </message>
    <message>
        <source>the block that begins on line %1 has no end</source>
        <translation>der Block, der in Zeile %1 beginnt, hat kein Ende</translation>
    </message>
    <message>
        <source>no step corresponds to this statement</source>
        <translation>kein Schritt erzeugt diese Anweisung</translation>
    </message>
    <message>
        <source>The program uses output integer register 46 or 47, to which Tiller writes the number of the running step. Use different registers.</source>
        <translation>Das Programm verwendet das ganzzahlige Ausgangsregister 46 oder 47, in das Tiller die Nummer des laufenden Schritts schreibt. Verwenden Sie andere Register.</translation>
    </message>
    <message>
        <source>a disabled node in a section that is imported as URScript text</source>
        <translation>ein deaktivierter Knoten in einem Teil, der Text ist</translation>
    </message>
    <message>
        <source>the condition cannot be used in a step</source>
        <translation>die Bedingung kann nicht Bedingung eines Schritts sein</translation>
    </message>
    <message>
        <source>no step corresponds to a thread, or to a function with parameters or a result</source>
        <translation>für Funktionen mit Parametern oder Ergebnis und für Threads gibt es keinen Schritt</translation>
    </message>
    <message>
        <source>the type or the scope of the variable cannot be determined</source>
        <translation>Typ oder Gültigkeitsbereich der Variablen ist nicht eindeutig</translation>
    </message>
    <message>
        <source>%1. Save the program on the teach pendant and copy its .script file to the same folder, or change the program.</source>
        <translation>%1. Speichern Sie das Programm am Teach-Pendant und kopieren Sie seine .script-Datei in denselben Ordner, oder ändern Sie das Programm.</translation>
    </message>
    <message>
        <source>The nodes cannot be imported: %1. The script saved by the teach pendant was imported instead.</source>
        <translation>Die Knoten können nicht übersetzt werden: %1. Stattdessen wurde das vom Teach-Pendant gespeicherte Skript importiert.</translation>
    </message>
    <message>
        <source>%1. Complete the program on the teach pendant first.</source>
        <translation>%1. Vervollständigen Sie das Programm zuerst am Teach-Pendant.</translation>
    </message>
    <message>
        <source>ended on the robot (teach pendant, another client or halt)</source>
        <translation>auf dem Roboter beendet (Teach-Pendant, anderer Client oder halt)</translation>
    </message>
    <message>
        <source>a program from another client has taken over</source>
        <translation>ein Programm eines anderen Clients hat übernommen</translation>
    </message>
    <message>
        <source>The values of a program from another client cannot be changed.</source>
        <translation>Die Werte eines Programms eines anderen Clients können nicht geändert werden.</translation>
    </message>
    <message>
        <source>the statement is nested too deeply</source>
        <translation>sie ist zu tief verschachtelt</translation>
    </message>
    <message>
        <source>The program cannot pause before this step. Select a different step.</source>
        <translation>Das Programm kann vor diesem Schritt nicht pausieren. Wählen Sie einen anderen Schritt.</translation>
    </message>
    <message>
        <source>The move is only partly complete.</source>
        <translation>Die Bewegung ist nur teilweise ausgeführt.</translation>
    </message>
</context>
<context>
    <name>ProjectLock</name>
    <message>
        <source>%1 on %2</source>
        <translation>%1 auf %2</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>Prozess %1</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>ein anderes Programm</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>No robot connected. Choose a robot at the top left.</source>
        <translation>Kein Roboter verbunden. Wählen Sie oben links einen.</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Verbinde…</translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically.</source>
        <translation>Keine Daten vom Roboter. Die Verbindung wird automatisch wiederhergestellt.</translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation>Die Daten des Roboters sind verspätet. Warten auf neue Daten.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Übernehme Steuerung…</translation>
    </message>
    <message>
        <source>Not in control. Press “Take control” in the header.</source>
        <translation>Nicht gesteuert. Drücken Sie „Steuerung übernehmen“ in der Kopfzeile.</translation>
    </message>
    <message>
        <source>Robot data are out of date. Wait for new data.</source>
        <translation>Die Daten des Roboters sind veraltet. Warten Sie auf neue Daten.</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>Kein Roboter ist verbunden. Verbinden Sie einen oder probieren Sie den Simulator.</translation>
    </message>
    <message>
        <source>The arm is moving. Stop the arm first, then store the position.</source>
        <translation>Der Arm bewegt sich. Stoppen Sie zuerst den Arm, und speichern Sie dann die Position.</translation>
    </message>
</context>
<context>
    <name>RecordingChoice</name>
    <message>
        <source>A file name must not be empty or begin with a period.</source>
        <translation>Ein Dateiname darf nicht leer sein und nicht mit einem Punkt beginnen.</translation>
    </message>
    <message>
        <source>A file name cannot contain “%1”.</source>
        <translation>Ein Dateiname kann „%1“ nicht enthalten.</translation>
    </message>
    <message>
        <source>This name is too long.</source>
        <translation>Dieser Name ist zu lang.</translation>
    </message>
    <message>
        <source>Not a condition: “%1”. Examples: actual_TCP_force_2 &gt; 20, robot_mode = 7, actual_digital_input_bits:3 = 1, runtime_state changes.</source>
        <translation>Keine Bedingung: „%1“. Beispiele: actual_TCP_force_2 &gt; 20, robot_mode = 7, actual_digital_input_bits:3 = 1, runtime_state changes.</translation>
    </message>
    <message>
        <source>There is no signal “%1”. Vectors have one signal per number, such as actual_q_0.</source>
        <translation>Das Signal „%1“ gibt es nicht. Vektoren haben ein Signal pro Zahl, zum Beispiel actual_q_0.</translation>
    </message>
</context>
<context>
    <name>RecoveryGuide</name>
    <message>
        <source>Safety mode is Normal again</source>
        <translation>Sicherheitsmodus wieder „Normal“</translation>
    </message>
    <message>
        <source>The arm can be moved. Motions interrupted by the stop do not resume. Press the button again for each motion.</source>
        <translation>Der Arm kann bewegt werden. Durch den Stopp unterbrochene Bewegungen werden nicht fortgesetzt: Jede Bewegung erfordert einen neuen Tastendruck.</translation>
    </message>
    <message>
        <source>The arm is ready. Take control to move the arm, or continue on the teach pendant.</source>
        <translation>Der Arm ist bereit. Übernehmen Sie die Steuerung, um ihn zu bewegen, oder fahren Sie am Teach-Pendant fort.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Übernehme Steuerung…</translation>
    </message>
    <message>
        <source>No data from the robot</source>
        <translation>Keine Daten vom Roboter</translation>
    </message>
    <message>
        <source>Waiting for the connection…</source>
        <translation>Warten auf die Verbindung…</translation>
    </message>
    <message>
        <source>I have inspected the arm. No one is touching it, and nothing is trapped.</source>
        <translation>Ich habe den Arm geprüft. Niemand berührt ihn, und nichts ist eingeklemmt.</translation>
    </message>
    <message>
        <source>The cause of the stop is known and has been removed.</source>
        <translation>Die Ursache des Stopps ist bekannt und beseitigt.</translation>
    </message>
    <message>
        <source>Payload and TCP match the mounted tool.</source>
        <translation>Nutzlast und TCP passen zum montierten Werkzeug.</translation>
    </message>
    <message>
        <source>Unlocking is available in %1 s</source>
        <translation>Entsperren möglich in %1 s</translation>
    </message>
    <message>
        <source>I have inspected the arm and the robot&apos;s log, and I know the cause.</source>
        <translation>Ich habe den Arm und das Protokoll des Roboters geprüft und kenne die Ursache.</translation>
    </message>
    <message>
        <source>The cause has been removed, and no one is within reach of the arm.</source>
        <translation>Die Ursache ist beseitigt, und niemand befindet sich im Arbeitsbereich des Arms.</translation>
    </message>
    <message>
        <source>No action is needed in Tiller. This state ends when the cause is removed.</source>
        <translation>In Tiller ist keine Aktion nötig. Der Zustand endet, wenn die Ursache beseitigt ist.</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entriegeln</translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation>Sicherheit neu starten</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>Bremsen lösen</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Steuerung übernehmen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>Replay</name>
    <message>
        <source>REPLAY</source>
        <translation>WIEDERGABE</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>keine Daten</translation>
    </message>
    <message>
        <source>history at %1 s</source>
        <translation>Verlauf bei %1 s</translation>
    </message>
    <message>
        <source>at %1 s in %2</source>
        <translation>bei %1 s in %2</translation>
    </message>
</context>
<context>
    <name>RetracePath</name>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation>Es gibt keine Bahn zum Zurückfahren. Verfahren Sie zuerst den Arm.</translation>
    </message>
</context>
<context>
    <name>RobotActions</name>
    <message>
        <source>Connect to a robot first.</source>
        <translation>Verbinden Sie sich zuerst mit einem Roboter.</translation>
    </message>
    <message>
        <source>Give control back first.</source>
        <translation>Geben Sie zuerst die Steuerung ab.</translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation>Auf dem Roboter läuft kein Programm.</translation>
    </message>
    <message>
        <source>A program is already running.</source>
        <translation>Es läuft bereits ein Programm.</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Verbinden…</translation>
    </message>
    <message>
        <source>Select the simulator, a robot or a project.</source>
        <translation>Wählen Sie den Simulator, einen Roboter oder ein Projekt.</translation>
    </message>
    <message>
        <source>Simulated robot</source>
        <translation>Simulierter Roboter</translation>
    </message>
    <message>
        <source>Starts the simulated robot and connects to it.</source>
        <translation>Startet den simulierten Roboter und verbindet sich mit ihm.</translation>
    </message>
    <message>
        <source>Check the connection…</source>
        <translation>Verbindung prüfen…</translation>
    </message>
    <message>
        <source>Select a robot first.</source>
        <translation>Wählen Sie zuerst einen Roboter.</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Stops Tiller&apos;s motion, then closes the connection.</source>
        <translation>Stoppt die Bewegung von Tiller und trennt dann die Verbindung.</translation>
    </message>
    <message>
        <source>No robot is connected.</source>
        <translation>Kein Roboter ist verbunden.</translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation>Schaltet den Arm ein. Die Bremsen bleiben angezogen.</translation>
    </message>
    <message>
        <source>The arm is powered on or powering on.</source>
        <translation>Der Arm ist eingeschaltet oder wird eingeschaltet.</translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation>Der Arm kann einige Millimeter absacken. Halten Sie Abstand.</translation>
    </message>
    <message>
        <source>Stops programs, engages the brakes and powers the arm off.</source>
        <translation>Stoppt Programme, schließt die Bremsen und schaltet den Arm aus.</translation>
    </message>
    <message>
        <source>The arm is powered off.</source>
        <translation>Der Arm ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation>Wiederherstellen…</translation>
    </message>
    <message>
        <source>Shows the cause of the stop and the recovery steps.</source>
        <translation>Zeigt, was den Arm gestoppt hat, und die Schritte zur Wiederherstellung.</translation>
    </message>
    <message>
        <source>The safety system reports no stop.</source>
        <translation>Das Sicherheitssystem meldet keinen Stopp.</translation>
    </message>
    <message>
        <source>Resets the safety system after a violation or fault. The arm stays powered off.</source>
        <translation>Setzt das Sicherheitssystem nach einer Verletzung oder einem Fehler zurück. Der Arm bleibt ausgeschaltet.</translation>
    </message>
    <message>
        <source>Available only after a safety violation or fault.</source>
        <translation>Nur nach einer Sicherheitsverletzung oder einem Sicherheitsfehler verfügbar.</translation>
    </message>
    <message>
        <source>Closes the popups on the teach pendant.</source>
        <translation>Schließt die Meldungsfenster am Teach-Pendant.</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Steuerung übernehmen</translation>
    </message>
    <message>
        <source>Already in control.</source>
        <translation>Steuerung bereits übernommen.</translation>
    </message>
    <message>
        <source>Give control back</source>
        <translation>Steuerung abgeben</translation>
    </message>
    <message>
        <source>Ends the control program on the robot.</source>
        <translation>Beendet das Steuerprogramm auf dem Roboter.</translation>
    </message>
    <message>
        <source>Not in control.</source>
        <translation>Nicht gesteuert.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Software stop of all motion. Not an emergency stop.</source>
        <translation>Software-Stopp jeder Bewegung. Kein Not-Halt.</translation>
    </message>
    <message>
        <source>Load program…</source>
        <translation>Programm laden…</translation>
    </message>
    <message>
        <source>Loads a program on the robot by name.</source>
        <translation>Lädt ein Programm auf dem Roboter anhand seines Namens.</translation>
    </message>
    <message>
        <source>Starts the loaded program or resumes the paused program. The arm may move immediately.</source>
        <translation>Startet das geladene Programm oder setzt ein pausiertes fort: Der Arm kann sich sofort bewegen.</translation>
    </message>
    <message>
        <source>Pauses the running program.</source>
        <translation>Pausiert das laufende Programm.</translation>
    </message>
    <message>
        <source>Stops the program on the robot.</source>
        <translation>Stoppt das Programm auf dem Roboter.</translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation>Startet das Steuerprogramm auf dem Roboter. Fragt nach, bevor ein anderes Programm gestoppt wird.</translation>
    </message>
    <message>
        <source>Checks the connection between this PC and the robot and suggests fixes.</source>
        <translation>Prüft die Verbindung zwischen diesem PC und dem Roboter und schlägt Abhilfe vor.</translation>
    </message>
</context>
<context>
    <name>RobotOutputs</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Output %1: %2</source>
        <translation>Ausgang %1: %2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>%1: on</source>
        <translation>%1: ein</translation>
    </message>
    <message>
        <source>%1: off</source>
        <translation>%1: aus</translation>
    </message>
    <message>
        <source>Analog output %1: %2 %3</source>
        <translation>Analogausgang %1: %2 %3</translation>
    </message>
    <message>
        <source>Input int register %1</source>
        <translation>Int-Eingangsregister %1</translation>
    </message>
    <message>
        <source>Speed slider: %1 %</source>
        <translation>Geschwindigkeitsregler: %1 %</translation>
    </message>
    <message>
        <source>%1: on for %2 s</source>
        <translation>%1: %2 s lang an</translation>
    </message>
    <message>
        <source>%1: off for %2 s</source>
        <translation>%1: %2 s lang aus</translation>
    </message>
    <message>
        <source>The robot times pulses only while Tiller is in control. Take control first, or switch the output on and off manually.</source>
        <translation>Der Roboter taktet Impulse nur, solange Tiller die Steuerung hat. Übernehmen Sie zuerst die Steuerung, oder schalten Sie den Ausgang von Hand ein und aus.</translation>
    </message>
    <message>
        <source>The robot did not end the pulse on %1 because the program on the robot was stopped or paused. Tiller switches the output off.</source>
        <translation>Der Roboter hat den Impuls von %1 nicht beendet, weil sein Programm gestoppt oder angehalten wurde. Tiller schaltet den Ausgang aus.</translation>
    </message>
    <message>
        <source>Input float register %1</source>
        <translation>Float-Eingangsregister %1</translation>
    </message>
    <message>
        <source>Input bit register %1</source>
        <translation>Bit-Eingangsregister %1</translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation>Geschwindigkeitsregler</translation>
    </message>
    <message>
        <source>The robot cannot time pulses while a program is running. Stop the program first, or switch the output on and off manually.</source>
        <translation>Der Roboter kann keine Impulse zeitlich steuern, während ein Programm läuft. Stoppen Sie zuerst das Programm, oder schalten Sie den Ausgang von Hand ein und aus.</translation>
    </message>
</context>
<context>
    <name>RobotServices</name>
    <message>
        <source>%1 failed. %2</source>
        <translation>%1 ist fehlgeschlagen. %2</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>Bremsen lösen</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>Ausschalten</translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation>Sicherheit neu starten</translation>
    </message>
    <message>
        <source>Close popups</source>
        <translation>Meldungsfenster schließen</translation>
    </message>
    <message>
        <source>Play program</source>
        <translation>Programm abspielen</translation>
    </message>
    <message>
        <source>Pause program</source>
        <translation>Programm pausieren</translation>
    </message>
    <message>
        <source>Stop program</source>
        <translation>Programm stoppen</translation>
    </message>
    <message>
        <source>Protective stop unlocked by the operator</source>
        <translation>Schutzstopp vom Bediener entriegelt</translation>
    </message>
    <message>
        <source>Load program %1</source>
        <translation>Programm %1 laden</translation>
    </message>
    <message>
        <source>The program on the robot was stopped.</source>
        <translation>Das Programm auf dem Roboter wurde gestoppt.</translation>
    </message>
    <message>
        <source>The program on the robot could not be stopped. Stop the program on the teach pendant. %1</source>
        <translation>Das Programm auf dem Roboter konnte nicht gestoppt werden: Stoppen Sie es am Teach-Pendant. %1</translation>
    </message>
    <message>
        <source>The robot was switched to Local control: the motion was stopped and control was given back. Switch the robot to Remote control on the teach pendant, then take control again.</source>
        <translation>Der Roboter wurde auf lokale Steuerung geschaltet: Die Bewegung wurde gestoppt und die Steuerung abgegeben. Schalten Sie ihn am Teach-Pendant auf Fernsteuerung, dann übernehmen Sie wieder die Steuerung.</translation>
    </message>
    <message>
        <source>Unlock protective stop</source>
        <translation>Schutzstopp entriegeln</translation>
    </message>
    <message>
        <source>The robot sends no data, so a stop may not reach the robot. Press the emergency stop if the arm must stop.</source>
        <translation>Der Roboter sendet keine Daten, ein Stopp erreicht ihn möglicherweise nicht. Drücken Sie den Not-Halt, wenn der Arm anhalten muss.</translation>
    </message>
</context>
<context>
    <name>RobotTooling</name>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller hat nicht die Steuerung. Übernehmen Sie zuerst die Steuerung.</translation>
    </message>
    <message>
        <source>TCP and payload can be set only at standstill. Wait until the arm has stopped.</source>
        <translation>TCP und Nutzlast können nur im Stillstand gesetzt werden. Warten Sie, bis der Arm stillsteht.</translation>
    </message>
    <message>
        <source>TCP set on the robot: %1</source>
        <translation>TCP am Roboter gesetzt: %1</translation>
    </message>
    <message>
        <source>Payload set on the robot: %1</source>
        <translation>Nutzlast am Roboter gesetzt: %1</translation>
    </message>
</context>
<context>
    <name>SampleProjects</name>
    <message>
        <source>Pick and place</source>
        <translation>Pick and Place</translation>
    </message>
    <message>
        <source>Picks a part from a feeder and places it in one of six tray cells. The cells are defined in the frame of the tray and move with it.</source>
        <translation>Nimmt ein Teil aus einem Zubringer und legt es auf einen von sechs Plätzen eines Trays. Die Plätze sind im Koordinatensystem des Trays definiert und bewegen sich mit ihm.</translation>
    </message>
    <message>
        <source>Gluing along a path</source>
        <translation>Kleben entlang einer Bahn</translation>
    </message>
    <message>
        <source>Applies a bead around a lid with rounded corners in slow, straight moves. Blends keep the nozzle moving through the corners.</source>
        <translation>Trägt in langsamen, geraden Bewegungen eine Raupe um einen Deckel mit runden Ecken auf. Überschleifen hält die Düse in den Ecken in Bewegung.</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>A probe touches a part from above and from four sides. Each touch starts at an approach waypoint with the tool tilted.</source>
        <translation>Ein Taster berührt ein Teil von oben und von vier Seiten. Jede Berührung beginnt an einem Anfahrpunkt mit geneigtem Werkzeug.</translation>
    </message>
</context>
<context>
    <name>SceneActions</name>
    <message>
        <source>Default view (perspective)</source>
        <translation>Standardansicht (perspektivisch)</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Blick von vorn</translation>
    </message>
    <message>
        <source>Base X to the right, Z up.</source>
        <translation>X der Basis nach rechts, Z nach oben.</translation>
    </message>
    <message>
        <source>Look from the side</source>
        <translation>Blick von der Seite</translation>
    </message>
    <message>
        <source>Base Y to the right, Z up.</source>
        <translation>Y der Basis nach rechts, Z nach oben.</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>Blick von oben</translation>
    </message>
    <message>
        <source>Base X to the right, Y up.</source>
        <translation>X der Basis nach rechts, Y nach oben.</translation>
    </message>
    <message>
        <source>Fit everything in the view</source>
        <translation>Alles in die Ansicht einpassen</translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view without changing the viewing direction.</source>
        <translation>Passt Arm, Ziel und Wegpunkte in die Ansicht ein, ohne die Blickrichtung zu ändern.</translation>
    </message>
    <message>
        <source>Shows the arm diagonally from the front, slightly from above, and fits everything in the view.</source>
        <translation>Zeigt den Arm schräg von vorn und leicht von oben und passt alles in die Ansicht ein.</translation>
    </message>
</context>
<context>
    <name>SessionRecording</name>
    <message>
        <source>Cannot record: connect to a robot first.</source>
        <translation>Aufzeichnen nicht möglich: Verbinden Sie sich zuerst mit einem Roboter.</translation>
    </message>
    <message>
        <source>Recording to %1</source>
        <translation>Zeichnet auf nach %1</translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n rows to %1</source>
        <translation>
            <numerusform>%n Zeile nach %1 aufgezeichnet</numerusform>
            <numerusform>%n Zeilen nach %1 aufgezeichnet</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording continues without notes. %1</source>
        <translation>Die Aufzeichnung läuft ohne Notizen weiter. %1</translation>
    </message>
    <message>
        <source>Not recorded, because the robot does not accept a second connection: %1</source>
        <translation>Nicht aufgezeichnet, weil der Roboter eine zweite Verbindung dafür ablehnt: %1</translation>
    </message>
    <message numerus="yes">
        <source>The recording has gaps: %n packets are missing.</source>
        <translation>
            <numerusform>Die Aufzeichnung hat Lücken: %n Paket fehlt.</numerusform>
            <numerusform>Die Aufzeichnung hat Lücken: %n Pakete fehlen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The current recording does not contain %1. Start a new recording to record displayed signals.</source>
        <translation>Die laufende Aufzeichnung enthält %1 nicht. Starten Sie eine neue Aufzeichnung, um angezeigte Signale aufzuzeichnen.</translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. These signals are not recorded: %1</source>
        <translation>Der Roboter kann nicht so viele Signale gleichzeitig senden. Nicht aufgezeichnete Signale: %1</translation>
    </message>
    <message>
        <source>Waiting for the trigger %1 to record to %2</source>
        <translation>Warten auf den Trigger %1, dann Aufzeichnung in %2</translation>
    </message>
    <message>
        <source>The trigger has not occurred. No file was written.</source>
        <translation>Der Trigger ist nicht eingetreten. Es wurde keine Datei geschrieben.</translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n files; the last one is %1</source>
        <translation>
            <numerusform>%n Datei aufgezeichnet; die letzte ist %1</numerusform>
            <numerusform>%n Dateien aufgezeichnet; die letzte ist %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SettingsFile</name>
    <message>
        <source>Invalid value for the setting “%1”.</source>
        <translation>Ungültiger Wert für die Einstellung „%1“.</translation>
    </message>
    <message>
        <source>The file is too large for a settings file.</source>
        <translation>Die Datei ist zu groß für eine Einstellungsdatei.</translation>
    </message>
    <message>
        <source>The file is damaged at byte %1: %2.</source>
        <translation>Die Datei ist bei Byte %1 beschädigt: %2.</translation>
    </message>
    <message>
        <source>The file contains no Tiller settings.</source>
        <translation>Die Datei enthält keine Tiller-Einstellungen.</translation>
    </message>
    <message>
        <source>The file was written by a newer version of Tiller. Update Tiller to import the file.</source>
        <translation>Die Datei wurde von einer neueren Version von Tiller geschrieben. Aktualisieren Sie Tiller, um sie zu importieren.</translation>
    </message>
    <message>
        <source>The file contains no version number.</source>
        <translation>Die Datei enthält keine Versionsangabe.</translation>
    </message>
    <message>
        <source>The list of settings is missing or too long.</source>
        <translation>Die Liste der Einstellungen fehlt oder ist zu lang.</translation>
    </message>
    <message>
        <source>“%1” is not a valid setting name.</source>
        <translation>„%1“ ist kein gültiger Einstellungsname.</translation>
    </message>
</context>
<context>
    <name>SignalInfo</name>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Ein- und Ausgänge</translation>
    </message>
    <message>
        <source>Modes and states</source>
        <translation>Modi und Zustände</translation>
    </message>
    <message>
        <source>Power and temperature</source>
        <translation>Strom und Temperatur</translation>
    </message>
    <message>
        <source>Speed and program</source>
        <translation>Geschwindigkeit und Programm</translation>
    </message>
    <message>
        <source>Payload and tool</source>
        <translation>Nutzlast und Werkzeug</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Sonstige</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Kraft am TCP</translation>
    </message>
    <message>
        <source>TCP torque</source>
        <translation>Drehmoment am TCP</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>Position des TCP</translation>
    </message>
    <message>
        <source>TCP rotation vector</source>
        <translation>Rotationsvektor des TCP</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>Geschwindigkeit des TCP</translation>
    </message>
    <message>
        <source>TCP angular speed</source>
        <translation>Drehgeschwindigkeit des TCP</translation>
    </message>
    <message>
        <source>TCP acceleration</source>
        <translation>Beschleunigung des TCP</translation>
    </message>
    <message>
        <source>Target TCP position</source>
        <translation>Sollposition des TCP</translation>
    </message>
    <message>
        <source>Target TCP rotation vector</source>
        <translation>Soll-Rotationsvektor des TCP</translation>
    </message>
    <message>
        <source>Target TCP speed</source>
        <translation>Sollgeschwindigkeit des TCP</translation>
    </message>
    <message>
        <source>Target TCP angular speed</source>
        <translation>Soll-Drehgeschwindigkeit des TCP</translation>
    </message>
    <message>
        <source>Raw sensor force</source>
        <translation>Rohkraft des Sensors</translation>
    </message>
    <message>
        <source>Raw sensor torque</source>
        <translation>Rohdrehmoment des Sensors</translation>
    </message>
    <message>
        <source>TCP force, norm</source>
        <translation>Kraft am TCP, Betrag</translation>
    </message>
    <message>
        <source>Tool accelerometer</source>
        <translation>Beschleunigungssensor im Flansch</translation>
    </message>
    <message>
        <source>Elbow position</source>
        <translation>Position des Ellbogens</translation>
    </message>
    <message>
        <source>Elbow speed</source>
        <translation>Geschwindigkeit des Ellbogens</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation>Gelenkstellungen</translation>
    </message>
    <message>
        <source>Joint speeds</source>
        <translation>Gelenkgeschwindigkeiten</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>Gelenkströme</translation>
    </message>
    <message>
        <source>Joint temperatures</source>
        <translation>Gelenktemperaturen</translation>
    </message>
    <message>
        <source>Joint voltages</source>
        <translation>Gelenkspannungen</translation>
    </message>
    <message>
        <source>Target joint positions</source>
        <translation>Soll-Gelenkstellungen</translation>
    </message>
    <message>
        <source>Target joint speeds</source>
        <translation>Soll-Gelenkgeschwindigkeiten</translation>
    </message>
    <message>
        <source>Target joint accelerations</source>
        <translation>Soll-Gelenkbeschleunigungen</translation>
    </message>
    <message>
        <source>Target joint currents</source>
        <translation>Soll-Gelenkströme</translation>
    </message>
    <message>
        <source>Target joint torques</source>
        <translation>Soll-Gelenkmomente</translation>
    </message>
    <message>
        <source>Joint control currents</source>
        <translation>Regelströme der Gelenke</translation>
    </message>
    <message>
        <source>Allowed current deviation</source>
        <translation>Erlaubte Abweichung der Ströme</translation>
    </message>
    <message>
        <source>Position deviation, ratio to limit</source>
        <translation>Positionsabweichung, Verhältnis zur Grenze</translation>
    </message>
    <message>
        <source>Collision detection, ratio to limit</source>
        <translation>Kollisionserkennung, Verhältnis zur Grenze</translation>
    </message>
    <message>
        <source>Joint modes</source>
        <translation>Gelenkmodi</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>Digitale Eingänge</translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation>Digitale Ausgänge</translation>
    </message>
    <message>
        <source>Analog input 0</source>
        <translation>Analogeingang 0</translation>
    </message>
    <message>
        <source>Analog input 1</source>
        <translation>Analogeingang 1</translation>
    </message>
    <message>
        <source>Analog output 0</source>
        <translation>Analogausgang 0</translation>
    </message>
    <message>
        <source>Analog output 1</source>
        <translation>Analogausgang 1</translation>
    </message>
    <message>
        <source>Tool analog input 0</source>
        <translation>Werkzeug-Analogeingang 0</translation>
    </message>
    <message>
        <source>Tool analog input 1</source>
        <translation>Werkzeug-Analogeingang 1</translation>
    </message>
    <message>
        <source>Robot mode</source>
        <translation>Robotermodus</translation>
    </message>
    <message>
        <source>Safety mode</source>
        <translation>Sicherheitsmodus</translation>
    </message>
    <message>
        <source>Safety status</source>
        <translation>Sicherheitsstatus</translation>
    </message>
    <message>
        <source>Program state</source>
        <translation>Programmzustand</translation>
    </message>
    <message>
        <source>Robot status</source>
        <translation>Roboterstatus</translation>
    </message>
    <message>
        <source>Safety bits</source>
        <translation>Sicherheitsbits</translation>
    </message>
    <message>
        <source>Tool mode</source>
        <translation>Werkzeugmodus</translation>
    </message>
    <message>
        <source>Main voltage</source>
        <translation>Netzspannung</translation>
    </message>
    <message>
        <source>Arm voltage</source>
        <translation>Spannung des Arms</translation>
    </message>
    <message>
        <source>Arm current</source>
        <translation>Strom des Arms</translation>
    </message>
    <message>
        <source>I/O current</source>
        <translation>Strom der E/A</translation>
    </message>
    <message>
        <source>Tool temperature</source>
        <translation>Werkzeugtemperatur</translation>
    </message>
    <message>
        <source>Tool voltage</source>
        <translation>Werkzeugspannung</translation>
    </message>
    <message>
        <source>Tool current</source>
        <translation>Werkzeugstrom</translation>
    </message>
    <message>
        <source>Speed scaling</source>
        <translation>Geschwindigkeitsskalierung</translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation>Geschwindigkeitsregler</translation>
    </message>
    <message>
        <source>Control step time</source>
        <translation>Dauer eines Regelschritts</translation>
    </message>
    <message>
        <source>Script line</source>
        <translation>Skriptzeile</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>Zeit der Steuerung</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Nutzlast</translation>
    </message>
    <message>
        <source>Payload centre of gravity</source>
        <translation>Schwerpunkt der Nutzlast</translation>
    </message>
    <message>
        <source>TCP offset</source>
        <translation>TCP-Versatz</translation>
    </message>
    <message>
        <source>TCP rotation</source>
        <translation>TCP-Drehung</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Program running</source>
        <translation>Programm läuft</translation>
    </message>
    <message>
        <source>Freedrive button</source>
        <translation>Freedrive-Knopf</translation>
    </message>
    <message>
        <source>Power button</source>
        <translation>Ein/Aus-Knopf</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reduziert</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>Schutzstopp</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Wiederherstellung</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>Safeguard-Stopp</translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation>System-Not-Halt</translation>
    </message>
    <message>
        <source>Robot emergency stop</source>
        <translation>Not-Halt des Roboters</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
    <message>
        <source>Violation</source>
        <translation>Verletzung</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Enabling device</source>
        <translation>Zustimmgerät</translation>
    </message>
    <message>
        <source>Bit %1</source>
        <translation>Bit %1</translation>
    </message>
    <message>
        <source>Output registers, floats</source>
        <translation>Ausgangsregister, Float</translation>
    </message>
    <message>
        <source>Input registers, floats</source>
        <translation>Eingangsregister, Float</translation>
    </message>
    <message>
        <source>Output registers, integers</source>
        <translation>Ausgangsregister, Ganzzahlen</translation>
    </message>
    <message>
        <source>Input registers, integers</source>
        <translation>Eingangsregister, Ganzzahlen</translation>
    </message>
    <message>
        <source>Output registers, bits</source>
        <translation>Ausgangsregister, Bits</translation>
    </message>
    <message>
        <source>Input registers, bits</source>
        <translation>Eingangsregister, Bits</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Stopped due to safety</source>
        <translation>Von der Sicherheit gestoppt</translation>
    </message>
</context>
<context>
    <name>SpaceMouse</name>
    <message>
        <source>left button</source>
        <translation>linke Taste</translation>
    </message>
    <message>
        <source>The tool follows the motion of the cap.</source>
        <translation>Das Werkzeug folgt der Bewegung der Kappe.</translation>
    </message>
</context>
<context>
    <name>Spectrum</name>
    <message>
        <source>compute a spectrum</source>
        <translation>ein Spektrum berechnen</translation>
    </message>
    <message>
        <source>The range contains fewer than %1 samples. Select a longer range.</source>
        <translation>Es sind weniger als %1 Messwerte: Wählen Sie einen längeren Bereich.</translation>
    </message>
    <message>
        <source>Values are missing in this range. Select a range without gaps.</source>
        <translation>In diesem Bereich fehlen Werte: Wählen Sie einen Bereich ohne Lücken.</translation>
    </message>
    <message>
        <source>Not enough memory. Select a shorter range.</source>
        <translation>Nicht genügend Speicher: Wählen Sie einen kürzeren Bereich.</translation>
    </message>
</context>
<context>
    <name>StartProject</name>
    <message>
        <source>The last project no longer exists: %1</source>
        <translation>Das letzte Projekt ist nicht mehr vorhanden: %1</translation>
    </message>
</context>
<context>
    <name>StateLane</name>
    <message>
        <source>Protective stop</source>
        <translation>Schutzstopp</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Wiederherstellung</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>Safeguard-Stopp</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
    <message>
        <source>Enabling device released</source>
        <translation>Zustimmgerät losgelassen</translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation>Sicherheitsverletzung</translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation>Sicherheitsfehler</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>Ausgeschaltet</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Startet</translation>
    </message>
    <message>
        <source>Brakes on</source>
        <translation>Bremsen zu</translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation>Zurückdrücken</translation>
    </message>
    <message>
        <source>Not running</source>
        <translation>Läuft nicht</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Keine Daten</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>Freedrive</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation>Fahren %1</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>Bewegt sich</translation>
    </message>
    <message>
        <source>At standstill</source>
        <translation>Im Stillstand</translation>
    </message>
    <message>
        <source>Late data</source>
        <translation>Daten verspätet</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Enter an IP address, such as 192.168.0.10, or a host name.</source>
        <translation>Geben Sie eine IP-Adresse ein, z. B. 192.168.0.10, oder einen Hostnamen.</translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and this PC is on the same network.</source>
        <translation>Prüfen Sie, ob der Roboter eingeschaltet, das Kabel eingesteckt und dieser PC im selben Netzwerk ist.</translation>
    </message>
    <message>
        <source>Enable the interface on the robot under Settings &gt; Security &gt; Services. A robot that has just started may need another minute.</source>
        <translation>Aktivieren Sie die Schnittstelle am Roboter unter Einstellungen &gt; Sicherheit &gt; Dienste. Ein gerade gestarteter Roboter benötigt eventuell noch eine Minute.</translation>
    </message>
    <message>
        <source>The robot may be restarting or switching between Local and Remote control. Wait a minute, then connect again.</source>
        <translation>Er startet eventuell neu oder wird zwischen Lokal und Fernsteuerung umgeschaltet. Warten Sie eine Minute und verbinden Sie dann erneut.</translation>
    </message>
    <message>
        <source>The robot does not respond. Check the cable and the address.</source>
        <translation>Der Roboter antwortet nicht. Prüfen Sie Kabel und Adresse.</translation>
    </message>
    <message>
        <source>No more data received. Check the cable. Tiller reconnects automatically; motion does not resume.</source>
        <translation>Es werden keine Daten mehr empfangen. Prüfen Sie das Kabel. Tiller verbindet sich automatisch neu; die Bewegung wird nicht fortgesetzt.</translation>
    </message>
    <message>
        <source>The response is not valid for this protocol. Check the address and the port.</source>
        <translation>Die Antwort entspricht nicht dem Protokoll. Prüfen Sie die Adresse und den Port.</translation>
    </message>
    <message>
        <source>If newer software is available for this robot, update the robot.</source>
        <translation>Wenn es für diesen Roboter eine neuere Software gibt, aktualisieren Sie den Roboter.</translation>
    </message>
    <message>
        <source>The robot&apos;s software does not provide this value.</source>
        <translation>Die Software des Roboters stellt diesen Wert nicht bereit.</translation>
    </message>
    <message>
        <source>Another program or a fieldbus on the robot uses these registers. Close the other program, or disable the fieldbus in the installation.</source>
        <translation>Ein anderes Programm oder ein Feldbus des Roboters verwendet diese Register: Schließen Sie das andere Programm oder deaktivieren Sie den Feldbus in der Installation.</translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation>Verbinden Sie sich zuerst mit einem Roboter.</translation>
    </message>
    <message>
        <source>Take control first.</source>
        <translation>Übernehmen Sie zuerst die Steuerung.</translation>
    </message>
    <message>
        <source>Power on the arm, release the brakes and clear any safety stop first.</source>
        <translation>Schalten Sie zuerst den Arm ein, lösen Sie die Bremsen und heben Sie einen Sicherheitsstopp auf.</translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant.</source>
        <translation>Schalten Sie den Roboter am Teach-Pendant oben rechts auf Fernsteuerung.</translation>
    </message>
    <message>
        <source>Choose a target within the reach of the arm and a speed below the speed cap.</source>
        <translation>Wählen Sie ein Ziel im Bewegungsbereich des Arms und eine Geschwindigkeit innerhalb der Grenze.</translation>
    </message>
    <message>
        <source>The arm cannot reach this pose. Move the target closer or rotate the tool.</source>
        <translation>Der Arm kann diese Pose nicht erreichen: Verschieben Sie den Punkt näher heran oder drehen Sie das Werkzeug.</translation>
    </message>
    <message>
        <source>The robot could not run the program. See the log for the controller&apos;s message.</source>
        <translation>Der Roboter konnte das Programm nicht ausführen. Die Meldung der Steuerung steht im Protokoll.</translation>
    </message>
    <message>
        <source>Check that the file exists and that you have permission to read it.</source>
        <translation>Prüfen Sie, ob die Datei vorhanden ist und Sie sie lesen dürfen.</translation>
    </message>
    <message>
        <source>Choose a folder that you have permission to write to.</source>
        <translation>Wählen Sie einen Ordner, in den Sie schreiben dürfen.</translation>
    </message>
    <message>
        <source>The file was not changed. Open a backup, or repair the file at the reported position.</source>
        <translation>Die Datei wurde nicht geändert. Öffnen Sie eine Sicherung oder reparieren Sie die gemeldete Stelle.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Erledigt</translation>
    </message>
    <message>
        <source>Address not found</source>
        <translation>Adresse nicht gefunden</translation>
    </message>
    <message>
        <source>Robot not reachable</source>
        <translation>Roboter nicht erreichbar</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>Verbindung abgelehnt</translation>
    </message>
    <message>
        <source>Connection closed by the robot</source>
        <translation>Verbindung vom Roboter beendet</translation>
    </message>
    <message>
        <source>Timed out</source>
        <translation>Zeitüberschreitung</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>Protocol error</source>
        <translation>Protokollfehler</translation>
    </message>
    <message>
        <source>Not supported by this robot</source>
        <translation>Von diesem Roboter nicht unterstützt</translation>
    </message>
    <message>
        <source>Value not available</source>
        <translation>Wert nicht verfügbar</translation>
    </message>
    <message>
        <source>Registers in use</source>
        <translation>Register belegt</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation>Nicht gesteuert</translation>
    </message>
    <message>
        <source>Robot not ready</source>
        <translation>Roboter nicht bereit</translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation>Der Roboter ist in lokaler Steuerung</translation>
    </message>
    <message>
        <source>Outside the limits</source>
        <translation>Außerhalb der Grenzen</translation>
    </message>
    <message>
        <source>Invalid value</source>
        <translation>Ungültiger Wert</translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation>Außer Reichweite</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Refused by the robot</source>
        <translation>Vom Roboter verweigert</translation>
    </message>
    <message>
        <source>Program error on the robot</source>
        <translation>Programmfehler auf dem Roboter</translation>
    </message>
    <message>
        <source>Cannot read the file</source>
        <translation>Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>Cannot write the file</source>
        <translation>Datei kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>File is damaged</source>
        <translation>Datei ist beschädigt</translation>
    </message>
    <message>
        <source>Disk full</source>
        <translation>Datenträger voll</translation>
    </message>
    <message>
        <source>Internal error</source>
        <translation>Interner Fehler</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>button or key released</source>
        <translation>Taste losgelassen</translation>
    </message>
    <message>
        <source>pointer left the button</source>
        <translation>Zeiger hat die Taste verlassen</translation>
    </message>
    <message>
        <source>focus lost</source>
        <translation>Fokus verloren</translation>
    </message>
    <message>
        <source>another window became active</source>
        <translation>anderes Fenster wurde aktiv</translation>
    </message>
    <message>
        <source>window closed</source>
        <translation>Fenster geschlossen</translation>
    </message>
    <message>
        <source>a dialog or menu opened</source>
        <translation>Dialog oder Menü geöffnet</translation>
    </message>
    <message>
        <source>another button or key pressed</source>
        <translation>andere Taste gedrückt</translation>
    </message>
    <message>
        <source>Esc pressed</source>
        <translation>Esc gedrückt</translation>
    </message>
    <message>
        <source>Space pressed</source>
        <translation>Leertaste gedrückt</translation>
    </message>
    <message>
        <source>STOP pressed</source>
        <translation>STOP gedrückt</translation>
    </message>
    <message>
        <source>input device lost</source>
        <translation>Eingabegerät verloren</translation>
    </message>
    <message>
        <source>robot data arrived too late</source>
        <translation>Roboterdaten zu alt</translation>
    </message>
    <message>
        <source>robot or safety mode changed</source>
        <translation>Roboter- oder Sicherheitsmodus geändert</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>limit reached</source>
        <translation>Grenze erreicht</translation>
    </message>
    <message>
        <source>control lost</source>
        <translation>Steuerung verloren</translation>
    </message>
    <message>
        <source>target reached</source>
        <translation>Ziel erreicht</translation>
    </message>
    <message>
        <source>stopped by a program</source>
        <translation>von einem Programm gestoppt</translation>
    </message>
    <message>
        <source>contact detected</source>
        <translation>Kontakt erkannt</translation>
    </message>
    <message>
        <source>target cannot be reached</source>
        <translation>Ziel nicht erreichbar</translation>
    </message>
    <message>
        <source>could not verify that the button or key is still pressed</source>
        <translation>nicht prüfbar, ob die Taste noch gedrückt ist</translation>
    </message>
    <message>
        <source>maximum hold time reached; press again</source>
        <translation>maximale Haltezeit erreicht; erneut drücken</translation>
    </message>
    <message>
        <source>PolyScope X before 10.11 does not accept these commands over the network. Use the teach pendant.</source>
        <translation>PolyScope X vor 10.11 nimmt diese Befehle nicht über das Netzwerk an: Verwenden Sie das Teach-Pendant.</translation>
    </message>
    <message>
        <source>PolyScope X cannot close popups over the network. Use the teach pendant.</source>
        <translation>PolyScope X kann Popups nicht über das Netzwerk schließen: Verwenden Sie das Teach-Pendant.</translation>
    </message>
    <message>
        <source>Monitoring. Take control to move the arm.</source>
        <translation>Beobachten. Übernehmen Sie die Steuerung, um den Arm zu bewegen.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Übernehme Steuerung…</translation>
    </message>
    <message>
        <source>Control was given back. Take control to move the arm.</source>
        <translation>Die Steuerung wurde abgegeben. Übernehmen Sie sie, um den Arm zu bewegen.</translation>
    </message>
    <message>
        <source>The control program on the robot was stopped. Take control again.</source>
        <translation>Das Steuerprogramm wurde am Roboter gestoppt. Übernehmen Sie wieder die Steuerung.</translation>
    </message>
    <message>
        <source>The control program was replaced or does not respond. Take control again.</source>
        <translation>Das Steuerprogramm wurde ersetzt oder antwortet nicht. Übernehmen Sie erneut die Steuerung.</translation>
    </message>
    <message>
        <source>The connection was lost. Take control again.</source>
        <translation>Die Verbindung wurde unterbrochen. Übernehmen Sie erneut die Steuerung.</translation>
    </message>
    <message>
        <source>Your script is running. Tiller regains control when the script ends.</source>
        <translation>Ihr Skript läuft. Tiller erhält die Steuerung zurück, wenn es endet.</translation>
    </message>
    <message>
        <source>Free some space on the disk, then save or record again.</source>
        <translation>Geben Sie Speicherplatz frei, und speichern oder zeichnen Sie dann erneut auf.</translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. Turn off “Monitor only” in Settings, or start Tiller without --monitor-only.</source>
        <translation>Nur beobachten: Dieses Fenster ändert am Roboter nichts. Schalten Sie „Nur beobachten“ in den Einstellungen aus, oder starten Sie Tiller ohne --monitor-only.</translation>
    </message>
    <message>
        <source>No current data from the robot. Check the network connection to the robot.</source>
        <translation>Keine aktuellen Daten vom Roboter. Prüfen Sie die Netzwerkverbindung zum Roboter.</translation>
    </message>
    <message>
        <source>selection or modifier key changed</source>
        <translation>Auswahl oder Zusatztaste geändert</translation>
    </message>
    <message>
        <source>the window did not respond</source>
        <translation>das Fenster reagierte nicht</translation>
    </message>
    <message>
        <source>not measured: no data during the stop</source>
        <translation>nicht gemessen: keine Daten während des Stopps</translation>
    </message>
    <message>
        <source>not measured: another program is moving the arm</source>
        <translation>nicht gemessen: ein anderes Programm bewegt den Arm</translation>
    </message>
    <message>
        <source>the PC is going to sleep</source>
        <translation>der PC wechselt in den Ruhezustand</translation>
    </message>
    <message>
        <source>the robot did not receive the stop command</source>
        <translation>der Roboter hat den Stoppbefehl nicht erhalten</translation>
    </message>
    <message>
        <source>servo target too far from the previous target</source>
        <translation>Servoziel zu weit vom vorherigen Ziel entfernt</translation>
    </message>
</context>
<context>
    <name>WaypointClipboard</name>
    <message>
        <source>the value is missing</source>
        <translation>der Wert fehlt</translation>
    </message>
    <message>
        <source>“%1” is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>%1 is outside the range %2 to %3</source>
        <translation>%1 liegt außerhalb von %2 bis %3</translation>
    </message>
    <message>
        <source>Line %1, column “%2”: %3.</source>
        <translation>Zeile %1, Spalte „%2“: %3.</translation>
    </message>
    <message>
        <source>“%1” must be “J” or “L”</source>
        <translation>„%1“ muss „J“ oder „L“ sein</translation>
    </message>
    <message>
        <source>“%1” must be “joints” or “pose”</source>
        <translation>„%1“ muss „joints“ oder „pose“ sein</translation>
    </message>
    <message>
        <source>the project has no frame named “%1”</source>
        <translation>in diesem Projekt gibt es kein Koordinatensystem „%1“</translation>
    </message>
    <message>
        <source>The text is not a table of waypoints. Copy a waypoint from the list to see the columns, or use the six values of a pose.</source>
        <translation>Dies ist keine Wegpunkttabelle. Kopieren Sie einen Wegpunkt aus der Liste, um die Spalten zu sehen, oder fügen Sie die sechs Werte einer Pose ein.</translation>
    </message>
    <message>
        <source>“%1” is not a waypoint colour (none, blue, orange, green, pink, yellow or sky)</source>
        <translation>„%1“ ist keine Wegpunktfarbe (none, blue, orange, green, pink, yellow oder sky)</translation>
    </message>
</context>
<context>
    <name>WaypointExchange</name>
    <message>
        <source>Line %1: the closing quotation mark is missing.</source>
        <translation>Zeile %1: Das schließende Anführungszeichen fehlt.</translation>
    </message>
</context>
<context>
    <name>tiller::ActionsDialog</name>
    <message>
        <source>Actions at “%1”</source>
        <translation>Aktionen an „%1“</translation>
    </message>
    <message numerus="yes">
        <source>Actions at %n waypoints</source>
        <translation>
            <numerusform>Aktionen an einem Wegpunkt</numerusform>
            <numerusform>Aktionen an %n Wegpunkten</numerusform>
        </translation>
    </message>
    <message>
        <source>“Run route (hold)” runs these actions in order at the waypoint while the button is held.</source>
        <translation>Aktionen laufen in dieser Reihenfolge ab, wenn „Route“ den Wegpunkt erreicht und die Taste gehalten wird.</translation>
    </message>
    <message>
        <source>These waypoints have different actions. “Apply” replaces them all with the actions below.</source>
        <translation>Diese Wegpunkte haben unterschiedliche Aktionen. „Anwenden“ ersetzt sie alle durch die Aktionen unten.</translation>
    </message>
    <message>
        <source>Actions in order</source>
        <translation>Aktionen in Reihenfolge</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected action</source>
        <translation>Gewählte Aktion entfernen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move the selected action up</source>
        <translation>Gewählte Aktion nach oben verschieben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Move the selected action down</source>
        <translation>Gewählte Aktion nach unten verschieben</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Terminal</source>
        <translation>Klemme</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>Zeitlimit</translation>
    </message>
    <message>
        <source>After this time, the action fails with a message. With 0, the action waits while the button is held, up to one hour.</source>
        <translation>Nach dieser Zeit bricht das Warten mit einer Meldung ab. 0: wartet, solange die Taste gehalten wird, höchstens eine Stunde.</translation>
    </message>
    <message>
        <source>Add an action after the selected action</source>
        <translation>Aktion nach der gewählten hinzufügen</translation>
    </message>
</context>
<context>
    <name>tiller::AnalogRow</name>
    <message>
        <source>4–20 mA</source>
        <translation>4–20 mA</translation>
    </message>
    <message>
        <source>0–10 V</source>
        <translation>0–10 V</translation>
    </message>
    <message>
        <source>%1 domain</source>
        <translation>%1 Bereich</translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation>%1 Wert</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>%1 setzen</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Scale…</source>
        <translation>Skalieren…</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Name von %1</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Skala von %1</translation>
    </message>
    <message>
        <source>e.g. bar; empty: no scaling</source>
        <translation>z. B. bar; leer: nicht skaliert</translation>
    </message>
    <message>
        <source>At 4 mA or 0 V</source>
        <translation>Bei 4 mA oder 0 V</translation>
    </message>
    <message>
        <source>At 20 mA or 10 V</source>
        <translation>Bei 20 mA oder 10 V</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>%1: %2
To rename or scale the signal, right-click it, or press F2 or Shift+F2.</source>
        <translation>%1: %2
F2: Umbenennen, Umschalt+F2: Skalieren, oder Rechtsklick.</translation>
    </message>
</context>
<context>
    <name>tiller::ArmKey</name>
    <message>
        <source>Keyboard armed</source>
        <translation>Tastatur scharf</translation>
    </message>
    <message>
        <source>Arm keyboard</source>
        <translation>Tastatur scharf schalten</translation>
    </message>
    <message>
        <source>While the keyboard is armed, holding an arrow key moves the arm. A border around the window shows that the keyboard is armed.</source>
        <translation>Bei scharfer Tastatur bewegen die Pfeiltasten den Arm, solange sie gehalten werden. Ein Rahmen um das Fenster zeigt an, dass die Tastatur scharf ist.</translation>
    </message>
    <message>
        <source>Arrow keys move along X and Y, PgUp and PgDn along Z; with Alt, they rotate the tool. Hold 1 to 6 and press + or − to move a joint. Space and Esc stop the arm. To disarm the keyboard, click this button or wait 30 s.</source>
        <translation>Pfeiltasten bewegen X und Y, Bild auf und Bild ab bewegen Z; mit Alt drehen sie. 1 bis 6 mit + und − bewegen ein Gelenk. Leertaste und Esc stoppen. Zum Entschärfen klicken oder 30 s warten.</translation>
    </message>
</context>
<context>
    <name>tiller::CellPage</name>
    <message>
        <source>Size %1</source>
        <translation>Größe %1</translation>
    </message>
    <message>
        <source>Shown and checked for collisions</source>
        <translation>Angezeigt und auf Kollisionen geprüft</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Enter a name for the box or plane.</source>
        <translation>Geben Sie einen Namen für den Quader oder die Ebene ein.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>„%1“ in „%2“ umbenennen</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>No boxes or planes yet.
Move the TCP to a corner of an obstacle and press “Teach corner”.</source>
        <translation>Noch keine Quader oder Ebenen.
Bewegen Sie den TCP zu einer Ecke eines Hindernisses und drücken Sie „Ecke hier“.</translation>
    </message>
    <message>
        <source>Check for collisions</source>
        <translation>Kollisionen prüfen</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Centre of the box. Press Return to apply the values. Only the box changes; the robot does not move.</source>
        <translation>Mitte des Quaders. Mit Enter übernehmen. Nur der Quader ändert sich; der Roboter bewegt sich nicht.</translation>
    </message>
    <message>
        <source>LX</source>
        <translation>LX</translation>
    </message>
    <message>
        <source>LY</source>
        <translation>LY</translation>
    </message>
    <message>
        <source>LZ</source>
        <translation>LZ</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>„%1“ hinzufügen</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>First corner recorded</source>
        <translation>Erste Ecke übernommen</translation>
    </message>
    <message>
        <source>Move the TCP to the opposite corner and press “Teach corner 2”.</source>
        <translation>Bewegen Sie den TCP zur gegenüberliegenden Ecke und drücken Sie „Andere Ecke“.</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>The corners must differ by at least 1 mm along X, Y and Z. Move the TCP to the opposite corner of the box.</source>
        <translation>Die Ecken müssen sich in X, Y und Z um mindestens 1 mm unterscheiden. Bewegen Sie den TCP zur gegenüberliegenden Ecke des Quaders.</translation>
    </message>
    <message>
        <source>Move “%1”</source>
        <translation>„%1“ verschieben</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>„%1“ duplizieren</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>„%1“ löschen</translation>
    </message>
    <message>
        <source>Set the floor</source>
        <translation>Boden setzen</translation>
    </message>
    <message>
        <source>Remove the floor</source>
        <translation>Boden entfernen</translation>
    </message>
    <message>
        <source>Change the safety distance</source>
        <translation>Sicherheitsabstand ändern</translation>
    </message>
    <message>
        <source>Teach corner 2</source>
        <translation>Andere Ecke</translation>
    </message>
    <message>
        <source>Teach corner</source>
        <translation>Ecke hier</translation>
    </message>
    <message>
        <source>%1 · %2 in %3</source>
        <translation>%1 · %2 in %3</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Length along X</source>
        <translation>Länge entlang X</translation>
    </message>
    <message>
        <source>Length along Y</source>
        <translation>Länge entlang Y</translation>
    </message>
    <message>
        <source>Length along Z</source>
        <translation>Länge entlang Z</translation>
    </message>
    <message>
        <source>Point on the plane, X</source>
        <translation>Punkt auf der Ebene, X</translation>
    </message>
    <message>
        <source>Point on the plane, Y</source>
        <translation>Punkt auf der Ebene, Y</translation>
    </message>
    <message>
        <source>Point on the plane, Z</source>
        <translation>Punkt auf der Ebene, Z</translation>
    </message>
    <message>
        <source>Normal X, towards the arm</source>
        <translation>Normale X, zum Arm</translation>
    </message>
    <message>
        <source>Normal Y, towards the arm</source>
        <translation>Normale Y, zum Arm</translation>
    </message>
    <message>
        <source>Normal Z, towards the arm</source>
        <translation>Normale Z, zum Arm</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>When off, the box or plane is neither shown nor checked for collisions.</source>
        <translation>Ausgeschaltet wird der Quader oder die Ebene weder angezeigt noch auf Kollisionen geprüft.</translation>
    </message>
    <message>
        <source>Horizontal plane in the base frame that the arm must stay above.</source>
        <translation>Waagerechte Ebene im Basissystem, über der der Arm bleiben muss.</translation>
    </message>
    <message>
        <source>Floor height</source>
        <translation>Höhe des Bodens</translation>
    </message>
    <message>
        <source>Safety distance</source>
        <translation>Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Jogging stops at this distance from objects in the cell and between parts of the arm. Moves that would bring the arm closer are refused.</source>
        <translation>Das Verfahren endet in diesem Abstand zu Objekten der Zelle und zwischen Teilen des Arms. Bewegungen, die näher kommen, werden abgelehnt.</translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation>Am TCP</translation>
    </message>
    <message>
        <source>Set the floor to the TCP height</source>
        <translation>Boden auf die Höhe des TCP setzen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Teach a box corner at the TCP</source>
        <translation>Ecke eines Quaders auf den TCP setzen</translation>
    </message>
    <message>
        <source>Teach plane</source>
        <translation>Ebene hier</translation>
    </message>
    <message>
        <source>Add a plane through the TCP, perpendicular to the tool</source>
        <translation>Ebene durch den TCP hinzufügen, senkrecht zum Werkzeug</translation>
    </message>
    <message>
        <source>New box</source>
        <translation>Neuer Quader</translation>
    </message>
    <message>
        <source>Add a box numerically</source>
        <translation>Quader mit Werten hinzufügen</translation>
    </message>
    <message>
        <source>Add a plane through the TCP</source>
        <translation>Ebene durch den TCP hinzufügen</translation>
    </message>
    <message>
        <source>Add a plane numerically</source>
        <translation>Ebene mit Werten hinzufügen</translation>
    </message>
    <message>
        <source>Move the box or plane to the TCP</source>
        <translation>Quader oder Ebene zum TCP verschieben</translation>
    </message>
    <message>
        <source>Rename box or plane</source>
        <translation>Quader oder Ebene umbenennen</translation>
    </message>
    <message>
        <source>Duplicate box or plane</source>
        <translation>Quader oder Ebene duplizieren</translation>
    </message>
    <message>
        <source>Delete box or plane</source>
        <translation>Quader oder Ebene löschen</translation>
    </message>
    <message>
        <source>Resize “%1”</source>
        <translation>Größe von „%1“ ändern</translation>
    </message>
    <message>
        <source>The normal must not be zero. Enter at least one nonzero component.</source>
        <translation>Die Normale darf nicht null sein. Geben Sie zuerst eine Komponente ein.</translation>
    </message>
    <message>
        <source>Rotate “%1”</source>
        <translation>„%1“ drehen</translation>
    </message>
    <message>
        <source>missing frame</source>
        <translation>Koordinatensystem fehlt</translation>
    </message>
    <message>
        <source>Turn on the collision check of “%1”</source>
        <translation>Kollisionsprüfung von „%1“ einschalten</translation>
    </message>
    <message>
        <source>Turn off the collision check of “%1”</source>
        <translation>Kollisionsprüfung von „%1“ ausschalten</translation>
    </message>
    <message>
        <source>Turn collision check on or off</source>
        <translation>Kollisionsprüfung ein- oder ausschalten</translation>
    </message>
    <message>
        <source>The cell already contains “%1”. Choose a different name.</source>
        <translation>Die Zelle enthält bereits „%1“. Wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>tiller::ChecklistItem</name>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>not done yet</source>
        <translation>noch nicht erledigt</translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonBand</name>
    <message>
        <source>Comparison with the arm model</source>
        <translation>Vergleich mit dem Modell des Arms</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Vergleichen…</translation>
    </message>
    <message>
        <source>Compare this recording with the arm model using different limits</source>
        <translation>Diese Aufzeichnung mit anderen Grenzen mit dem Modell des Arms vergleichen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Go to time</source>
        <translation>Zur Stelle</translation>
    </message>
    <message>
        <source>Cancel the comparison</source>
        <translation>Vergleich abbrechen</translation>
    </message>
    <message>
        <source>Place cursor A where the arm and the model diverge</source>
        <translation>Cursor A dorthin setzen, wo Arm und Modell voneinander abweichen</translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonDialog</name>
    <message>
        <source>Compare with the arm model</source>
        <translation>Mit dem Modell des Arms vergleichen</translation>
    </message>
    <message>
        <source>The simulated arm follows the recorded joint targets, and its motion is compared with the recorded motion. The model includes neither contact nor friction.</source>
        <translation>Der simulierte Arm folgt den aufgezeichneten Gelenksollwerten, und seine Bewegung wird mit der aufgezeichneten verglichen. Das Modell enthält weder Kontakt noch Reibung.</translation>
    </message>
    <message>
        <source>Arm model</source>
        <translation>Modell des Arms</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation>Gelenkstellungen</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>TCP-Position</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>Gelenkströme</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Kraft am TCP</translation>
    </message>
    <message>
        <source>Signals with a limit of 0 are not compared.</source>
        <translation>Signale mit der Grenze 0 werden nicht verglichen.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Minimum duration</source>
        <translation>Mindestdauer</translation>
    </message>
</context>
<context>
    <name>tiller::CurveDialog</name>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Displayed value = value × scale + offset</source>
        <translation>Angezeigter Wert = Wert × Faktor + Versatz</translation>
    </message>
    <message>
        <source>Choose the colour</source>
        <translation>Farbe auswählen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Auswählen…</translation>
    </message>
    <message>
        <source>Automatic colour</source>
        <translation>Automatische Farbe</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Durchgezogen</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Gestrichelt</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Gepunktet</translation>
    </message>
    <message>
        <source>Value axis</source>
        <translation>Werteachse</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Geben Sie einen Namen ein.</translation>
    </message>
    <message>
        <source>Name and unit cannot contain = [ ].</source>
        <translation>Name und Einheit dürfen = [ ] nicht enthalten.</translation>
    </message>
    <message>
        <source>Enter a number other than 0 as the scale.</source>
        <translation>Geben Sie als Faktor eine Zahl ungleich 0 ein.</translation>
    </message>
    <message>
        <source>Enter a number as the offset.</source>
        <translation>Geben Sie als Versatz eine Zahl ein.</translation>
    </message>
</context>
<context>
    <name>tiller::DecimalSpinBox</name>
    <message>
        <source>“%1” is out of range (%2 to %3). The value is still %4.</source>
        <translation>„%1“ liegt außerhalb des Bereichs (%2 bis %3). Der Wert ist weiterhin %4.</translation>
    </message>
</context>
<context>
    <name>tiller::DeviceTrainer</name>
    <message>
        <source>Enable motion (until Tiller is closed)</source>
        <translation>Bewegung freigeben (bis Tiller geschlossen wird)</translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation>Nur dominante Achse</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation>Gamepad und SpaceMouse</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Direction in which the arm would move</source>
        <translation>Richtung, in die sich der Arm bewegen würde</translation>
    </message>
    <message>
        <source>Hold-to-run</source>
        <translation>Zustimmtaste</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation>Kein Gamepad und keine SpaceMouse gefunden. Schließen Sie ein Gerät an; es wird automatisch erkannt.</translation>
    </message>
    <message>
        <source>● held (%1)</source>
        <translation>● gehalten (%1)</translation>
    </message>
    <message>
        <source>○ not held: hold the %1</source>
        <translation>○ nicht gehalten: Halten Sie %1</translation>
    </message>
    <message>
        <source>none (neutral)</source>
        <translation>keine (neutral)</translation>
    </message>
    <message>
        <source>With the keyboard armed (Ctrl+J): arrow keys for X and Y; PgUp and PgDn for Z; Alt with these keys for rotation; 1 to 6 with + and − for joints; Home for the home position; End to align; Backspace to move back; F for Freedrive; Ctrl for slower; Shift for faster. Space and Esc stop the arm.</source>
        <translation>Scharfe Tastatur (Strg+J): Pfeiltasten: X und Y; Bild auf, Bild ab: Z; mit Alt: Drehung; 1 bis 6 mit + und −: Gelenke; Pos1: Home; Ende: Ausrichten; Rücktaste: Zurück; F: Freedrive; Strg: langsamer; Umschalt: schneller. Leertaste und Esc stoppen.</translation>
    </message>
</context>
<context>
    <name>tiller::EmptyState</name>
    <message>
        <source>Nothing found</source>
        <translation>Nichts gefunden</translation>
    </message>
    <message>
        <source>Nothing found with these filters.</source>
        <translation>Nichts gefunden mit diesen Filtern.</translation>
    </message>
    <message>
        <source>Nothing found for “%1”.
Clear the search to see everything.</source>
        <translation>Nichts gefunden für „%1“.
Leeren Sie die Suche, um alles zu sehen.</translation>
    </message>
</context>
<context>
    <name>tiller::FirstSteps</name>
    <message>
        <source>Power on (header)</source>
        <translation>Einschalten (Kopfzeile)</translation>
    </message>
    <message>
        <source>Release brakes (header)</source>
        <translation>Bremsen lösen (Kopfzeile)</translation>
    </message>
    <message>
        <source>Take control and hold a jog button</source>
        <translation>Steuerung übernehmen, Verfahrtaste halten</translation>
    </message>
    <message>
        <source>Teach here (T)</source>
        <translation>Hier teachen (T)</translation>
    </message>
    <message>
        <source>Jog away and hold “Go to” (G)</source>
        <translation>Wegfahren, Anfahren halten (G)</translation>
    </message>
    <message>
        <source>Record (above the plots)</source>
        <translation>Aufzeichnen (über den Diagrammen)</translation>
    </message>
</context>
<context>
    <name>tiller::FirstStepsCard</name>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>Übungsaufgaben</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>The list will not appear again. Use the command “First steps” to reopen it.</source>
        <translation>Die Liste erscheint nicht wieder. Mit dem Befehl „Erste Schritte“ öffnen Sie sie erneut.</translation>
    </message>
    <message>
        <source>First steps · %1 of %2</source>
        <translation>Erste Schritte · %1 von %2</translation>
    </message>
</context>
<context>
    <name>tiller::FrameDetails</name>
    <message>
        <source>Selected frame</source>
        <translation>Gewähltes Koordinatensystem</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>In the base frame. Press Return to apply the values. Only the frame changes; the robot does not move.</source>
        <translation>Im Basis-Koordinatensystem. Mit Enter übernehmen. Nur das Koordinatensystem ändert sich; der Roboter bewegt sich nicht.</translation>
    </message>
    <message>
        <source>not used by any waypoint</source>
        <translation>von keinem Wegpunkt verwendet</translation>
    </message>
    <message numerus="yes">
        <source>used by %n waypoints</source>
        <translation>
            <numerusform>von %n Wegpunkt verwendet</numerusform>
            <numerusform>von %n Wegpunkten verwendet</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the TCP</source>
        <translation>%1 vom TCP</translation>
    </message>
</context>
<context>
    <name>tiller::FrameEditing</name>
    <message>
        <source>No waypoints moved with the frame.</source>
        <translation>Keine Wegpunkte wurden mitbewegt.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints moved with the frame.</source>
        <translation>
            <numerusform>%n Wegpunkt bewegte sich mit ihm.</numerusform>
            <numerusform>%n Wegpunkte bewegten sich mit ihm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Waypoints out of reach: %n.</source>
        <translation>
            <numerusform>Wegpunkte außer Reichweite: %n.</numerusform>
            <numerusform>Wegpunkte außer Reichweite: %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>frame</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>„%1“ teachen</translation>
    </message>
    <message>
        <source>The frame moves by %1 (%2, base frame).</source>
        <translation>Das Koordinatensystem verschiebt sich um %1 (%2, Basis-Koordinatensystem).</translation>
    </message>
    <message>
        <source>No waypoint uses this frame.</source>
        <translation>Kein Wegpunkt verwendet dieses Koordinatensystem.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints move with the frame.</source>
        <translation>
            <numerusform>%n Wegpunkt bewegt sich mit ihm.</numerusform>
            <numerusform>%n Wegpunkte bewegen sich mit ihm.</numerusform>
        </translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>„%1“ nachteachen?</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Nachteachen</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>„%1“ nachteachen</translation>
    </message>
    <message>
        <source>Touched up “%1”</source>
        <translation>„%1“ nachgeteacht</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>„%1“ duplizieren</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>„%1“ löschen?</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints use this frame. They keep their positions and are converted to Base.</source>
        <translation>
            <numerusform>%n Wegpunkt verwendet dieses Koordinatensystem. Er behält seine Position und wird in Basis umgerechnet.</numerusform>
            <numerusform>%n Wegpunkte verwenden dieses Koordinatensystem. Sie behalten ihre Position und werden in Basis umgerechnet.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation>Koordinatensystem löschen</translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation>Pose von „%1“ ändern</translation>
    </message>
    <message>
        <source>The pose of “%1” was changed. %2</source>
        <translation>Die Pose von „%1“ wurde geändert. %2</translation>
    </message>
</context>
<context>
    <name>tiller::FrameModel</name>
    <message>
        <source>Enter a name for the frame.</source>
        <translation>Geben Sie einen Namen für das Koordinatensystem ein.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Blick</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>„%1“ in „%2“ umbenennen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>Ursprung %1</translation>
    </message>
    <message>
        <source>Origin in Base, X Y Z, %1</source>
        <translation>Ursprung in Basis, X Y Z, %1</translation>
    </message>
    <message>
        <source>Rotation, rad</source>
        <translation>Drehung, rad</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Rotation vector in Base, radians</source>
        <translation>Rotationsvektor in Basis, Radiant</translation>
    </message>
    <message>
        <source>Roll, pitch and yaw in Base</source>
        <translation>Roll, Nick und Gier in Basis</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Waypoints that move with the frame</source>
        <translation>Wegpunkte, die sich mit dem Koordinatensystem bewegen</translation>
    </message>
    <message>
        <source>TCP %1</source>
        <translation>TCP %1</translation>
    </message>
    <message>
        <source>Distance from the TCP, %1</source>
        <translation>Abstand vom TCP, %1</translation>
    </message>
    <message>
        <source>“%1” is a built-in frame. Choose a different name.</source>
        <translation>„%1“ ist ein vordefiniertes Koordinatensystem. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>A frame named “%1” already exists. Choose a different name.</source>
        <translation>Ein Koordinatensystem mit dem Namen „%1“ ist bereits vorhanden. Wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>tiller::FrameTable</name>
    <message>
        <source>Frames</source>
        <translation>Koordinatensysteme</translation>
    </message>
</context>
<context>
    <name>tiller::FrameTeacher</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Frame from three points</source>
        <translation>Koordinatensystem aus drei Punkten</translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation>Koordinatensystem abbrechen</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>On +X</source>
        <translation>Auf +X</translation>
    </message>
    <message>
        <source>Towards +Y</source>
        <translation>Richtung +Y</translation>
    </message>
    <message>
        <source>Record the origin at the TCP</source>
        <translation>Den Ursprung hier nehmen</translation>
    </message>
    <message>
        <source>Record the point on +X at the TCP</source>
        <translation>Den Punkt auf +X hier nehmen</translation>
    </message>
    <message>
        <source>Record the point towards +Y at the TCP</source>
        <translation>Den Punkt Richtung +Y hier nehmen</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Nehmen</translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation>Koordinatensystem erstellen</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the point again.</source>
        <translation>Der Roboter hat eine ungültige Position gesendet. Nehmen Sie den Punkt erneut.</translation>
    </message>
    <message>
        <source>The point on +X is only %1 from the origin. Record it again at least %2 away. A larger distance gives more accurate axes.</source>
        <translation>Der Punkt auf +X ist nur %1 vom Ursprung entfernt. Nehmen Sie ihn mindestens %2 entfernt erneut. Ein größerer Abstand ergibt genauere Achsen.</translation>
    </message>
    <message>
        <source>The third point is only %1 from the origin. Record the point again at least %2 away.</source>
        <translation>Der dritte Punkt ist nur %1 vom Ursprung entfernt. Nehmen Sie ihn erneut, mindestens %2 entfernt.</translation>
    </message>
    <message>
        <source>The three points are collinear: the third point is only %1 from the X axis. Record the point again at least %2 towards +Y.</source>
        <translation>Die drei Punkte liegen auf einer Linie: Der dritte ist nur %1 von der X-Achse entfernt. Nehmen Sie ihn mindestens %2 in Richtung +Y erneut.</translation>
    </message>
    <message>
        <source>Ready: the point on +X is %1 from the origin, and the third point is %2 from the X axis.</source>
        <translation>Bereit: Der Punkt auf +X ist %1 vom Ursprung entfernt, der dritte %2 von der X-Achse.</translation>
    </message>
    <message>
        <source>Jog the tip to the origin of the frame and record the point (P).</source>
        <translation>Fahren Sie die Spitze zum Ursprung des Koordinatensystems und nehmen Sie den Punkt (P).</translation>
    </message>
    <message>
        <source>Now jog to a point on +X: %1 from the origin (minimum %2).</source>
        <translation>Fahren Sie nun zu einem Punkt auf +X: %1 vom Ursprung, mindestens %2.</translation>
    </message>
    <message>
        <source>Now jog towards +Y: %1 from the X axis (minimum %2).</source>
        <translation>Fahren Sie nun in Richtung +Y: %1 von der X-Achse, mindestens %2.</translation>
    </message>
    <message>
        <source>Record  P</source>
        <translation>Nehmen  P</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Neu nehmen</translation>
    </message>
</context>
<context>
    <name>tiller::FramesTab</name>
    <message>
        <source>Frames</source>
        <translation>Koordinatensysteme</translation>
    </message>
    <message>
        <source>From TCP</source>
        <translation>Vom TCP</translation>
    </message>
    <message>
        <source>Teach a frame from the TCP</source>
        <translation>Ein Koordinatensystem vom TCP teachen</translation>
    </message>
    <message>
        <source>3 points</source>
        <translation>3 Punkte</translation>
    </message>
    <message>
        <source>Teach a frame from three points</source>
        <translation>Ein Koordinatensystem aus drei Punkten teachen</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Nachteachen</translation>
    </message>
    <message>
        <source>Touch up the frame</source>
        <translation>Das Koordinatensystem nachteachen</translation>
    </message>
    <message>
        <source>More frame commands</source>
        <translation>Weitere Befehle für Koordinatensysteme</translation>
    </message>
    <message>
        <source>No frames yet.
Jog the tip to a corner of the tray or table. Press “From TCP”, or press “3 points” to record the origin, +X and +Y.</source>
        <translation>Noch keine Koordinatensysteme.
Fahren Sie die Spitze an eine Ecke von Tray oder Tisch. Drücken Sie „Vom TCP“ oder „3 Punkte“, um Ursprung, +X und +Y zu nehmen.</translation>
    </message>
    <message>
        <source>new frame</source>
        <translation>neues Koordinatensystem</translation>
    </message>
    <message>
        <source>Create a frame at the TCP with the axes of the tool (Shift+T)</source>
        <translation>Koordinatensystem am TCP mit den Achsen des Werkzeugs erstellen (Umschalt+T)</translation>
    </message>
    <message>
        <source>Create a frame from its origin, a point on +X and a point towards +Y (Ctrl+Shift+T)</source>
        <translation>Koordinatensystem aus Ursprung, einem Punkt auf +X und einem Punkt Richtung +Y anlegen (Strg+Umschalt+T)</translation>
    </message>
    <message>
        <source>Move the selected frame to the TCP (Shift+U)</source>
        <translation>Gewähltes Koordinatensystem zum TCP verschieben (Umschalt+U)</translation>
    </message>
    <message>
        <source>Select a frame to touch up.</source>
        <translation>Wählen Sie ein Koordinatensystem zum Nachteachen.</translation>
    </message>
    <message>
        <source>Teach frame from the TCP</source>
        <translation>Koordinatensystem vom TCP teachen</translation>
    </message>
    <message>
        <source>Teach frame from three points</source>
        <translation>Koordinatensystem aus drei Punkten teachen</translation>
    </message>
    <message>
        <source>Record the next point of the frame</source>
        <translation>Den nächsten Punkt des Koordinatensystems nehmen</translation>
    </message>
    <message>
        <source>Create frame from points</source>
        <translation>Koordinatensystem aus Punkten erstellen</translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation>Teachen des Koordinatensystems abbrechen</translation>
    </message>
    <message>
        <source>Touch up frame from the TCP</source>
        <translation>Koordinatensystem vom TCP nachteachen</translation>
    </message>
    <message>
        <source>Touch up frame from three points</source>
        <translation>Koordinatensystem aus drei Punkten nachteachen</translation>
    </message>
    <message>
        <source>Jog in this frame</source>
        <translation>In diesem Koordinatensystem verfahren</translation>
    </message>
    <message>
        <source>Rename frame</source>
        <translation>Koordinatensystem umbenennen</translation>
    </message>
    <message>
        <source>Duplicate frame</source>
        <translation>Koordinatensystem duplizieren</translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation>Koordinatensystem löschen</translation>
    </message>
    <message>
        <source>Touch up “%1” from three points</source>
        <translation>„%1“ aus drei Punkten nachteachen</translation>
    </message>
    <message>
        <source>New frame from three points</source>
        <translation>Neues Koordinatensystem aus drei Punkten</translation>
    </message>
    <message>
        <source>Touch up…</source>
        <translation>Nachteachen…</translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation>Koordinatensystem erstellen</translation>
    </message>
    <message>
        <source>Edit frame values</source>
        <translation>Werte des Koordinatensystems bearbeiten</translation>
    </message>
</context>
<context>
    <name>tiller::GoThroughBar</name>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Run the route</source>
        <translation>Die Route abfahren</translation>
    </message>
    <message>
        <source>Run route (hold)</source>
        <translation>Route (halten)</translation>
    </message>
    <message>
        <source>Run route, hold</source>
        <translation>Route abfahren, halten</translation>
    </message>
    <message>
        <source>Previous waypoint, hold</source>
        <translation>Voriger Wegpunkt, halten</translation>
    </message>
    <message>
        <source>Moves to the previous waypoint while the button is held</source>
        <translation>Fährt zum vorigen Wegpunkt, solange die Taste gehalten wird</translation>
    </message>
    <message>
        <source>Next waypoint, hold</source>
        <translation>Nächster Wegpunkt, halten</translation>
    </message>
    <message>
        <source>Moves to the next waypoint while the button is held, then stops</source>
        <translation>Fährt zum nächsten Wegpunkt, solange die Taste gehalten wird, und stoppt dort</translation>
    </message>
    <message>
        <source>Route waypoints</source>
        <translation>Wegpunkte der Route</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Welche Wegpunkte</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>Von hier</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>After the last waypoint, continues with the first waypoint while the button is held</source>
        <translation>Beginnt nach dem letzten wieder beim ersten Wegpunkt, solange die Taste gehalten wird</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller hat nicht die Steuerung. Übernehmen Sie zuerst die Steuerung.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Next: %1 of %2, %3</source>
        <translation>Nächster: %1 von %2, %3</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>Done. The next press starts at the first waypoint.</source>
        <translation>Fertig. Der nächste Tastendruck beginnt beim ersten Wegpunkt.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n Wegpunkt</numerusform>
            <numerusform>%n Wegpunkte</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Moves from waypoint to waypoint while the button is held, no faster than the jog speed, and runs the actions of each waypoint. Release to pause; the next press continues to the next waypoint.</source>
        <translation>Fährt von Wegpunkt zu Wegpunkt, solange die Taste gehalten wird, höchstens mit der Verfahrgeschwindigkeit, und führt die Aktionen jedes Wegpunkts aus. Loslassen pausiert; der nächste Druck fährt zum nächsten Wegpunkt weiter.</translation>
    </message>
    <message>
        <source>At %1: %2</source>
        <translation>An %1: %2</translation>
    </message>
    <message>
        <source>Selects the waypoints to run, in list order</source>
        <translation>Wählt die Wegpunkte der Route in der Reihenfolge der Liste</translation>
    </message>
</context>
<context>
    <name>tiller::GoToButton</name>
    <message>
        <source>Go to (hold)  G</source>
        <translation>Anfahren (halten)  G</translation>
    </message>
    <message>
        <source>Go to, hold</source>
        <translation>Anfahren, halten</translation>
    </message>
    <message>
        <source>Moves the arm to the selected waypoint while the button or G is held, no faster than the jog speed</source>
        <translation>Bewegt den Arm zum gewählten Wegpunkt, solange die Taste oder G gehalten wird, nicht schneller als die Verfahrgeschwindigkeit</translation>
    </message>
</context>
<context>
    <name>tiller::GripperPanel</name>
    <message>
        <source>Gripper state</source>
        <translation>Zustand des Greifers</translation>
    </message>
    <message>
        <source>Gripper opening</source>
        <translation>Greiferöffnung</translation>
    </message>
    <message>
        <source>Gripped object</source>
        <translation>Gegriffenes Objekt</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>Aktivieren</translation>
    </message>
    <message>
        <source>Activate the gripper</source>
        <translation>Den Greifer aktivieren</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation>Den Greifer öffnen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation>Den Greifer schließen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation>Greifer: öffnen</translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation>Greifer: schließen</translation>
    </message>
    <message>
        <source>Gripper: move to %1</source>
        <translation>Greifer: auf %1 fahren</translation>
    </message>
    <message>
        <source>Gripper type</source>
        <translation>Greifertyp</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>Robotiq %1</source>
        <translation>Robotiq %1</translation>
    </message>
    <message>
        <source>One output: on = closed</source>
        <translation>Ein Ausgang: ein = zu</translation>
    </message>
    <message>
        <source>Two outputs: open, close</source>
        <translation>Zwei Ausgänge: öffnen, schließen</translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation>Ausgang zum Schließen</translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation>Ausgang zum Öffnen</translation>
    </message>
    <message>
        <source>Target opening</source>
        <translation>Zielöffnung</translation>
    </message>
    <message>
        <source>Finger speed</source>
        <translation>Fingergeschwindigkeit</translation>
    </message>
    <message>
        <source>Finger force</source>
        <translation>Fingerkraft</translation>
    </message>
    <message>
        <source>Suggested action</source>
        <translation>Vorgeschlagene Aktion</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Target opening of the fingers, 0 to %1. “Move” starts the motion.</source>
        <translation>Zielöffnung der Finger, 0 bis %1. „Bewegen“ startet die Bewegung.</translation>
    </message>
    <message>
        <source>Speed of the next motion. 0 % is about %1, 100 % about %2.</source>
        <translation>Geschwindigkeit der nächsten Bewegung. 0 % sind etwa %1, 100 % etwa %2.</translation>
    </message>
    <message>
        <source>Force of the next grip. 0 % is about %1, 100 % about %2.</source>
        <translation>Kraft des nächsten Griffs. 0 % sind etwa %1, 100 % etwa %2.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Gripper set to %1</source>
        <translation>Greifer eingestellt: %1</translation>
    </message>
    <message>
        <source>%1 (speed %2, force %3)</source>
        <translation>%1 (Geschwindigkeit %2, Kraft %3)</translation>
    </message>
    <message>
        <source>Please wait…</source>
        <translation>Bitte warten…</translation>
    </message>
    <message>
        <source>Select the mounted gripper. The choice is stored for this robot.</source>
        <translation>Wählen Sie den montierten Greifer. Die Auswahl wird für diesen Roboter gespeichert.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>activating…</source>
        <translation>wird aktiviert…</translation>
    </message>
    <message>
        <source>not active</source>
        <translation>nicht aktiv</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>steht aus…</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>bewegt sich</translation>
    </message>
    <message>
        <source>active, at standstill</source>
        <translation>aktiv, im Stillstand</translation>
    </message>
    <message>
        <source>unknown while moving</source>
        <translation>während der Bewegung unbekannt</translation>
    </message>
    <message>
        <source>The gripper is not available with this port offset. Use a smaller port offset.</source>
        <translation>Der Greifer ist mit diesem Port-Versatz nicht verfügbar. Verwenden Sie einen kleineren Port-Versatz.</translation>
    </message>
    <message>
        <source>Activating: the fingers open and close once.</source>
        <translation>Wird aktiviert: Die Finger öffnen und schließen einmal.</translation>
    </message>
    <message>
        <source>Activate the gripper first.</source>
        <translation>Aktivieren Sie zuerst den Greifer.</translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation>Der Greifer ist aktiv.</translation>
    </message>
    <message>
        <source>The fingers open and close once and drop any gripped object. Keep your fingers clear of the gripper.</source>
        <translation>Die Finger öffnen und schließen einmal und lassen ein gegriffenes Objekt fallen. Halten Sie Ihre Finger vom Greifer fern.</translation>
    </message>
    <message>
        <source>Opens the gripper and releases the object.</source>
        <translation>Öffnet den Greifer und lässt das Objekt los.</translation>
    </message>
    <message>
        <source>Closes the gripper. Keep your fingers clear of the gripper.</source>
        <translation>Schließt den Greifer. Halten Sie Ihre Finger fern.</translation>
    </message>
    <message>
        <source>The gripper did not execute the command. Check that no other program controls the gripper, then try again.</source>
        <translation>Der Greifer hat den Befehl nicht ausgeführt. Prüfen Sie, dass kein anderes Programm den Greifer steuert, und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>Gripper: stop</source>
        <translation>Greifer: anhalten</translation>
    </message>
    <message>
        <source>Move the fingers to the target opening</source>
        <translation>Die Finger auf die Zielöffnung bewegen</translation>
    </message>
    <message>
        <source>Closed by</source>
        <translation>Schließt</translation>
    </message>
    <message>
        <source>Opened by</source>
        <translation>Öffnet</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Connect to a robot first. Tiller stores the gripper selection for each robot.</source>
        <translation>Verbinden Sie sich zuerst mit einem Roboter. Tiller speichert die Auswahl des Greifers für jeden Roboter.</translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation>Der Roboter sendet keine Daten. Warten Sie auf Daten oder verbinden Sie neu.</translation>
    </message>
    <message>
        <source>external grip</source>
        <translation>Außengriff</translation>
    </message>
    <message>
        <source>internal grip</source>
        <translation>Innengriff</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Stopping the arm does not open the gripper.</source>
        <translation>Das Stoppen des Arms öffnet den Greifer nicht.</translation>
    </message>
    <message>
        <source>Moves the fingers to the target opening.</source>
        <translation>Bewegt die Finger auf die Zielöffnung.</translation>
    </message>
    <message>
        <source>Speed or force is out of range. Enter a value from 0 to 100 %.</source>
        <translation>Geschwindigkeit oder Kraft liegt außerhalb des Bereichs. Geben Sie 0 bis 100 % ein.</translation>
    </message>
</context>
<context>
    <name>tiller::HeaderBar</name>
    <message>
        <source>ROBOT</source>
        <translation>ROBOTER</translation>
    </message>
    <message>
        <source>ROBOT MODE</source>
        <translation>ROBOTERMODUS</translation>
    </message>
    <message>
        <source>SAFETY</source>
        <translation>SICHERHEIT</translation>
    </message>
    <message>
        <source>CONTROL</source>
        <translation>STEUERUNG</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>LINK</translation>
    </message>
    <message>
        <source>LAST STOP</source>
        <translation>LETZTER STOPP</translation>
    </message>
    <message>
        <source>Robot state</source>
        <translation>Zustand des Roboters</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>KEINE DATEN</translation>
    </message>
    <message>
        <source>LAST STOP · no key check</source>
        <translation>LETZTER STOPP · keine Tastenprüfung</translation>
    </message>
    <message>
        <source>%1 ms · %2</source>
        <translation>%1 ms · %2</translation>
    </message>
    <message>
        <source>Measured from the stop command to standstill. Cause: %1</source>
        <translation>Gemessen vom Stoppbefehl bis zum Stillstand. Ursache: %1</translation>
    </message>
    <message>
        <source>No stop measured yet</source>
        <translation>Noch kein Stopp gemessen</translation>
    </message>
    <message>
        <source>▲ Speed cap raised to %1</source>
        <translation>▲ Geschwindigkeitsgrenze auf %1 erhöht</translation>
    </message>
    <message>
        <source>The arm may move faster than %1. Lower the speed cap in Settings. The cap is reset when Tiller is closed.</source>
        <translation>Der Arm kann sich schneller als %1 bewegen. Senken Sie die Geschwindigkeitsgrenze in den Einstellungen. Beim Schließen von Tiller wird sie zurückgesetzt.</translation>
    </message>
    <message>
        <source>MONITOR ONLY</source>
        <translation>NUR BEOBACHTEN</translation>
    </message>
    <message>
        <source>Cause: %1 (%2)</source>
        <translation>Ursache: %1 (%2)</translation>
    </message>
    <message>
        <source>The program was stopped on the robot, so the stop could not be measured.</source>
        <translation>Das Programm wurde am Roboter gestoppt, daher konnte der Stopp nicht gemessen werden.</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Nicht gemessen</translation>
    </message>
    <message>
        <source>The robot stopped sending data while the arm was moving, so the stop could not be measured.</source>
        <translation>Der Roboter hat während der Bewegung des Arms keine Daten mehr gesendet: Der Stopp konnte nicht gemessen werden.</translation>
    </message>
    <message>
        <source>Not stopped</source>
        <translation>Nicht gestoppt</translation>
    </message>
</context>
<context>
    <name>tiller::HoldRules</name>
    <message>
        <source>The window was not active. Press again.</source>
        <translation>Das Fenster war nicht aktiv. Drücken Sie erneut.</translation>
    </message>
    <message>
        <source>Click in the window first.</source>
        <translation>Klicken Sie zuerst in das Fenster.</translation>
    </message>
    <message>
        <source>A dialog or a menu is open. Close it first.</source>
        <translation>Ein Dialog oder Menü ist offen. Schließen Sie es zuerst.</translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation>Eine andere Taste wird bereits gehalten. Lassen Sie sie zuerst los.</translation>
    </message>
    <message>
        <source>The display server does not respond, so Tiller cannot detect the release of a button or key. Release the button or key, then try again.</source>
        <translation>Der Display-Server antwortet nicht: Das Loslassen einer Taste kann nicht erkannt werden. Lassen Sie sie los und versuchen Sie es erneut.</translation>
    </message>
</context>
<context>
    <name>tiller::HoldToRunButton</name>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>Hold this button. The arm moves only while the button is held.</source>
        <translation>Halten Sie diese Taste: Der Arm bewegt sich nur, solange sie gehalten wird.</translation>
    </message>
</context>
<context>
    <name>tiller::ImportReport</name>
    <message>
        <source>Steps: %1. Kept as URScript text: %2. Not imported: %3. New waypoints: %4.</source>
        <translation>Schritte: %1. Als URScript-Text übernommen: %2. Nicht importiert: %3. Neue Wegpunkte: %4.</translation>
    </message>
    <message>
        <source>Imported program</source>
        <translation>Importiertes Programm</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Node or statement</source>
        <translation>Knoten oder Anweisung</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Import report for “%1”</source>
        <translation>Importbericht für „%1“</translation>
    </message>
</context>
<context>
    <name>tiller::IncidentWatch</name>
    <message>
        <source>protective stop</source>
        <translation>Schutzstopp</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
    <message>
        <source>safety violation</source>
        <translation>Sicherheitsverletzung</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>The incident (%1) could not be recorded.</source>
        <translation>Der Vorfall (%1) konnte nicht aufgezeichnet werden.</translation>
    </message>
    <message>
        <source>Incident recorded: %1</source>
        <translation>Vorfall aufgezeichnet: %1</translation>
    </message>
    <message>
        <source>The recording %2 starts %1 s before the stop. Double-click this entry to open the recording.</source>
        <translation>Die Aufzeichnung %2 beginnt %1 s vor dem Stopp. Doppelklicken Sie auf diesen Eintrag, um sie zu öffnen.</translation>
    </message>
</context>
<context>
    <name>tiller::IoChannel</name>
    <message>
        <source>no data</source>
        <translation>keine Daten</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>steht aus…</translation>
    </message>
    <message>
        <source>%1, outdated</source>
        <translation>%1, veraltet</translation>
    </message>
    <message>
        <source>Pulse</source>
        <translation>Puls</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Name von %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>
The output cannot be switched while the robot is not sending data.</source>
        <translation>
Der Ausgang kann nicht geschaltet werden, solange der Roboter keine Daten sendet.</translation>
    </message>
    <message>
        <source>
Click to switch the output %1. Press P to pulse it. Right-click to pulse or rename it.</source>
        <translation>
Klicken schaltet: %1. P: Impuls. Rechtsklick: Impuls oder Umbenennen.</translation>
    </message>
    <message>
        <source>
Right-click or press F2 to rename the input.</source>
        <translation>
Zum Umbenennen rechts klicken oder F2 drücken.</translation>
    </message>
</context>
<context>
    <name>tiller::IoPages</name>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Greifer</translation>
    </message>
    <message>
        <source>I/O page</source>
        <translation>E/A-Seite</translation>
    </message>
</context>
<context>
    <name>tiller::IoTab</name>
    <message>
        <source>Inputs and outputs</source>
        <translation>Ein- und Ausgänge</translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation>Ein- und Ausgänge suchen</translation>
    </message>
    <message>
        <source>Search by terminal or name</source>
        <translation>Nach Klemme oder Namen suchen</translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation>Digitale Ausgänge</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>Digitale Eingänge</translation>
    </message>
    <message>
        <source>Configurable outputs</source>
        <translation>Konfigurierbare Ausgänge</translation>
    </message>
    <message>
        <source>Configurable inputs</source>
        <translation>Konfigurierbare Eingänge</translation>
    </message>
    <message>
        <source>Tool outputs</source>
        <translation>Werkzeugausgänge</translation>
    </message>
    <message>
        <source>Tool inputs</source>
        <translation>Werkzeugeingänge</translation>
    </message>
    <message>
        <source>Press the Tab key to select a row on the I/O tab first.</source>
        <translation>Wählen Sie zuerst mit der Tabulatortaste eine Zeile im Register E/A.</translation>
    </message>
    <message>
        <source>The robot did not confirm %1</source>
        <translation>Der Roboter hat %1 nicht bestätigt</translation>
    </message>
    <message>
        <source>Analog</source>
        <translation>Analog</translation>
    </message>
    <message>
        <source>General purpose registers</source>
        <translation>Allgemeine Register</translation>
    </message>
    <message>
        <source>Replay is active. Press “Back to live” first.</source>
        <translation>Die Wiedergabe ist aktiv. Drücken Sie zuerst „Zurück zu Live“.</translation>
    </message>
    <message>
        <source>%1 cannot be pulsed now</source>
        <translation>%1 kann jetzt keinen Impuls geben</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>controlled by another program</source>
        <translation>von einem anderen Programm gesteuert</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>Another program or the installation may control the output. Check both, then switch the output again.</source>
        <translation>Möglicherweise steuert ihn ein anderes Programm oder die Installation. Prüfen Sie beides und schalten Sie den Ausgang dann erneut.</translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation>Der Roboter sendet keine Daten. Warten Sie auf Daten oder verbinden Sie neu.</translation>
    </message>
</context>
<context>
    <name>tiller::JogColumn</name>
    <message>
        <source>Jog</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Hold to move</source>
        <translation>Halten zum Bewegen</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Pose or joints</source>
        <translation>Pose oder Gelenke</translation>
    </message>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation>Es gibt keine Bahn zum Zurückfahren. Verfahren Sie zuerst den Arm.</translation>
    </message>
    <message>
        <source>release and press again</source>
        <translation>loslassen und erneut drücken</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>Freedrive</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>Moves all joints to the home position while the button is held</source>
        <translation>Bewegt alle Gelenke zur Home-Position, solange gehalten</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Aligns the tool with the nearest axis of the selected frame while the button is held</source>
        <translation>Richtet das Werkzeug an der nächsten Achse des gewählten Koordinatensystems aus, solange gehalten</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Retraces the last motion while the button is held</source>
        <translation>Fährt die letzte Bewegung zurück, solange gehalten</translation>
    </message>
    <message>
        <source>home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>ausgerichtet</translation>
    </message>
    <message>
        <source>Ends in %1 s</source>
        <translation>Endet in %1 s</translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation>Eine andere Taste wird bereits gehalten. Lassen Sie sie zuerst los.</translation>
    </message>
    <message>
        <source>Last stop: %1, standstill after %2 ms, %3</source>
        <translation>Letzter Stopp: %1, Stillstand nach %2 ms, %3</translation>
    </message>
    <message>
        <source>Move the arm by hand while this button is held: %1. Right-click to select axes.</source>
        <translation>Bewegen Sie den Arm von Hand, solange diese Taste gehalten wird: %1. Rechtsklick wählt Achsen.</translation>
    </message>
    <message>
        <source>Freedrive, %1</source>
        <translation>Freedrive, %1</translation>
    </message>
    <message>
        <source>Freedrive…</source>
        <translation>Freedrive…</translation>
    </message>
    <message>
        <source>Check payload before Freedrive (resets on reconnect)</source>
        <translation>Nutzlast vor Freedrive prüfen (wird bei neuer Verbindung zurückgesetzt)</translation>
    </message>
    <message>
        <source>Last stop: not measured (data lost)</source>
        <translation>Letzter Stopp: nicht gemessen (Daten fehlen)</translation>
    </message>
    <message>
        <source>Press for one step</source>
        <translation>Drücken: ein Schritt</translation>
    </message>
    <message>
        <source>Last stop: %1 (%2)</source>
        <translation>Letzter Stopp: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>tiller::JogKey</name>
    <message>
        <source>%1 left in this direction</source>
        <translation>noch %1 in dieser Richtung</translation>
    </message>
</context>
<context>
    <name>tiller::JogPad</name>
    <message>
        <source>Jog buttons</source>
        <translation>Verfahrtasten</translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation>Fahren %1</translation>
    </message>
</context>
<context>
    <name>tiller::JogSelectors</name>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Blick</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Moves while the button is held</source>
        <translation>Bewegt, solange die Taste gehalten wird</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Rotates while the button is held</source>
        <translation>Dreht, solange die Taste gehalten wird</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>View axes: X right, Y away from you, Z up</source>
        <translation>Achsen der Ansicht: X rechts, Y von Ihnen weg, Z nach oben</translation>
    </message>
    <message>
        <source>Requires the 3D view</source>
        <translation>Braucht die 3D-Ansicht</translation>
    </message>
    <message>
        <source>No frame taught yet. Teach a frame on the Frames tab.</source>
        <translation>Noch kein Koordinatensystem geteacht. Teachen Sie eines im Register Koordinatensysteme.</translation>
    </message>
    <message>
        <source>Moves by %1 per press.</source>
        <translation>Bewegt je Tastendruck um %1.</translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press.</source>
        <translation>Dreht Werkzeug oder Gelenk je Tastendruck um %1.</translation>
    </message>
    <message>
        <source>≤ %1</source>
        <translation>≤ %1</translation>
    </message>
    <message>
        <source>Moves slowly while the button is held, until the contact force reaches %1 N. Click again to select a different step.</source>
        <translation>Bewegt langsam, solange gehalten, bis die Kontaktkraft %1 N erreicht. Erneut klicken, um einen anderen Schritt zu wählen.</translation>
    </message>
    <message>
        <source>Moves by %1 per press. Click again to select a different step.</source>
        <translation>Bewegt je Tastendruck um %1. Erneut klicken, um einen anderen Schritt zu wählen.</translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press. Click again to select a different angle.</source>
        <translation>Dreht Werkzeug oder Gelenk je Tastendruck um %1. Erneut klicken, um einen anderen Winkel zu wählen.</translation>
    </message>
    <message>
        <source>%1 · rotation %2 · joints %3 · Ctrl × 0.1, Shift × 3</source>
        <translation>%1 · Drehung %2 · Gelenke %3 · Strg × 0,1, Umschalt × 3</translation>
    </message>
    <message>
        <source>Other angle…</source>
        <translation>Anderer Winkel…</translation>
    </message>
    <message>
        <source>Other step…</source>
        <translation>Anderer Schritt…</translation>
    </message>
    <message>
        <source>Until contact, %1 N</source>
        <translation>Bis Kontakt, %1 N</translation>
    </message>
    <message>
        <source>Other contact force…</source>
        <translation>Andere Kontaktkraft…</translation>
    </message>
    <message>
        <source>Other speed…</source>
        <translation>Andere Geschwindigkeit…</translation>
    </message>
    <message>
        <source>Step in %1</source>
        <translation>Schritt in %1</translation>
    </message>
    <message>
        <source>Angle in degrees</source>
        <translation>Winkel in Grad</translation>
    </message>
    <message>
        <source>TCP speed in %1</source>
        <translation>TCP-Geschwindigkeit in %1</translation>
    </message>
    <message>
        <source>Contact force that ends the motion, in N</source>
        <translation>Kontaktkraft in N, bei der die Bewegung endet</translation>
    </message>
    <message>
        <source>The step continues after the button is released. Space, Esc and STOP end the step.</source>
        <translation>Der Schritt läuft nach dem Loslassen weiter. Leertaste, Esc und STOP beenden ihn.</translation>
    </message>
    <message>
        <source>Hold the button until the step is complete.</source>
        <translation>Halten Sie die Taste gedrückt, bis der Schritt beendet ist.</translation>
    </message>
</context>
<context>
    <name>tiller::JointRow</name>
    <message>
        <source>%1 minus</source>
        <translation>%1 minus</translation>
    </message>
    <message>
        <source>%1 plus</source>
        <translation>%1 plus</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>tiller::JointRows</name>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
</context>
<context>
    <name>tiller::KeyboardJog</name>
    <message>
        <source>Keyboard jogging is armed</source>
        <translation>Tastatur-Verfahren ist scharf</translation>
    </message>
</context>
<context>
    <name>tiller::LimiterLine</name>
    <message>
        <source>Limiter</source>
        <translation>Begrenzung</translation>
    </message>
</context>
<context>
    <name>tiller::LimitsDialog</name>
    <message>
        <source>Limits of the value axis</source>
        <translation>Grenzen der Werteachse</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>%1, minimum</source>
        <translation>%1, Minimum</translation>
    </message>
    <message>
        <source>%1, maximum</source>
        <translation>%1, Maximum</translation>
    </message>
    <message>
        <source>%1: enter two numbers. The minimum must be less than the maximum.</source>
        <translation>%1: Geben Sie zwei Zahlen ein. Das Minimum muss kleiner als das Maximum sein.</translation>
    </message>
</context>
<context>
    <name>tiller::LogModel</name>
    <message>
        <source>Info</source>
        <translation>Info</translation>
    </message>
    <message>
        <source>▲ Warning</source>
        <translation>▲ Warnung</translation>
    </message>
    <message>
        <source>⬣ Error</source>
        <translation>⬣ Fehler</translation>
    </message>
    <message>
        <source>Tiller</source>
        <translation>Tiller</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Schwere</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open the recording of this incident at the time of the stop</source>
        <translation>Aufzeichnung dieses Vorfalls zum Zeitpunkt des Stopps öffnen</translation>
    </message>
    <message>
        <source>Open the recording at this time</source>
        <translation>Aufzeichnung an diesem Zeitpunkt öffnen</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>%1 · Origin: %2</source>
        <translation>%1 · Ursprung: %2</translation>
    </message>
    <message>
        <source>%1 times between %2 and %3 · Origin: %4</source>
        <translation>%1-mal von %2 bis %3 · Ursprung: %4</translation>
    </message>
    <message>
        <source>(×%1, last at %2) %3</source>
        <translation>(×%1, zuletzt %2) %3</translation>
    </message>
</context>
<context>
    <name>tiller::LogTab</name>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Minimum severity</source>
        <translation>Mindestschwere</translation>
    </message>
    <message>
        <source>Filter the log by text</source>
        <translation>Protokoll nach Text filtern</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected entries, or all visible entries (Ctrl+C)</source>
        <translation>Gewählte oder alle sichtbaren Einträge kopieren (Strg+C)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Write the visible entries to a file</source>
        <translation>Sichtbare Einträge in eine Datei schreiben</translation>
    </message>
    <message>
        <source>Details of the selected entry</source>
        <translation>Details des gewählten Eintrags</translation>
    </message>
    <message>
        <source>Export the log</source>
        <translation>Das Protokoll exportieren</translation>
    </message>
    <message>
        <source>Text file (*.txt)</source>
        <translation>Textdatei (*.txt)</translation>
    </message>
    <message>
        <source>Log written to %1</source>
        <translation>Protokoll geschrieben nach %1</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Open the recording of the selected entry</source>
        <translation>Aufzeichnung des gewählten Eintrags öffnen</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Notiz: %1</translation>
    </message>
</context>
<context>
    <name>tiller::MetadataDialog</name>
    <message>
        <source>Ask before each recording</source>
        <translation>Vor jeder Aufzeichnung fragen</translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation>Metadaten der Aufzeichnungen</translation>
    </message>
    <message>
        <source>Tiller stores the fields with a value in each recording. The names and values are kept for the next recording.</source>
        <translation>Tiller speichert die Felder mit einem Wert in jeder Aufzeichnung. Namen und Werte bleiben für die nächste Aufzeichnung erhalten.</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>Metadaten</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Add field</source>
        <translation>Feld hinzufügen</translation>
    </message>
    <message>
        <source>Remove field</source>
        <translation>Feld entfernen</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>The value “%1” has no name. Enter a name.</source>
        <translation>Der Wert „%1“ hat keinen Namen. Geben Sie einen Namen ein.</translation>
    </message>
    <message>
        <source>The name “%1” is not valid. Use letters, digits, spaces and _ - . (at most 60).</source>
        <translation>Der Name „%1“ ist ungültig. Verwenden Sie Buchstaben, Ziffern, Leerzeichen und _ - . (höchstens 60).</translation>
    </message>
    <message>
        <source>Tiller stores “%1” itself. Choose another name.</source>
        <translation>Tiller speichert „%1“ selbst. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The name “%1” occurs twice. Choose another name.</source>
        <translation>Der Name „%1“ kommt doppelt vor. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The value of “%1” must be one line of at most %2 characters.</source>
        <translation>Der Wert von „%1“ muss eine Zeile mit höchstens %2 Zeichen sein.</translation>
    </message>
    <message>
        <source>Remove fields: at most %1 fields are possible.</source>
        <translation>Entfernen Sie Felder: höchstens %1 Felder sind möglich.</translation>
    </message>
</context>
<context>
    <name>tiller::MoveWords</name>
    <message>
        <source>%1 collides with %2 after %3 of the path</source>
        <translation>%1 kollidiert nach %3 der Bahn mit %2</translation>
    </message>
    <message>
        <source>The move enters the wrist singularity after %1 of the path</source>
        <translation>Die Bahn erreicht nach %1 ihrer Länge die Handgelenk-Singularität</translation>
    </message>
    <message>
        <source>The move slows down near the wrist singularity at %1 of the path</source>
        <translation>Langsam nahe der Handgelenk-Singularität bei %1 der Bahn</translation>
    </message>
    <message>
        <source>The move enters the elbow singularity after %1 of the path</source>
        <translation>Die Bahn erreicht nach %1 ihrer Länge die Ellbogen-Singularität</translation>
    </message>
    <message>
        <source>The move slows down near the elbow singularity at %1 of the path</source>
        <translation>Langsam nahe der Ellbogen-Singularität bei %1 der Bahn</translation>
    </message>
    <message>
        <source>The move enters the shoulder singularity after %1 of the path</source>
        <translation>Die Bahn erreicht nach %1 ihrer Länge die Schulter-Singularität</translation>
    </message>
    <message>
        <source>The move slows down near the shoulder singularity at %1 of the path</source>
        <translation>Langsam nahe der Schulter-Singularität bei %1 der Bahn</translation>
    </message>
    <message>
        <source>A joint would have to jump after %1 of the path</source>
        <translation>Nach %1 der Bahn müsste ein Gelenk springen</translation>
    </message>
    <message>
        <source>%1 exceeds its limit after %2 of the path</source>
        <translation>%1 überschreitet nach %2 der Bahn seinen Bereich</translation>
    </message>
    <message>
        <source>The move leaves the reach of the arm after %1 of the path</source>
        <translation>Die Bahn verlässt nach %1 ihrer Länge die Reichweite des Arms</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>Upper arm</source>
        <translation>Oberarm</translation>
    </message>
    <message>
        <source>Forearm</source>
        <translation>Unterarm</translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation>Handgelenk 1</translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation>Handgelenk 2</translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation>Handgelenk 3</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>%1 is in contact with %2, and the move reduces the distance</source>
        <translation>%1 berührt %2, und die Bewegung verringert den Abstand</translation>
    </message>
    <message>
        <source>%1 is only %2 from %3, and the move reduces the distance</source>
        <translation>%1 ist nur %2 von %3 entfernt, und die Bewegung verringert den Abstand</translation>
    </message>
    <message>
        <source>%1 comes within %2 of %3 after %4 of the path</source>
        <translation>%1 kommt nach %4 der Bahn näher als %2 an %3</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>dem Boden</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>The position of “%1” is unknown because its frame is not in the project. Enter its position, turn off its collision check, or delete it on the Cell page</source>
        <translation>Die Position von „%1“ ist unbekannt, weil ihr Koordinatensystem nicht im Projekt ist. Geben Sie die Position auf der Seite „Zelle“ ein, schalten Sie die Kollisionsprüfung des Objekts aus oder löschen Sie es dort</translation>
    </message>
</context>
<context>
    <name>tiller::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Notice action</source>
        <translation>Aktion des Hinweises</translation>
    </message>
    <message>
        <source>Second notice action</source>
        <translation>Zweite Aktion des Hinweises</translation>
    </message>
</context>
<context>
    <name>tiller::OpenTableDialog</name>
    <message>
        <source>Open table</source>
        <translation>Tabelle öffnen</translation>
    </message>
    <message>
        <source>Tiller cannot determine the times of the rows in %1. Select how to read the table.</source>
        <translation>Tiller kann die Zeiten der Zeilen in %1 nicht bestimmen. Wählen Sie, wie die Tabelle gelesen werden soll.</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>Erste Zeilen der Datei</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>Zeitspalte</translation>
    </message>
    <message>
        <source>No time column</source>
        <translation>Keine Zeitspalte</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>Zeiteinheit</translation>
    </message>
    <message>
        <source>Rows per second</source>
        <translation>Zeilen pro Sekunde</translation>
    </message>
    <message>
        <source>Column separator</source>
        <translation>Spaltentrennzeichen</translation>
    </message>
    <message>
        <source>Comma</source>
        <translation>Komma</translation>
    </message>
    <message>
        <source>Semicolon</source>
        <translation>Semikolon</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tabulator</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leerzeichen</translation>
    </message>
    <message>
        <source>Decimal separator</source>
        <translation>Dezimaltrennzeichen</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>First row</source>
        <translation>Erste Zeile</translation>
    </message>
    <message>
        <source>Column names</source>
        <translation>Spaltennamen</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Reason: %1</source>
        <translation>Grund: %1</translation>
    </message>
    <message>
        <source>Detect automatically</source>
        <translation>Automatisch erkennen</translation>
    </message>
</context>
<context>
    <name>tiller::PartModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
</context>
<context>
    <name>tiller::PartPage</name>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
</context>
<context>
    <name>tiller::PathControls</name>
    <message>
        <source>Path tolerance</source>
        <translation>Bahntoleranz</translation>
    </message>
    <message>
        <source>Record path</source>
        <translation>Bahn aufzeichnen</translation>
    </message>
    <message>
        <source>Export path as CSV…</source>
        <translation>Bahn als CSV exportieren…</translation>
    </message>
    <message>
        <source>Import path from CSV…</source>
        <translation>Bahn aus CSV importieren…</translation>
    </message>
    <message>
        <source>The path recorded so far is kept.</source>
        <translation>Die bisher aufgezeichnete Bahn bleibt erhalten.</translation>
    </message>
    <message>
        <source>Stop recording path</source>
        <translation>Bahnaufzeichnung beenden</translation>
    </message>
    <message>
        <source>Simplifying the path…</source>
        <translation>Die Bahn wird vereinfacht…</translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation>Ohne Daten vom Roboter kann keine Bahn aufgezeichnet werden. Warten Sie auf Daten, oder verbinden Sie einen Roboter.</translation>
    </message>
    <message>
        <source>Stops recording and stores the path as waypoints</source>
        <translation>Beendet die Aufzeichnung und speichert die Bahn als Wegpunkte</translation>
    </message>
    <message>
        <source>Records the path of the arm during Freedrive or jogging and stores it as waypoints. Press again to stop. Recording does not move the robot.</source>
        <translation>Zeichnet die Bahn des Arms bei Freedrive oder Verfahren auf und speichert sie als Wegpunkte. Zum Beenden erneut drücken. Der Roboter bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation>Wählen Sie mindestens zwei Wegpunkte der Bahn.</translation>
    </message>
    <message>
        <source>Export path</source>
        <translation>Bahn exportieren</translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation>CSV-Datei (*.csv)</translation>
    </message>
    <message>
        <source>The path was not exported.</source>
        <translation>Die Bahn wurde nicht exportiert.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints exported as a path to %1</source>
        <translation>
            <numerusform>%n Wegpunkt als Bahn nach %1 geschrieben</numerusform>
            <numerusform>%n Wegpunkte als Bahn nach %1 geschrieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Import path</source>
        <translation>Bahn importieren</translation>
    </message>
    <message>
        <source>○ Path</source>
        <translation>○ Bahn</translation>
    </message>
    <message>
        <source>The path of the arm is being recorded. To stop recording, press “● REC” or select “Stop recording path” in the menu.</source>
        <translation>Die Bahn des Arms wird aufgezeichnet. Zum Beenden drücken Sie „● REC“ oder wählen im Menü „Bahnaufzeichnung beenden“.</translation>
    </message>
    <message>
        <source>Path recording stopped because the maximum duration of ten minutes was reached.</source>
        <translation>Bahnaufzeichnung gestoppt: Die Höchstdauer von zehn Minuten wurde erreicht.</translation>
    </message>
    <message>
        <source>Path recording stopped because the robot stopped sending data or was restarted.</source>
        <translation>Bahnaufzeichnung gestoppt: Der Roboter sendet keine Daten mehr oder wurde neu gestartet.</translation>
    </message>
</context>
<context>
    <name>tiller::PathRecorder</name>
    <message>
        <source>%1 has no column “%2”. The columns “timestamp” and “actual_q_0” to “actual_q_5” are required.</source>
        <translation>%1 hat keine Spalte „%2“. Die Spalten timestamp und actual_q_0 bis actual_q_5 sind erforderlich.</translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation>Ohne Daten vom Roboter kann keine Bahn aufgezeichnet werden. Warten Sie auf Daten, oder verbinden Sie einen Roboter.</translation>
    </message>
    <message>
        <source>Import refused because another path is being recorded or processed. Stop the recording, or wait, and try again.</source>
        <translation>Import abgelehnt, weil gerade eine andere Bahn aufgezeichnet oder verarbeitet wird. Beenden Sie die Aufzeichnung, oder warten Sie, und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>The path could not be imported.</source>
        <translation>Die Bahn konnte nicht importiert werden.</translation>
    </message>
    <message>
        <source>path %1</source>
        <translation>Bahn %1</translation>
    </message>
    <message>
        <source>The arm did not move. No path was stored.</source>
        <translation>Der Arm hat sich nicht bewegt: Es wurde keine Bahn gespeichert.</translation>
    </message>
    <message>
        <source>Record “%1”</source>
        <translation>„%1“ aufzeichnen</translation>
    </message>
    <message>
        <source>“%1”: %2 s, %3 waypoints. Maximum deviation from the recording: %4 and %5.</source>
        <translation>„%1“: %2 s, %3 Wegpunkte. Größte Abweichung von der Aufzeichnung: %4 und %5.</translation>
    </message>
    <message numerus="yes">
        <source>%n packets were lost.</source>
        <translation>
            <numerusform>%n Paket ging verloren.</numerusform>
            <numerusform>%n Pakete gingen verloren.</numerusform>
        </translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation>Wählen Sie mindestens zwei Wegpunkte der Bahn.</translation>
    </message>
    <message>
        <source>“%1” is out of reach. Touch up or delete the waypoint.</source>
        <translation>„%1“ ist außer Reichweite. Teachen Sie ihn nach oder entfernen Sie ihn.</translation>
    </message>
</context>
<context>
    <name>tiller::PatternDialog</name>
    <message>
        <source>pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Pattern from three corners</source>
        <translation>Muster aus drei Ecken</translation>
    </message>
    <message>
        <source>Pattern “%1”</source>
        <translation>Muster „%1“</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>First cell</source>
        <translation>Erster Platz</translation>
    </message>
    <message>
        <source>End of the first row</source>
        <translation>Ende der ersten Reihe</translation>
    </message>
    <message>
        <source>Start of the last row</source>
        <translation>Anfang der letzten Reihe</translation>
    </message>
    <message>
        <source>Select a waypoint</source>
        <translation>einen Wegpunkt wählen</translation>
    </message>
    <message>
        <source>As taught</source>
        <translation>wie geteacht</translation>
    </message>
    <message>
        <source>Cells per row</source>
        <translation>Plätze je Reihe</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Layer height</source>
        <translation>Lagenhöhe</translation>
    </message>
    <message>
        <source>Distance from one layer to the next, measured opposite to the tool direction.</source>
        <translation>Abstand zwischen den Lagen, entgegen der Werkzeugrichtung.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Row by row</source>
        <translation>Reihe für Reihe</translation>
    </message>
    <message>
        <source>Zigzag</source>
        <translation>Mäander</translation>
    </message>
    <message>
        <source>Create pattern</source>
        <translation>Muster erstellen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Enter a name for the pattern.</source>
        <translation>Geben Sie einen Namen für das Muster ein.</translation>
    </message>
    <message>
        <source>Teach the corners first, then select a waypoint for each corner.</source>
        <translation>Teachen Sie zuerst die Ecken des Musters und wählen Sie dann für jede Ecke einen Wegpunkt.</translation>
    </message>
    <message>
        <source>The layer height must not be 0. Enter a layer height.</source>
        <translation>Die Lagenhöhe darf nicht 0 sein. Geben Sie eine Lagenhöhe ein.</translation>
    </message>
    <message>
        <source>The pattern has %1 cells; the maximum is %2. Enter fewer cells per row, rows or layers.</source>
        <translation>Das Muster hat %1 Plätze; das Maximum ist %2. Geben Sie weniger Plätze pro Reihe, Reihen oder Lagen ein.</translation>
    </message>
    <message>
        <source>All cells are excluded. Click a cell to include it.</source>
        <translation>Alle Plätze sind ausgeschlossen. Klicken Sie auf einen Platz, um ihn einzuschließen.</translation>
    </message>
    <message>
        <source>The three corners are on a straight line. Select a different waypoint for one of them.</source>
        <translation>Die drei Ecken liegen auf einer Geraden. Wählen Sie für eine davon einen anderen Wegpunkt.</translation>
    </message>
    <message>
        <source>Two corners are at the same position. Select a different waypoint for one of them.</source>
        <translation>Zwei Ecken haben dieselbe Position. Wählen Sie für eine davon einen anderen Wegpunkt.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n Wegpunkt</numerusform>
            <numerusform>%n Wegpunkte</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, all within reach.</source>
        <translation>%1, alle in Reichweite.</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n out of reach and marked.</source>
        <translation>
            <numerusform>%1, davon %n außer Reichweite und markiert.</numerusform>
            <numerusform>%1, davon %n außer Reichweite und markiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>A pattern with this name already exists. Choose a different name.</source>
        <translation>Ein Muster mit diesem Namen ist bereits vorhanden. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The layer height is not a number or is out of range. Enter a different layer height.</source>
        <translation>Die Lagenhöhe ist keine Zahl oder außerhalb des Bereichs. Geben Sie eine andere Lagenhöhe ein.</translation>
    </message>
</context>
<context>
    <name>tiller::PatternGrid</name>
    <message>
        <source>Pattern cells</source>
        <translation>Plätze des Musters</translation>
    </message>
    <message>
        <source>Click a cell to exclude or include it. The first cell is at the lower left.</source>
        <translation>Klicken Sie auf einen Platz, um ihn aus- oder einzuschließen. Der erste Platz ist unten links.</translation>
    </message>
    <message>
        <source>Row %1, column %2</source>
        <translation>Reihe %1, Spalte %2</translation>
    </message>
</context>
<context>
    <name>tiller::PayloadEstimator</name>
    <message>
        <source>Next pose (hold)</source>
        <translation>Nächste Pose (halten)</translation>
    </message>
    <message>
        <source>Keep payload</source>
        <translation>Nutzlast behalten</translation>
    </message>
    <message>
        <source>Measure payload</source>
        <translation>Nutzlast messen</translation>
    </message>
    <message>
        <source>Measure the payload in several poses</source>
        <translation>Nutzlast in mehreren Posen messen</translation>
    </message>
    <message>
        <source>Next pose, hold</source>
        <translation>Nächste Pose, halten</translation>
    </message>
    <message>
        <source>Rotates the wrist to the next pose while the button is held, no faster than the jog speed. Make sure that the tool has space to rotate.</source>
        <translation>Dreht das Handgelenk zur nächsten Pose, solange die Taste gehalten wird, höchstens mit der Verfahrgeschwindigkeit. Achten Sie darauf, dass das Werkzeug genug Platz zum Drehen hat.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel payload measurement</source>
        <translation>Nutzlastmessung abbrechen</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller hat nicht die Steuerung. Übernehmen Sie zuerst die Steuerung.</translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and record the pose again.</source>
        <translation>Der Arm hat sich bewegt. Warten Sie auf Stillstand, halten Sie das Werkzeug frei von Kontakt und nehmen Sie die Pose erneut.</translation>
    </message>
    <message>
        <source>The robot is not sending force data. Enter the mass and the centre of gravity instead.</source>
        <translation>Der Roboter sendet keine Kraftdaten. Geben Sie stattdessen Masse und Schwerpunkt ein.</translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation>Nutzlast wird gemessen… Halten Sie das Werkzeug frei von Kontakt.</translation>
    </message>
    <message>
        <source>%1 kg, centre of gravity at %2 from the flange. The poses agree within %3 and %4.</source>
        <translation>%1 kg, Schwerpunkt %2 vom Flansch entfernt. Die Posen stimmen innerhalb von %3 und %4 überein.</translation>
    </message>
    <message>
        <source>%1 The accuracy is low: pose %2 deviates most. Remove this pose and record another pose.</source>
        <translation>%1 Die Genauigkeit ist gering: Pose %2 weicht am stärksten ab. Entfernen Sie sie und nehmen Sie eine andere Pose.</translation>
    </message>
    <message>
        <source>The load of %1 kg is too light to measure the centre of gravity. Enter the payload manually.</source>
        <translation>Die Last von %1 kg ist zu leicht, um den Schwerpunkt zu messen. Geben Sie die Nutzlast manuell ein.</translation>
    </message>
    <message>
        <source>Wait for standstill, keep the tool free of contact, and record the pose. Then rotate the wrist by jogging or with “Next pose (hold)”, and record three more poses.</source>
        <translation>Warten Sie auf Stillstand, halten Sie das Werkzeug frei von Kontakt und nehmen Sie die Pose. Drehen Sie dann das Handgelenk durch Verfahren oder mit „Nächste Pose“ und nehmen Sie drei weitere Posen.</translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation>Pose %1 nehmen</translation>
    </message>
    <message>
        <source>Remove least accurate pose</source>
        <translation>Ungenaueste Pose entfernen</translation>
    </message>
    <message>
        <source>Remove last pose</source>
        <translation>Letzte Pose entfernen</translation>
    </message>
    <message>
        <source>Pose %1  %2</source>
        <translation>Pose %1  %2</translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation>  ◀ am ungenauesten</translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool rotated in a different direction.</source>
        <translation>Die Werkzeugorientierungen sind zu ähnlich. Nehmen Sie eine weitere Pose mit anders gedrehtem Werkzeug.</translation>
    </message>
    <message numerus="yes">
        <source>Rotate the wrist in a different direction and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>Drehen Sie das Handgelenk in eine andere Richtung und nehmen Sie die Pose. Noch benötigte Posen: %n.</numerusform>
            <numerusform>Drehen Sie das Handgelenk in eine andere Richtung und nehmen Sie die Pose. Noch benötigte Posen: %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::PayloadPage</name>
    <message>
        <source>Mass kg</source>
        <translation>Masse kg</translation>
    </message>
    <message>
        <source>CX %1</source>
        <translation>CX %1</translation>
    </message>
    <message>
        <source>CY %1</source>
        <translation>CY %1</translation>
    </message>
    <message>
        <source>CZ %1</source>
        <translation>CZ %1</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>In Gebrauch</translation>
    </message>
    <message>
        <source>Enter a name for the payload.</source>
        <translation>Geben Sie einen Namen für die Nutzlast ein.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>„%1“ in „%2“ umbenennen</translation>
    </message>
    <message>
        <source>Nothing mounted</source>
        <translation>Nichts montiert</translation>
    </message>
    <message>
        <source>Robotiq 2F-85, empty</source>
        <translation>Robotiq 2F-85, leer</translation>
    </message>
    <message>
        <source>Robotiq 2F-140, empty</source>
        <translation>Robotiq 2F-140, leer</translation>
    </message>
    <message>
        <source>Payloads</source>
        <translation>Nutzlasten</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>CX</source>
        <translation>CX</translation>
    </message>
    <message>
        <source>CY</source>
        <translation>CY</translation>
    </message>
    <message>
        <source>CZ</source>
        <translation>CZ</translation>
    </message>
    <message>
        <source>Payload mass</source>
        <translation>Masse der Nutzlast</translation>
    </message>
    <message>
        <source>Centre of gravity X</source>
        <translation>Schwerpunkt X</translation>
    </message>
    <message>
        <source>Centre of gravity Y</source>
        <translation>Schwerpunkt Y</translation>
    </message>
    <message>
        <source>Centre of gravity Z</source>
        <translation>Schwerpunkt Z</translation>
    </message>
    <message>
        <source>Press Return to apply the value to the project. The robot&apos;s payload does not change.</source>
        <translation>Mit Enter in das Projekt übernehmen. Die Nutzlast des Roboters ändert sich nicht.</translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation>Am Roboter setzen</translation>
    </message>
    <message>
        <source>Use this payload and set it on the robot</source>
        <translation>Diese Nutzlast verwenden und am Roboter setzen</translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation>Messen…</translation>
    </message>
    <message>
        <source>Measure the payload with the arm</source>
        <translation>Nutzlast mit dem Arm messen</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Verify the payload</source>
        <translation>Nutzlast prüfen</translation>
    </message>
    <message>
        <source>Store the active payload of the robot</source>
        <translation>Aktive Nutzlast des Roboters speichern</translation>
    </message>
    <message>
        <source>Enter new payload</source>
        <translation>Neue Nutzlast eingeben</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>Nutzlast</translation>
    </message>
    <message>
        <source>Add preset: %1</source>
        <translation>Vorgabe hinzufügen: %1</translation>
    </message>
    <message>
        <source>Rename payload</source>
        <translation>Nutzlast umbenennen</translation>
    </message>
    <message>
        <source>Duplicate payload</source>
        <translation>Nutzlast duplizieren</translation>
    </message>
    <message>
        <source>Delete payload</source>
        <translation>Nutzlast löschen</translation>
    </message>
    <message>
        <source>Add the payload “%1”</source>
        <translation>Die Nutzlast „%1“ hinzufügen</translation>
    </message>
    <message>
        <source>Change the payload “%1”</source>
        <translation>Die Nutzlast „%1“ ändern</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>Kein Roboter ist verbunden. Verbinden Sie einen oder probieren Sie den Simulator.</translation>
    </message>
    <message>
        <source>Select the payload to set.</source>
        <translation>Wählen Sie die zu setzende Nutzlast.</translation>
    </message>
    <message>
        <source>Use the payload “%1”</source>
        <translation>Die Nutzlast „%1“ verwenden</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller hat nicht die Steuerung. Übernehmen Sie zuerst die Steuerung.</translation>
    </message>
    <message>
        <source>Delete the payload “%1”</source>
        <translation>Die Nutzlast „%1“ löschen</translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation>Nutzlast wird gemessen… Halten Sie das Werkzeug frei von Kontakt.</translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and press “Verify” again.</source>
        <translation>Der Arm hat sich bewegt. Warten Sie auf Stillstand, halten Sie das Werkzeug frei von Kontakt und prüfen Sie erneut.</translation>
    </message>
    <message>
        <source>The payload cannot be verified because the robot is not sending force data. Wait for data, or reconnect.</source>
        <translation>Die Nutzlast kann nicht geprüft werden, weil der Roboter keine Kraftdaten sendet. Warten Sie auf Daten oder verbinden Sie neu.</translation>
    </message>
    <message>
        <source>With a payload of %1 kg, the arm measures a force of %2 and a torque of %3.</source>
        <translation>Mit einer Nutzlast von %1 kg misst der Arm eine Kraft von %2 und ein Drehmoment von %3.</translation>
    </message>
    <message>
        <source>The payload is correct. %1</source>
        <translation>Die Nutzlast ist korrekt. %1</translation>
    </message>
    <message>
        <source>The payload is correct</source>
        <translation>Die Nutzlast ist korrekt</translation>
    </message>
    <message>
        <source>The load is about %1 kg heavier than the configured payload.</source>
        <translation>Die Last ist etwa %1 kg schwerer als die eingestellte Nutzlast.</translation>
    </message>
    <message>
        <source>The load is about %1 kg lighter than the configured payload.</source>
        <translation>Die Last ist etwa %1 kg leichter als die eingestellte Nutzlast.</translation>
    </message>
    <message>
        <source>The centre of gravity differs, or something is touching the tool.</source>
        <translation>Der Schwerpunkt weicht ab, oder etwas berührt das Werkzeug.</translation>
    </message>
    <message>
        <source>%1 %2 Measure the payload, or select a different payload. Zeroing the force sensor hides a wrong payload until the tool rotates.</source>
        <translation>%1 %2 Messen Sie die Nutzlast oder wählen Sie eine andere. Das Nullsetzen des Kraftsensors verdeckt eine falsche Nutzlast, bis sich das Werkzeug dreht.</translation>
    </message>
    <message>
        <source>The payload is wrong. %1 %2</source>
        <translation>Die Nutzlast ist falsch. %1 %2</translation>
    </message>
    <message>
        <source>The payload is wrong</source>
        <translation>Die Nutzlast ist falsch</translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation>%1, auf dem Roboter aktiv</translation>
    </message>
    <message>
        <source>%1; the robot uses %2 kg, centre of gravity %3</source>
        <translation>%1; der Roboter verwendet %2 kg, Schwerpunkt %3</translation>
    </message>
    <message>
        <source>The robot&apos;s payload differs from “%1”</source>
        <translation>Die Nutzlast des Roboters weicht von „%1“ ab</translation>
    </message>
    <message>
        <source>On the robot: %1 kg, centre of gravity %2. In the project: %3 kg, centre of gravity %4. Nothing was changed.</source>
        <translation>Am Roboter: %1 kg, Schwerpunkt %2. Im Projekt: %3 kg, Schwerpunkt %4. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>„%1“ am Roboter setzen</translation>
    </message>
    <message>
        <source>No payloads yet.
Press “Measure…” to measure the payload with the arm.</source>
        <translation>Noch keine Nutzlasten.
Drücken Sie „Messen…“, um die Nutzlast mit dem Arm zu messen.</translation>
    </message>
    <message>
        <source>A payload named “%1” already exists. Choose a different name.</source>
        <translation>Eine Nutzlast mit dem Namen „%1“ ist bereits vorhanden. Wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>tiller::PlotAnalysis</name>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>XY</source>
        <translation>XY</translation>
    </message>
    <message>
        <source>vs.</source>
        <translation>über</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>Spektrum und XY</translation>
    </message>
    <message>
        <source>Analysis type</source>
        <translation>Art der Auswertung</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>X-axis signal</source>
        <translation>Signal der X-Achse</translation>
    </message>
    <message>
        <source>Add a signal to the plots first.</source>
        <translation>Fügen Sie zuerst ein Signal in die Diagramme ein.</translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range.</source>
        <translation>Dieser Bereich enthält keine Werte. Wählen Sie einen anderen Bereich.</translation>
    </message>
    <message>
        <source>Samples are missing in this range. Place cursors A and B around a range without gaps.</source>
        <translation>In diesem Bereich fehlen Messwerte: Setzen Sie die Cursor A und B so, dass keine Lücke dazwischenliegt.</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>Frequenz [Hz]</translation>
    </message>
    <message>
        <source>Amplitude of %1</source>
        <translation>Amplitude von %1</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n Messwert</numerusform>
            <numerusform>%n Messwerte</numerusform>
        </translation>
    </message>
    <message>
        <source>This range is too long to combine signals from different recordings. Place cursors A and B around a shorter range.</source>
        <translation>Dieser Bereich ist zu lang, um Signale aus verschiedenen Aufzeichnungen zu kombinieren. Setzen Sie die Cursor A und B um einen kürzeren Bereich.</translation>
    </message>
    <message>
        <source>Reading the recording: %1</source>
        <translation>Aufzeichnung wird gelesen: %1</translation>
    </message>
    <message numerus="yes">
        <source>Hann window of %1 samples · resolution %2 Hz · mean of %n segment(s) · %3 to %4 s</source>
        <translation>
            <numerusform>Hann-Fenster mit %1 Messwerten · Auflösung %2 Hz · Mittel aus %n Abschnitt · %3 bis %4 s</numerusform>
            <numerusform>Hann-Fenster mit %1 Messwerten · Auflösung %2 Hz · Mittel aus %n Abschnitten · %3 bis %4 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) shown, 1 of every %1</source>
        <translation>
            <numerusform>%n Messwert angezeigt, 1 von je %1</numerusform>
            <numerusform>%n Messwerte angezeigt, 1 von je %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 to %3 s</source>
        <translation>%1 · %2 bis %3 s</translation>
    </message>
    <message>
        <source>This range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation>Dieser Bereich enthält Messwerte verschiedener Roboter. Setzen Sie die Cursor A und B um die Daten eines Roboters.</translation>
    </message>
</context>
<context>
    <name>tiller::PlotComparison</name>
    <message>
        <source>Arm and model diverge: %1</source>
        <translation>Arm und Modell weichen voneinander ab: %1</translation>
    </message>
    <message>
        <source>Comparing the arm with its model: %1</source>
        <translation>Der Arm wird mit seinem Modell verglichen: %1</translation>
    </message>
    <message>
        <source>Not compared with the arm model: the recording does not specify the robot model. Press “Compare…” and select the model.</source>
        <translation>Nicht mit dem Armmodell verglichen: Die Aufzeichnung nennt das Robotermodell nicht. Drücken Sie „Vergleichen…“ und wählen Sie das Modell.</translation>
    </message>
</context>
<context>
    <name>tiller::PlotDock</name>
    <message>
        <source>5 s</source>
        <translation>5 s</translation>
    </message>
    <message>
        <source>10 s</source>
        <translation>10 s</translation>
    </message>
    <message>
        <source>30 s</source>
        <translation>30 s</translation>
    </message>
    <message>
        <source>2 min</source>
        <translation>2 min</translation>
    </message>
    <message>
        <source>10 min</source>
        <translation>10 min</translation>
    </message>
    <message>
        <source>30 min</source>
        <translation>30 min</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Time range of the plots. The mouse wheel zooms the time axis; over the value axis, or with Ctrl, it zooms the values. Double-click the value axis to scale automatically.</source>
        <translation>Zeitbereich der Diagramme. Das Mausrad zoomt die Zeitachse; über der Werteachse oder mit Strg zoomt es die Werte. Doppelklick auf die Werteachse skaliert automatisch.</translation>
    </message>
    <message>
        <source>Pause the plots</source>
        <translation>Diagramme anhalten</translation>
    </message>
    <message>
        <source>Zero the displayed force</source>
        <translation>Angezeigte Kraft auf null setzen</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Null</translation>
    </message>
    <message>
        <source>Export the visible range</source>
        <translation>Sichtbaren Bereich exportieren</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Save the visible range as an image (e.g. PNG) or as values (e.g. CSV)</source>
        <translation>Sichtbaren Bereich als Bild (z. B. PNG) oder als Werte (z. B. CSV) speichern</translation>
    </message>
    <message>
        <source>Cannot zero the force: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation>Die Kraft kann nicht auf null gesetzt werden: Die Diagramme zeigen keine Messwerte. Verbinden Sie sich mit einem Roboter oder blättern Sie zu einer Zeit mit Messwerten.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Freeze the plots. Reception and recording of data continue.</source>
        <translation>Diagramme anhalten; Daten und Aufzeichnung laufen weiter</translation>
    </message>
    <message>
        <source>Show the force as measured by the robot. %1</source>
        <translation>Die vom Roboter gemessene Kraft anzeigen. %1</translation>
    </message>
    <message>
        <source>Subtract the current force in the plots. The robot, recordings and exported values are not changed.</source>
        <translation>Die aktuelle Kraft in den Diagrammen abziehen. Roboter, Aufzeichnungen und exportierte Werte werden nicht geändert.</translation>
    </message>
    <message>
        <source>● REC %1</source>
        <translation>● REC %1</translation>
    </message>
    <message>
        <source>● Record</source>
        <translation>● Aufzeichnen</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simuliert</translation>
    </message>
    <message>
        <source>Cannot export: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation>Export nicht möglich: Die Diagramme zeigen keine Messwerte. Verbinden Sie sich mit einem Roboter oder blättern Sie zu einer Zeit mit Messwerten.</translation>
    </message>
    <message>
        <source>Exported the visible range to %1</source>
        <translation>Sichtbarer Bereich exportiert nach %1</translation>
    </message>
    <message>
        <source>PNG image (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>SVG image (*.svg)</source>
        <translation>SVG-Bild (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF-Dokument (*.pdf)</translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation>CSV-Datei (*.csv)</translation>
    </message>
    <message>
        <source>Recording options</source>
        <translation>Aufzeichnungsoptionen</translation>
    </message>
    <message>
        <source>Rows, signals, folder and file name of the next recording</source>
        <translation>Zeilen, Signale, Ordner und Dateiname der nächsten Aufzeichnung</translation>
    </message>
    <message>
        <source>One row per packet</source>
        <translation>Eine Zeile je Paket</translation>
    </message>
    <message numerus="yes">
        <source>One row every %n packet(s)</source>
        <translation>
            <numerusform>Eine Zeile alle %n Pakete</numerusform>
            <numerusform>Eine Zeile alle %n Pakete</numerusform>
        </translation>
    </message>
    <message>
        <source>All signals…</source>
        <translation>Alle Signale…</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s)…</source>
        <translation>
            <numerusform>%n Signal…</numerusform>
            <numerusform>%n Signale…</numerusform>
        </translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>Ordner für Aufzeichnungen</translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range, then export again.</source>
        <translation>In diesem Bereich gibt es keine Messwerte. Wählen Sie einen anderen Bereich und exportieren Sie dann erneut.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>What happened at this time?</source>
        <translation>Was ist zu diesem Zeitpunkt passiert?</translation>
    </message>
    <message>
        <source>The plots were copied to the clipboard as an image.</source>
        <translation>Die Diagramme wurden als Bild in die Zwischenablage kopiert.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>History %1 · %2</source>
        <translation>Verlauf %1 · %2</translation>
    </message>
    <message>
        <source>New page</source>
        <translation>Neue Seite</translation>
    </message>
    <message>
        <source>Remove this page</source>
        <translation>Diese Seite entfernen</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Aufzeichnung öffnen…</translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation>Aufzeichnungen schließen</translation>
    </message>
    <message>
        <source>Copy plots as image</source>
        <translation>Diagramme als Bild kopieren</translation>
    </message>
    <message>
        <source>Save layout…</source>
        <translation>Layout speichern…</translation>
    </message>
    <message>
        <source>Open layout…</source>
        <translation>Layout öffnen…</translation>
    </message>
    <message>
        <source>History memory</source>
        <translation>Speicher für den Verlauf</translation>
    </message>
    <message>
        <source>Opened the recording %1</source>
        <translation>Aufzeichnung %1 geöffnet</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Save plot layout</source>
        <translation>Diagrammlayout speichern</translation>
    </message>
    <message>
        <source>Plot layouts (*.json)</source>
        <translation>Diagrammlayouts (*.json)</translation>
    </message>
    <message>
        <source>Open plot layout</source>
        <translation>Diagrammlayout öffnen</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 und weitere</translation>
    </message>
    <message>
        <source>Signal list</source>
        <translation>Liste der Signale</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Robot signals. Drag a signal to a plot, or to the edge of a plot to create a new plot. Double-click a signal to add it to a plot.</source>
        <translation>Signale des Roboters. Ziehen Sie ein Signal in ein Diagramm oder an den Rand eines Diagramms, um ein neues Diagramm zu erstellen. Ein Doppelklick fügt das Signal zu einem Diagramm hinzu.</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>Werte an den Cursorn</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Values at cursors A and B, and statistics of the range between the cursors: minimum, maximum, mean, RMS, standard deviation, slope</source>
        <translation>Werte an den Cursorn A und B und Statistik dazwischen: Minimum, Maximum, Mittelwert, RMS, Standardabweichung, Steigung</translation>
    </message>
    <message>
        <source>Plot pages and layout</source>
        <translation>Seiten und Layout der Diagramme</translation>
    </message>
    <message>
        <source>Layout ▾</source>
        <translation>Layout ▾</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>Spektrum und XY</translation>
    </message>
    <message>
        <source>Export the visible range…</source>
        <translation>Sichtbaren Bereich exportieren…</translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation>Zeitachse</translation>
    </message>
    <message>
        <source>Relative to the newest sample</source>
        <translation>Relativ zum neuesten Messwert</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>Zeit der Steuerung</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Uhrzeit</translation>
    </message>
    <message>
        <source>The maximum number of plot pages has been reached. Remove a page first.</source>
        <translation>Die maximale Zahl an Diagrammseiten ist erreicht: Entfernen Sie zuerst eine Seite.</translation>
    </message>
    <message>
        <source>CSV: text, for pandas and spreadsheets</source>
        <translation>CSV: Text, für pandas und Tabellenprogramme</translation>
    </message>
    <message>
        <source>MCAP: every field, the log and the project, for ROS tools</source>
        <translation>MCAP: jedes Feld, Log und Projekt, für ROS-Werkzeuge</translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation>Mit dem Modell des Arms vergleichen…</translation>
    </message>
    <message>
        <source>Exported the range between cursors A and B to %1</source>
        <translation>Bereich zwischen den Cursorn A und B nach %1 exportiert</translation>
    </message>
    <message>
        <source>Cursor A to cursor B (*%1)</source>
        <translation>Cursor A bis Cursor B (*%1)</translation>
    </message>
    <message>
        <source>The page shows several recordings, or a recording and live signals. Show only one of them on the page, then export again.</source>
        <translation>Die Seite zeigt mehrere Aufzeichnungen oder eine Aufzeichnung und Live-Signale. Zeigen Sie nur eine davon auf der Seite und exportieren Sie dann erneut.</translation>
    </message>
    <message>
        <source>Live signals can be exported only as .csv. For other formats, record the signals first.</source>
        <translation>Live-Signale können nur als .csv exportiert werden. Zeichnen Sie sie für andere Formate zuerst auf.</translation>
    </message>
    <message>
        <source>The range contains too many values to export from this window. Export a shorter range, or run “tiller-cli export”.</source>
        <translation>Der Bereich enthält zu viele Werte, um ihn aus diesem Fenster zu exportieren. Exportieren Sie einen kürzeren Bereich, oder führen Sie „tiller-cli export“ aus.</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>Roboter: %1</translation>
    </message>
    <message>
        <source>Recordings (%1);;All files (*)</source>
        <translation>Aufzeichnungen (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Record to a file (%1)</source>
        <translation>In eine Datei aufzeichnen (%1)</translation>
    </message>
    <message>
        <source>Record robot data to a file (%1). Use the arrow button to select the signals and the folder.</source>
        <translation>Roboterdaten in eine Datei aufzeichnen (%1). Mit der Pfeiltaste wählen Sie Signale und Ordner.</translation>
    </message>
    <message>
        <source>All %1 pages show recordings. Remove a page or close the recordings first.</source>
        <translation>Alle %1 Seiten zeigen Aufzeichnungen. Entfernen Sie zuerst eine Seite oder schließen Sie die Aufzeichnungen.</translation>
    </message>
    <message>
        <source>Cursor readout</source>
        <translation>Ablesung am Cursor</translation>
    </message>
    <message>
        <source>Click in the plots to place cursors A and B; drag them, or use the A, B and arrow keys. Click a legend entry to hide its curve; Ctrl+click the entry to show its values at the cursors.</source>
        <translation>Klicken Sie in die Diagramme, um die Cursor A und B zu setzen; ziehen Sie sie oder verwenden Sie A, B und die Pfeiltasten. Klicken Sie auf einen Legendeneintrag, um seine Kurve auszublenden; Strg+Klick liest dieses Signal an den Cursorn ab.</translation>
    </message>
    <message>
        <source>Time range</source>
        <translation>Zeitbereich</translation>
    </message>
    <message>
        <source>Paused · %1 s behind</source>
        <translation>Angehalten · %1 s zurück</translation>
    </message>
    <message>
        <source>Return to the newest samples</source>
        <translation>Zurück zu den neuesten Werten</translation>
    </message>
    <message>
        <source>controller time %1 to %2 s</source>
        <translation>Zeit der Steuerung %1 bis %2 s</translation>
    </message>
    <message>
        <source>%1 to %2 s</source>
        <translation>%1 bis %2 s</translation>
    </message>
    <message>
        <source>Folder: %1…</source>
        <translation>Ordner: %1…</translation>
    </message>
    <message>
        <source>The file type is not supported. Use the suffix .png, .svg or .pdf for an image, or .csv for values.</source>
        <translation>Der Dateityp wird nicht unterstützt. Verwenden Sie die Endung .png, .svg oder .pdf für ein Bild oder .csv für Werte.</translation>
    </message>
    <message>
        <source>%1 at controller time %2 s.</source>
        <translation>%1 (Zeit der Steuerung: %2 s).</translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation>Standard-Diagramme zeigen</translation>
    </message>
    <message>
        <source>the file does not contain a plot layout</source>
        <translation>die Datei enthält kein Diagrammlayout</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %2/s · %3 free · %n packet(s) lost</source>
        <translation>
            <numerusform>%1 · %2/s · %3 frei · %n Paket verloren</numerusform>
            <numerusform>%1 · %2/s · %3 frei · %n Pakete verloren</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened the recording %1, but part of it could not be read. %2</source>
        <translation>Aufzeichnung %1 geöffnet, aber ein Teil konnte nicht gelesen werden. %2</translation>
    </message>
    <message>
        <source>Part of the recording %1 could not be read. %2</source>
        <translation>Ein Teil der Aufzeichnung %1 konnte nicht gelesen werden. %2</translation>
    </message>
    <message>
        <source>The range contains samples from different robots. Use cursors A and B to select a range with data from one robot, then export again.</source>
        <translation>Der Bereich enthält Werte verschiedener Roboter. Wählen Sie mit den Cursorn A und B einen Bereich eines Roboters und exportieren Sie erneut.</translation>
    </message>
    <message>
        <source>The image %1 could not be created. Choose a different image format.</source>
        <translation>Das Bild %1 konnte nicht erstellt werden. Wählen Sie ein anderes Bildformat.</translation>
    </message>
    <message>
        <source>Recordings…</source>
        <translation>Aufzeichnungen…</translation>
    </message>
    <message>
        <source>The plots do not contain data from %1.</source>
        <translation>Die Diagramme enthalten keine Daten von %1.</translation>
    </message>
    <message>
        <source>● Waiting</source>
        <translation>● Wartet</translation>
    </message>
    <message>
        <source>Waiting for the trigger. Files so far: %1</source>
        <translation>Warten auf den Trigger. Bisherige Dateien: %1</translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation>Metadaten…</translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>Metadaten (%n Feld)…</numerusform>
            <numerusform>Metadaten (%n Felder)…</numerusform>
        </translation>
    </message>
    <message>
        <source>Trigger…</source>
        <translation>Trigger…</translation>
    </message>
    <message>
        <source>Trigger %1…</source>
        <translation>Trigger %1…</translation>
    </message>
    <message>
        <source>File name: %1…</source>
        <translation>Dateiname: %1…</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation>%1 × Echtzeit</translation>
    </message>
    <message>
        <source>Stop playback</source>
        <translation>Wiedergabe beenden</translation>
    </message>
    <message>
        <source>Cannot play: the page has no samples. Connect to a robot or open a recording first.</source>
        <translation>Wiedergabe nicht möglich: Die Seite enthält keine Messwerte. Verbinden Sie zuerst einen Roboter oder öffnen Sie eine Aufzeichnung.</translation>
    </message>
</context>
<context>
    <name>tiller::PlotMarks</name>
    <message>
        <source>%1 is above %2</source>
        <translation>%1 über %2</translation>
    </message>
    <message>
        <source>%1 is below %2</source>
        <translation>%1 unter %2</translation>
    </message>
</context>
<context>
    <name>tiller::PlotPages</name>
    <message>
        <source>Plot pages</source>
        <translation>Diagrammseiten</translation>
    </message>
    <message>
        <source>Page name</source>
        <translation>Name der Seite</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>Double-click to rename</source>
        <translation>Zum Umbenennen doppelklicken</translation>
    </message>
</context>
<context>
    <name>tiller::PlotValues</name>
    <message>
        <source>Values at the cursors</source>
        <translation>Werte an den Cursorn</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Std</source>
        <translation>Std</translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation>Spitze-Spitze</translation>
    </message>
    <message>
        <source>Δt 0 s</source>
        <translation>Δt 0 s</translation>
    </message>
    <message>
        <source>Δt %1 s · 1/Δt %2 Hz</source>
        <translation>Δt %1 s · 1/Δt %2 Hz</translation>
    </message>
    <message>
        <source>Click in the plots to place cursor A, then cursor B. The table then shows statistics of the range between the cursors.</source>
        <translation>Klicken Sie in die Diagramme, um zuerst Cursor A und dann Cursor B zu setzen. Die Tabelle zeigt dann Statistiken des Bereichs zwischen den Cursorn.</translation>
    </message>
    <message>
        <source>%1 · calculating: %2</source>
        <translation>%1 · wird berechnet: %2</translation>
    </message>
    <message>
        <source>Statistics are incomplete: %1</source>
        <translation>Die Statistik ist unvollständig: %1</translation>
    </message>
    <message>
        <source>Slope per second</source>
        <translation>Steigung je s</translation>
    </message>
</context>
<context>
    <name>tiller::PlotView</name>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>A–B Δt %1 s · Δ%2 %3</source>
        <translation>A–B Δt %1 s · Δ%2 %3</translation>
    </message>
    <message>
        <source>%1 (zeroed)</source>
        <translation>%1 (auf null)</translation>
    </message>
    <message>
        <source>%1 %2 s · %3 %4</source>
        <translation>%1 %2 s · %3 %4</translation>
    </message>
    <message>
        <source>Fixed scale · double-click the axis to scale automatically</source>
        <translation>Feste Skala · Doppelklick auf die Achse skaliert automatisch</translation>
    </message>
    <message>
        <source>Zeroed (offset %1 %2)</source>
        <translation>Auf null gesetzt (Versatz %1 %2)</translation>
    </message>
    <message>
        <source>Plots over time</source>
        <translation>Diagramme über der Zeit</translation>
    </message>
    <message>
        <source>A and B place the cursors. Left and Right move the active cursor. Up and Down select the signal at the cursors. H hides the curve of this signal; Ctrl+Delete removes it. Plus and Minus change the time range, or the value scale with Ctrl; Ctrl+0 scales automatically. N adds a note, F shows all data, and End returns to the newest samples.</source>
        <translation>A und B setzen die Cursor. Links und Rechts bewegen den aktiven Cursor. Auf und Ab wählen das abgelesene Signal. H blendet dessen Kurve aus; Strg+Entf entfernt sie. Plus und Minus ändern den Zeitbereich, mit Strg die Werteskala; Strg+0 skaliert automatisch. N fügt eine Notiz hinzu, F zeigt alle Daten, und Ende kehrt zu den neuesten Messwerten zurück.</translation>
    </message>
    <message>
        <source>A–B Δt %1 s</source>
        <translation>A–B Δt %1 s</translation>
    </message>
    <message>
        <source>Drop signals here</source>
        <translation>Signale hier ablegen</translation>
    </message>
    <message>
        <source>No samples yet. Connect to a robot.</source>
        <translation>Noch keine Werte. Verbinden Sie sich mit einem Roboter.</translation>
    </message>
</context>
<context>
    <name>tiller::PoseEditor</name>
    <message>
        <source>%1 X</source>
        <translation>%1 X</translation>
    </message>
    <message>
        <source>%1 Y</source>
        <translation>%1 Y</translation>
    </message>
    <message>
        <source>%1 Z</source>
        <translation>%1 Z</translation>
    </message>
    <message>
        <source>Rotation about X (RX)</source>
        <translation>Drehung um X (RX)</translation>
    </message>
    <message>
        <source>Rotation about Y (RY)</source>
        <translation>Drehung um Y (RY)</translation>
    </message>
    <message>
        <source>Rotation about Z (RZ)</source>
        <translation>Drehung um Z (RZ)</translation>
    </message>
</context>
<context>
    <name>tiller::PoseView</name>
    <message>
        <source>TCP at the flange</source>
        <translation>TCP am Flansch</translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation>TCP %1 vom Flansch</translation>
    </message>
    <message>
        <source>in %1 · %2</source>
        <translation>in %1 · %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>TCP pose in %1</source>
        <translation>TCP-Pose in %1</translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ₀: displacement from the zero position. Click to show the displacement since the start of the last motion.</source>
        <translation>Orientierung wie in den Einstellungen. Δ₀: Verschiebung seit null. Klick zeigt die Verschiebung seit Beginn der letzten Bewegung.</translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ: displacement since the start of the last motion. Click to set the displacement to zero.</source>
        <translation>Orientierung wie in den Einstellungen. Δ: Verschiebung seit Beginn der letzten Bewegung. Klick setzt hier null.</translation>
    </message>
    <message>
        <source>TCP in the flange frame: %1</source>
        <translation>TCP im System des Flansches: %1</translation>
    </message>
</context>
<context>
    <name>tiller::PositionsPage</name>
    <message>
        <source>Joints °</source>
        <translation>Gelenke °</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>Enter a name for the position.</source>
        <translation>Geben Sie einen Namen für die Position ein.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>„%1“ in „%2“ umbenennen</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positionen</translation>
    </message>
    <message>
        <source>No positions yet.
Jog the arm to a position and press “Set home here” or “Add position”.</source>
        <translation>Noch keine Positionen.
Fahren Sie den Arm an eine Position und drücken Sie „Home hier“ oder „Position hinzufügen“.</translation>
    </message>
    <message>
        <source>Safe height</source>
        <translation>Sichere Höhe</translation>
    </message>
    <message>
        <source>%1. Press Return to apply the values. Only the stored position changes; the robot does not move.</source>
        <translation>%1. Mit Enter übernehmen. Nur die gespeicherte Position ändert sich; der Roboter bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Height in the base frame. Above this height, the cell is free of obstacles, and the TCP may move sideways.</source>
        <translation>Höhe im Basis-Koordinatensystem, über der es keine Hindernisse gibt: Darüber darf sich der TCP seitwärts bewegen.</translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation>Am TCP</translation>
    </message>
    <message>
        <source>Set the safe height to the current TCP height</source>
        <translation>Sichere Höhe auf die aktuelle Höhe des TCP setzen</translation>
    </message>
    <message>
        <source>Set home here</source>
        <translation>Home hier</translation>
    </message>
    <message>
        <source>Add position</source>
        <translation>Position hinzufügen</translation>
    </message>
    <message>
        <source>Store the current position of the arm</source>
        <translation>Aktuelle Position des Arms speichern</translation>
    </message>
    <message>
        <source>Use as home</source>
        <translation>Als Home verwenden</translation>
    </message>
    <message>
        <source>Use the selected position as home</source>
        <translation>Die gewählte Position als Home verwenden</translation>
    </message>
    <message>
        <source>Touch up position</source>
        <translation>Die Position nachteachen</translation>
    </message>
    <message>
        <source>Reset to default home</source>
        <translation>Auf Standard-Home zurücksetzen</translation>
    </message>
    <message>
        <source>Rename position</source>
        <translation>Position umbenennen</translation>
    </message>
    <message>
        <source>Delete position</source>
        <translation>Position löschen</translation>
    </message>
    <message>
        <source>Set “%1” to the current position of the arm?</source>
        <translation>„%1“ auf die aktuelle Position des Arms setzen?</translation>
    </message>
    <message>
        <source>The Home button will then move the arm to this position.</source>
        <translation>Die Taste Home fährt den Arm dann dorthin.</translation>
    </message>
    <message>
        <source>Set home</source>
        <translation>Home setzen</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Add the position “%1”</source>
        <translation>Die Position „%1“ hinzufügen</translation>
    </message>
    <message>
        <source>Select a position to touch up.</source>
        <translation>Wählen Sie eine Position zum Nachteachen.</translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>„%1“ nachteachen?</translation>
    </message>
    <message>
        <source>Largest joint change: %1 %2.</source>
        <translation>Größte Gelenkänderung: %1 %2.</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Nachteachen</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>„%1“ nachteachen</translation>
    </message>
    <message>
        <source>Use “%1” as home</source>
        <translation>„%1“ als Home verwenden</translation>
    </message>
    <message>
        <source>Select a position to use as home.</source>
        <translation>Wählen Sie eine Position als Home.</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>„%1“ löschen</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>„%1“ ändern</translation>
    </message>
    <message>
        <source>Set the safe height</source>
        <translation>Die sichere Höhe setzen</translation>
    </message>
    <message>
        <source>Remove the safe height</source>
        <translation>Sichere Höhe entfernen</translation>
    </message>
    <message>
        <source>The Home button moves the arm to the default home position: upright, without self-collision.</source>
        <translation>Die Taste Home fährt den Arm zur Standard-Home-Position: aufrecht, ohne Selbstkollision.</translation>
    </message>
    <message>
        <source>%1: target of the Home button</source>
        <translation>%1: Ziel der Taste Home</translation>
    </message>
    <message>
        <source>%1 · %2 %3 from the current position</source>
        <translation>%1 · %2 %3 von hier</translation>
    </message>
    <message>
        <source>A position named “%1” already exists. Choose a different name.</source>
        <translation>Eine Position mit dem Namen „%1“ ist bereits vorhanden. Wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>tiller::Practice</name>
    <message>
        <source>Start the simulated robot in the Robot menu first.</source>
        <translation>Starten Sie zuerst den simulierten Roboter (Menü Roboter).</translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes first.</source>
        <translation>Schalten Sie zuerst den Arm ein und lösen Sie die Bremsen.</translation>
    </message>
    <message>
        <source>The safety system has stopped the arm. Use “Recover…” first.</source>
        <translation>Das Sicherheitssystem hat den Arm gestoppt. Verwenden Sie zuerst „Wiederherstellen…“.</translation>
    </message>
    <message>
        <source>Done. Press “Start” to repeat the task.</source>
        <translation>Erledigt. Drücken Sie „Start“, um die Aufgabe zu wiederholen.</translation>
    </message>
    <message>
        <source>Press “Start”.</source>
        <translation>Drücken Sie Start.</translation>
    </message>
</context>
<context>
    <name>tiller::PracticeCard</name>
    <message>
        <source>Practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Force Fz in newtons</source>
        <translation>Kraft Fz in Newton</translation>
    </message>
    <message>
        <source>Enter a value and press Return</source>
        <translation>Wert eingeben, Enter drücken</translation>
    </message>
    <message>
        <source>Fz [N]</source>
        <translation>Fz [N]</translation>
    </message>
    <message>
        <source>Previous task</source>
        <translation>Vorige Aufgabe</translation>
    </message>
    <message>
        <source>Next task</source>
        <translation>Nächste Aufgabe</translation>
    </message>
    <message>
        <source>Practice · %1 of %2</source>
        <translation>Übung · %1 von %2</translation>
    </message>
    <message>
        <source>Starts or restarts the task</source>
        <translation>Startet die Aufgabe oder startet sie neu</translation>
    </message>
    <message>
        <source>Continues with the next task</source>
        <translation>Fährt mit der nächsten Aufgabe fort</translation>
    </message>
    <message>
        <source>Available after the check above has passed</source>
        <translation>Verfügbar, sobald die Prüfung oben bestanden ist</translation>
    </message>
</context>
<context>
    <name>tiller::PreflightPage</name>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fehlgeschlagen</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>Before you connect to %1</source>
        <translation>Bevor Sie sich mit %1 verbinden</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Erneut prüfen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Keep everyone out of reach of the arm.
Keep the emergency stop within reach: STOP in this window is a software stop.
Start slowly: the initial speed is %1.
Watch the arm, not the screen, while you hold a button.
Release the button to stop the arm.</source>
        <translation>Halten Sie alle Personen aus dem Arbeitsbereich des Arms fern.
Halten Sie den Not-Halt griffbereit: STOP in diesem Fenster ist ein Software-Stopp.
Beginnen Sie langsam: Die Anfangsgeschwindigkeit ist %1.
Beobachten Sie den Arm, nicht den Bildschirm, während Sie eine Taste halten.
Lassen Sie die Taste los, um den Arm zu stoppen.</translation>
    </message>
    <message>
        <source>Checking %1…</source>
        <translation>%1 wird geprüft…</translation>
    </message>
    <message>
        <source>Problems found</source>
        <translation>Probleme gefunden</translation>
    </message>
    <message>
        <source>Ready, with warnings</source>
        <translation>Bereit, mit Warnungen</translation>
    </message>
    <message>
        <source>Everything is ready</source>
        <translation>Alles ist bereit</translation>
    </message>
    <message>
        <source>Connect anyway</source>
        <translation>Trotzdem verbinden</translation>
    </message>
    <message>
        <source>If you connect anyway, the window shows the available data. The red items above may prevent Tiller from taking control or may stop a running motion.</source>
        <translation>Wenn Sie trotzdem verbinden, zeigt das Fenster die verfügbaren Daten. Die roten Punkte oben können das Übernehmen der Steuerung verhindern oder eine laufende Bewegung stoppen.</translation>
    </message>
</context>
<context>
    <name>tiller::ProgramModel</name>
    <message>
        <source>%1 × %2 s</source>
        <translation>%1 × %2 s</translation>
    </message>
    <message>
        <source>%1, disabled</source>
        <translation>%1, deaktiviert</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>%1, running</source>
        <translation>%1, läuft</translation>
    </message>
    <message>
        <source>%1, breakpoint</source>
        <translation>%1, Haltepunkt</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, geändert</translation>
    </message>
</context>
<context>
    <name>tiller::ProgramTab</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Show step</source>
        <translation>Schritt zeigen</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Move steps</source>
        <translation>Schritte verschieben</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>„%1“ ändern</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Add steps, or edit the selected step</source>
        <translation>Schritte hinzufügen oder den gewählten Schritt bearbeiten</translation>
    </message>
    <message>
        <source>Step fields</source>
        <translation>Felder des Schritts</translation>
    </message>
    <message>
        <source>New program</source>
        <translation>Neues Programm</translation>
    </message>
    <message>
        <source>Rename program…</source>
        <translation>Programm umbenennen …</translation>
    </message>
    <message>
        <source>Delete program</source>
        <translation>Programm löschen</translation>
    </message>
    <message>
        <source>Export script…</source>
        <translation>Skript exportieren …</translation>
    </message>
    <message>
        <source>Paste steps</source>
        <translation>Schritte einfügen</translation>
    </message>
    <message>
        <source>Cut steps</source>
        <translation>Schritte ausschneiden</translation>
    </message>
    <message>
        <source>Copy steps</source>
        <translation>Schritte kopieren</translation>
    </message>
    <message>
        <source>Duplicate steps</source>
        <translation>Schritte duplizieren</translation>
    </message>
    <message>
        <source>Delete steps</source>
        <translation>Schritte löschen</translation>
    </message>
    <message>
        <source>Disable or enable steps</source>
        <translation>Schritte deaktivieren oder aktivieren</translation>
    </message>
    <message>
        <source>Move steps up</source>
        <translation>Schritte nach oben verschieben</translation>
    </message>
    <message>
        <source>Move steps down</source>
        <translation>Schritte nach unten verschieben</translation>
    </message>
    <message>
        <source>Move steps into the section above</source>
        <translation>Schritte in den Abschnitt darüber verschieben</translation>
    </message>
    <message>
        <source>Move steps out of the section</source>
        <translation>Schritte aus dem Abschnitt herausnehmen</translation>
    </message>
    <message>
        <source>Drag steps into the program, or double-click them.</source>
        <translation>Ziehen Sie Schritte in das Programm, oder doppelklicken Sie sie an.</translation>
    </message>
    <message>
        <source>⚠ Step %1: %2</source>
        <translation>⚠ Schritt %1: %2</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>The program can run. Press “Preview” to simulate it.</source>
        <translation>Das Programm ist ausführbar. Drücken Sie „Vorschau“, um es zu simulieren.</translation>
    </message>
    <message>
        <source>Add steps</source>
        <translation>Schritte hinzufügen</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>„%1“ hinzufügen</translation>
    </message>
    <message>
        <source>Rename program</source>
        <translation>Programm umbenennen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>„%1“ in „%2“ umbenennen</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>„%1“ löschen</translation>
    </message>
    <message>
        <source>Disable steps</source>
        <translation>Schritte deaktivieren</translation>
    </message>
    <message>
        <source>Enable steps</source>
        <translation>Schritte aktivieren</translation>
    </message>
    <message>
        <source>Simulating…</source>
        <translation>Simulation läuft …</translation>
    </message>
    <message>
        <source>Simulated: the program takes %1 s. No problems found.</source>
        <translation>Simuliert: Das Programm dauert %1 s. Keine Probleme gefunden.</translation>
    </message>
    <message numerus="yes">
        <source>⚠ Simulated: %n problem(s) found. %1</source>
        <translation>
            <numerusform>⚠ Simuliert: %n Problem gefunden. %1</numerusform>
            <numerusform>⚠ Simuliert: %n Probleme gefunden. %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Export script</source>
        <translation>Skript exportieren</translation>
    </message>
    <message>
        <source>URScript (*.script)</source>
        <translation>URScript (*.script)</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportiert nach %1</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Startet…</translation>
    </message>
    <message>
        <source>Running step %1 (%2)</source>
        <translation>Schritt %1 (%2) läuft</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Hält an…</translation>
    </message>
    <message>
        <source>Paused before step %1 (%2)</source>
        <translation>Pausiert vor Schritt %1 (%2)</translation>
    </message>
    <message>
        <source>Pausing after step %1 (%2)</source>
        <translation>Pausiert nach Schritt %1 (%2)</translation>
    </message>
    <message>
        <source>Simulated: two cycles of the endless program take %1 s. No problems found.</source>
        <translation>Simuliert: Zwei Zyklen des Endlosprogramms dauern %1 s. Keine Probleme gefunden.</translation>
    </message>
    <message>
        <source>Check recoverability</source>
        <translation>Fortsetzbarkeit prüfen</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>Die Prüfung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Cancel check</source>
        <translation>Prüfung abbrechen</translation>
    </message>
    <message>
        <source>In simulation, the program can continue after a stop in %1 of %2 steps.</source>
        <translation>In der Simulation kann das Programm nach einem Stopp in %1 von %2 Schritten fortgesetzt werden.</translation>
    </message>
    <message>
        <source>Add or remove breakpoints</source>
        <translation>Haltepunkte setzen oder entfernen</translation>
    </message>
    <message>
        <source>⚠ The program cannot pause before this step.</source>
        <translation>⚠ Das Programm kann vor diesem Schritt nicht pausieren.</translation>
    </message>
    <message>
        <source>New breakpoints take effect at the next start.</source>
        <translation>Neue Haltepunkte gelten ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>The program is running, so it cannot be deleted. Stop the program first.</source>
        <translation>Das Programm läuft und kann nicht gelöscht werden. Halten Sie zuerst das Programm an.</translation>
    </message>
    <message>
        <source>Paused on the robot in step %1 (%2)</source>
        <translation>Auf dem Roboter pausiert in Schritt %1 (%2)</translation>
    </message>
    <message>
        <source>Program “%1” deleted. Ctrl+Z restores it.</source>
        <translation>Programm „%1“ gelöscht. Strg+Z stellt es wieder her.</translation>
    </message>
    <message>
        <source>Import program…</source>
        <translation>Programm importieren …</translation>
    </message>
    <message>
        <source>Import program</source>
        <translation>Programm importieren</translation>
    </message>
    <message>
        <source>Robot programs (*.script *.urp *.urpx);;All files (*)</source>
        <translation>Roboterprogramme (*.script *.urp *.urpx);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <translation>%1 wird importiert …</translation>
    </message>
    <message>
        <source>Import “%1”</source>
        <translation>„%1“ importieren</translation>
    </message>
    <message>
        <source>Imported “%1”.</source>
        <translation>„%1“ importiert.</translation>
    </message>
    <message>
        <source>⚠ The import failed. The project is unchanged.</source>
        <translation>⚠ Der Import ist fehlgeschlagen. Das Projekt ist unverändert.</translation>
    </message>
    <message>
        <source>Step %1 (%2)</source>
        <translation>Schritt %1 (%2)</translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation>Nicht geprüft: %1.</translation>
    </message>
    <message>
        <source>Checking recoverability…</source>
        <translation>Fortsetzbarkeit wird geprüft…</translation>
    </message>
    <message>
        <source>⚠ Correct the problems in the program first.</source>
        <translation>⚠ Korrigieren Sie zuerst das Programm.</translation>
    </message>
    <message>
        <source>Outputs were changed after the stop, so the program cannot continue. Run the program from the beginning.</source>
        <translation>Ausgänge wurden nach dem Anhalten geändert. Das Programm kann nicht fortgesetzt werden. Starten Sie es am Anfang.</translation>
    </message>
    <message>
        <source>The program was changed after the stop, so it cannot continue. Run the program from the beginning.</source>
        <translation>Das Programm wurde nach dem Anhalten geändert und kann nicht fortgesetzt werden. Starten Sie es am Anfang.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) changed because the project changed. Press “Preview” to simulate the program.</source>
        <translation>
            <numerusform>%n Schritt hat sich mit dem Projekt geändert. Drücken Sie „Vorschau“, um das Programm zu simulieren.</numerusform>
            <numerusform>%n Schritte haben sich mit dem Projekt geändert. Drücken Sie „Vorschau“, um das Programm zu simulieren.</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused before step %1 (%2) because of the maximum hold time. Hold “Continue (hold)” to continue.</source>
        <translation>Pausiert vor Schritt %1 (%2) wegen der maximalen Haltezeit. Halten Sie „Fortsetzen (halten)“ gedrückt, um fortzufahren.</translation>
    </message>
    <message>
        <source>Running step %1 (%2). Joint moves are slow because the preview did not run the whole program from this position.</source>
        <translation>Schritt %1 (%2) läuft. Gelenkbewegungen sind langsam, weil die Vorschau nicht das ganze Programm ab dieser Position ausgeführt hat.</translation>
    </message>
    <message>
        <source>Not run: %1.</source>
        <translation>Nicht ausgeführt: %1.</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectDocument</name>
    <message>
        <source>Delete “%1”</source>
        <translation>„%1“ löschen</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n waypoints</source>
        <translation>
            <numerusform>%n Wegpunkt löschen</numerusform>
            <numerusform>%n Wegpunkte löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>Reihenfolge ändern</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFiles</name>
    <message>
        <source>The damaged project file was kept as %1.</source>
        <translation>Die beschädigte Projektdatei wurde als %1 aufbewahrt</translation>
    </message>
    <message>
        <source>The project could not be saved</source>
        <translation>Das Projekt konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>%1. Update Tiller to open the file. The file was not changed.</source>
        <translation>%1. Aktualisieren Sie Tiller, um sie zu öffnen. Die Datei wurde nicht geändert.</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Tiller projects (*.tiller)</source>
        <translation>Tiller-Projekte (*.tiller)</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>The project could not be opened</source>
        <translation>Das Projekt konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Opened a copy of “%1”. Save the copy to a file to keep changes.</source>
        <translation>Eine Kopie von „%1“ ist geöffnet. Speichern Sie sie in eine Datei, um Änderungen zu behalten.</translation>
    </message>
    <message>
        <source>“%1” is a copy with unsaved changes.</source>
        <translation>„%1“ ist eine Kopie mit ungespeicherten Änderungen.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation>%1 ist beschädigt</translation>
    </message>
    <message>
        <source>%1. Readable waypoints: %2, unreadable: %3. The damaged file is kept.</source>
        <translation>%1. Lesbare Wegpunkte: %2, nicht lesbare: %3. Die beschädigte Datei wird aufbewahrt.</translation>
    </message>
    <message numerus="yes">
        <source>Open %n waypoints</source>
        <translation>
            <numerusform>%n Wegpunkt öffnen</numerusform>
            <numerusform>%n Wegpunkte öffnen</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes are saved to %1 again.</source>
        <translation>%1 wird wieder gespeichert</translation>
    </message>
    <message>
        <source>The other window closed %1. This window saves changes again.</source>
        <translation>Das andere Fenster hat %1 geschlossen. Dieses Fenster speichert Änderungen wieder.</translation>
    </message>
    <message>
        <source>%1 is open in another window</source>
        <translation>%1 ist in einem anderen Fenster geöffnet</translation>
    </message>
    <message>
        <source>Opened by %1. Changes in this window are not saved to the file until you take over the project.</source>
        <translation>Geöffnet von %1. Änderungen in diesem Fenster werden erst in der Datei gespeichert, wenn Sie das Projekt übernehmen.</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Save as a copy</source>
        <translation>Als Kopie speichern</translation>
    </message>
    <message>
        <source>View only</source>
        <translation>Nur ansehen</translation>
    </message>
    <message>
        <source>Another window or program has changed %1</source>
        <translation>Ein anderes Fenster oder Programm hat %1 geändert</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>Beide behalten</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>Später entscheiden</translation>
    </message>
    <message>
        <source>Reloaded %1</source>
        <translation>%1 neu geladen</translation>
    </message>
    <message>
        <source>The project in this window is now %1.</source>
        <translation>Das Projekt dieses Fensters ist jetzt %1</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>Unbenanntes Projekt</translation>
    </message>
    <message>
        <source>Unsaved work can be recovered</source>
        <translation>Ungespeicherte Arbeit kann wiederhergestellt werden</translation>
    </message>
    <message>
        <source>“%1” was changed on %2 and not saved to a file.</source>
        <translation>„%1“ wurde am %2 geändert und nicht in einer Datei gespeichert.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Ask again next time</source>
        <translation>Nächstes Mal erneut fragen</translation>
    </message>
    <message>
        <source>%1 has unsaved changes. %2</source>
        <translation>%1 enthält ungespeicherte Änderungen. %2</translation>
    </message>
    <message>
        <source>The project has unsaved changes.</source>
        <translation>Das Projekt enthält ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>“Keep both” saves the project of this window to a second file. “Reload” shows the new content. Tiller then offers to restore the unsaved changes at the next start.</source>
        <translation>„Beide behalten“ speichert das Projekt dieses Fensters in einer zweiten Datei. „Neu laden“ zeigt den neuen Inhalt; nicht gespeicherte Änderungen dieses Fensters werden dann beim nächsten Start angeboten.</translation>
    </message>
    <message>
        <source>Unreadable boxes and planes of the cell: %1. Collisions with these objects are not prevented.</source>
        <translation>Nicht lesbare Quader und Ebenen der Zelle: %1. Kollisionen mit ihnen werden nicht verhindert.</translation>
    </message>
    <message>
        <source>The unsaved work in “%1” will be deleted. This cannot be undone.</source>
        <translation>Die nicht gespeicherte Arbeit in „%1“ wird gelöscht. Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>The project could not be taken over</source>
        <translation>Das Projekt konnte nicht übernommen werden</translation>
    </message>
    <message>
        <source>%1 already exists. Choose a different name for the new project.</source>
        <translation>%1 existiert bereits. Wählen Sie einen anderen Namen für das neue Projekt.</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFit</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weitere</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>TCP of %1</source>
        <translation>TCP von %1</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but a %2 is connected. The same joint positions lead to different poses.</source>
        <translation>Das Projekt wurde mit einem %1 geteacht, verbunden ist aber ein %2. Dieselben Gelenkstellungen führen zu anderen Posen.</translation>
    </message>
    <message>
        <source>The project uses the TCP “%1”. The active TCP of the robot differs by %2.</source>
        <translation>Das Projekt verwendet den TCP „%1“. Der aktive TCP des Roboters weicht um %2 ab.</translation>
    </message>
    <message>
        <source>The project matches the connected robot.</source>
        <translation>Das Projekt passt zum verbundenen Roboter.</translation>
    </message>
    <message>
        <source>No robot is connected. Connect the robot that belongs to this project.</source>
        <translation>Kein Roboter ist verbunden. Verbinden Sie den Roboter, der zu diesem Projekt gehört.</translation>
    </message>
    <message>
        <source>Keep poses</source>
        <translation>Posen beibehalten</translation>
    </message>
    <message>
        <source>Keep joints</source>
        <translation>Gelenke beibehalten</translation>
    </message>
    <message>
        <source>TCP differs from the project</source>
        <translation>TCP weicht vom Projekt ab</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>„%1“ am Roboter setzen</translation>
    </message>
    <message>
        <source>Keep the robot&apos;s TCP</source>
        <translation>TCP des Roboters beibehalten</translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same poses</source>
        <translation>Von %1 nach %2 umrechnen, Posen beibehalten</translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same joint positions</source>
        <translation>Von %1 nach %2 umrechnen, Gelenkpositionen beibehalten</translation>
    </message>
    <message>
        <source>Out of reach: %1.</source>
        <translation>Außer Reichweite: %1.</translation>
    </message>
    <message>
        <source>Removed because they are out of reach: %1. Press Ctrl+Z to restore them.</source>
        <translation>Entfernt, weil außer Reichweite: %1. Rückgängig stellt sie wieder her.</translation>
    </message>
    <message>
        <source>Some positions are out of reach</source>
        <translation>Einige Positionen sind außer Reichweite</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>The robot model is not known yet. Wait until the robot reports the model.</source>
        <translation>Das Robotermodell ist noch nicht bekannt. Warten Sie, bis der Roboter es meldet.</translation>
    </message>
    <message>
        <source>Project for a different robot model</source>
        <translation>Projekt für ein anderes Robotermodell</translation>
    </message>
    <message>
        <source>“Keep poses” recalculates the joint positions; the tool reaches the same poses. “Keep joints” keeps the arm configuration; the tool reaches different poses. Until you decide, moves to positions in the project are blocked.</source>
        <translation>„Posen beibehalten“ berechnet die Gelenkstellungen neu; das Werkzeug erreicht dieselben Posen. „Gelenke beibehalten“ behält die Stellung des Arms; das Werkzeug erreicht andere Posen. Bis Sie entscheiden, sind Bewegungen zu Positionen des Projekts gesperrt.</translation>
    </message>
    <message>
        <source>With the robot&apos;s TCP, the flange moves to the same poses as taught, but the TCP does not. Until you decide, moves to positions in the project are blocked.</source>
        <translation>Mit dem TCP des Roboters erreicht der Flansch die geteachten Posen, der TCP jedoch nicht. Bis Sie entscheiden, sind Bewegungen zu Positionen des Projekts gesperrt.</translation>
    </message>
    <message>
        <source>Moves to positions in this project are blocked</source>
        <translation>Bewegungen zu Positionen dieses Projekts sind gesperrt</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectStore</name>
    <message>
        <source>%1 — a copy, not saved to a file</source>
        <translation>%1 — eine Kopie, nicht in einer Datei gespeichert</translation>
    </message>
    <message>
        <source>Project not saved to a file</source>
        <translation>Projekt nicht in einer Datei gespeichert</translation>
    </message>
    <message>
        <source>disk full</source>
        <translation>Datenträger voll</translation>
    </message>
    <message>
        <source>%1 — not saved: %2</source>
        <translation>%1 — nicht gespeichert: %2</translation>
    </message>
    <message>
        <source>%1 — saving…</source>
        <translation>%1 — speichere…</translation>
    </message>
    <message>
        <source>%1 — saved</source>
        <translation>%1 — gespeichert</translation>
    </message>
    <message>
        <source>No file is selected for the project. Save the project to a file first.</source>
        <translation>Für das Projekt ist keine Datei gewählt. Speichern Sie das Projekt zuerst in einer Datei.</translation>
    </message>
    <message>
        <source>%1 — open in another window; changes here are not saved</source>
        <translation>%1 — in einem anderen Fenster geöffnet, Änderungen hier werden nicht gespeichert</translation>
    </message>
    <message>
        <source>%1 — changed by another program; changes here are not saved</source>
        <translation>%1 — von einem anderen Programm geändert, Änderungen hier werden nicht gespeichert</translation>
    </message>
    <message>
        <source>Unsaved project</source>
        <translation>Ungespeichertes Projekt</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>ein anderes Programm</translation>
    </message>
    <message>
        <source>%1 — new</source>
        <translation>%1 — neu</translation>
    </message>
    <message>
        <source>%1 is open in another window (%2). Close the project in that window, or save under a different name.</source>
        <translation>%1 ist in einem anderen Fenster geöffnet (%2). Schließen Sie die Datei dort, oder speichern Sie unter einem anderen Namen.</translation>
    </message>
    <message>
        <source>%1 was changed by another program. Reload the project, or save it under a different name.</source>
        <translation>%1 wurde von einem anderen Programm geändert. Laden Sie die Datei neu, oder speichern Sie unter einem anderen Namen.</translation>
    </message>
</context>
<context>
    <name>tiller::RangeStatisticsCache</name>
    <message>
        <source>The range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation>Der Bereich enthält Messwerte verschiedener Roboter. Setzen Sie die Cursor A und B in die Daten eines Roboters.</translation>
    </message>
</context>
<context>
    <name>tiller::RecordingsDialog</name>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Auswählen…</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Ordner auswählen</translation>
    </message>
    <message>
        <source>Search recordings</source>
        <translation>Aufzeichnungen suchen</translation>
    </message>
    <message>
        <source>Search name, date, metadata and notes</source>
        <translation>Name, Datum, Metadaten und Notizen durchsuchen</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>Metadaten</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>This folder contains no recordings.</source>
        <translation>Dieser Ordner enthält keine Aufzeichnungen.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n recording(s)</source>
        <translation>
            <numerusform>%1 von %n Aufzeichnung</numerusform>
            <numerusform>%1 von %n Aufzeichnungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reading %n file(s)…</source>
        <translation>
            <numerusform>%n Datei wird gelesen…</numerusform>
            <numerusform>%n Dateien werden gelesen…</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder with recordings</source>
        <translation>Ordner mit Aufzeichnungen</translation>
    </message>
</context>
<context>
    <name>tiller::RecoveryPage</name>
    <message>
        <source>Recovery</source>
        <translation>Wiederherstellung</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Kraft am TCP</translation>
    </message>
    <message>
        <source>Joint current</source>
        <translation>Gelenkstrom</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>Geschwindigkeit des TCP</translation>
    </message>
    <message>
        <source>Waiting for data from the robot…</source>
        <translation>Warte auf Daten vom Roboter…</translation>
    </message>
    <message>
        <source>Stopped at X %1, Y %2, Z %3.</source>
        <translation>Gestoppt bei X %1, Y %2, Z %3.</translation>
    </message>
    <message>
        <source>Suspected joint: %1 (largest deviation from its target current).</source>
        <translation>Verdächtiges Gelenk: %1 (größte Abweichung vom Sollstrom).</translation>
    </message>
    <message>
        <source> (%1 s)</source>
        <translation> (%1 s)</translation>
    </message>
    <message>
        <source>Tick the items that you have checked.</source>
        <translation>Haken Sie die Punkte ab, die Sie geprüft haben.</translation>
    </message>
    <message>
        <source>Command sent; waiting for the robot…</source>
        <translation>Befehl gesendet; warten auf den Roboter…</translation>
    </message>
</context>
<context>
    <name>tiller::RegisterPanel</name>
    <message>
        <source>General purpose registers</source>
        <translation>Allgemeine Register</translation>
    </message>
    <message>
        <source>Int %1</source>
        <translation>Ganzzahl %1</translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation>Float %1</translation>
    </message>
    <message>
        <source>Int</source>
        <translation>Ganzzahl</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Float</translation>
    </message>
    <message>
        <source>Bit</source>
        <translation>Bit</translation>
    </message>
    <message>
        <source>Input register type</source>
        <translation>Typ des Eingangsregisters</translation>
    </message>
    <message>
        <source>Input register number</source>
        <translation>Nummer des Eingangsregisters</translation>
    </message>
    <message>
        <source>Input register value</source>
        <translation>Wert des Eingangsregisters</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
</context>
<context>
    <name>tiller::ReplayBand</name>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Zurück zu Live</translation>
    </message>
    <message>
        <source>Show the current state of the robot. The recording stays open in the plots.</source>
        <translation>Aktuellen Zustand des Roboters zeigen. Die Aufzeichnung bleibt in den Diagrammen offen.</translation>
    </message>
</context>
<context>
    <name>tiller::RobotPopup</name>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Popup on the robot</source>
        <translation>Meldungsfenster am Roboter</translation>
    </message>
    <message>
        <source>Tiller could not close the popup. Close the popup on the teach pendant.</source>
        <translation>Tiller konnte das Popup nicht schließen. Schließen Sie es am Teach-Pendant.</translation>
    </message>
    <message>
        <source>No data from the robot. Close the popup on the teach pendant.</source>
        <translation>Keine Daten vom Roboter. Schließen Sie das Popup am Teach-Pendant.</translation>
    </message>
    <message numerus="yes">
        <source>%n more popup(s) on the robot.</source>
        <translation>
            <numerusform>%n weiteres am Roboter.</numerusform>
            <numerusform>%n weitere am Roboter.</numerusform>
        </translation>
    </message>
    <message>
        <source>A waiting program continues when the popup is closed: keep clear of the arm.</source>
        <translation>Ein wartendes Programm läuft weiter, sobald das Popup geschlossen wird: Halten Sie Abstand vom Arm.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Close the popup on the robot</source>
        <translation>Das Meldungsfenster am Roboter schließen</translation>
    </message>
    <message>
        <source>Hide the popup</source>
        <translation>Das Meldungsfenster ausblenden</translation>
    </message>
    <message>
        <source>Read the popup first.</source>
        <translation>Lesen Sie zuerst die Meldung des Roboters.</translation>
    </message>
    <message>
        <source>The popup is being closed.</source>
        <translation>Das Popup wird gerade geschlossen.</translation>
    </message>
</context>
<context>
    <name>tiller::RobotSession</name>
    <message>
        <source>Stopped: %1 (%2 ms, %3)</source>
        <translation>Gestoppt: %1 (%2 ms, %3)</translation>
    </message>
    <message>
        <source>Connecting to %1 (%2)</source>
        <translation>Verbinde mit %1 (%2)</translation>
    </message>
    <message>
        <source>Disconnected from %1</source>
        <translation>Von %1 getrennt</translation>
    </message>
    <message>
        <source>In control</source>
        <translation>Gesteuert</translation>
    </message>
    <message>
        <source>Taking control was cancelled by a stop.</source>
        <translation>Die Übernahme der Steuerung wurde durch einen Stopp abgebrochen.</translation>
    </message>
    <message>
        <source>Connected to %1</source>
        <translation>Mit %1 verbunden</translation>
    </message>
    <message>
        <source>Safety mode is Normal again</source>
        <translation>Sicherheitsmodus wieder „Normal“</translation>
    </message>
    <message>
        <source>Program: %1</source>
        <translation>Programm: %1</translation>
    </message>
    <message>
        <source>Program error on line %1, column %2: %3</source>
        <translation>Programmfehler in Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>Popup on the robot: %1 %2</source>
        <translation>Meldungsfenster am Roboter: %1 %2</translation>
    </message>
    <message>
        <source>The program on the robot is waiting for a response on the teach pendant: %1</source>
        <translation>Das Programm auf dem Roboter wartet auf eine Antwort am Teach-Pendant: %1</translation>
    </message>
    <message>
        <source>Not connected to a robot.</source>
        <translation>Mit keinem Roboter verbunden.</translation>
    </message>
    <message>
        <source>Waiting for data from %1.</source>
        <translation>Warte auf Daten von %1.</translation>
    </message>
    <message>
        <source>Connecting to %1…</source>
        <translation>Verbinde mit %1…</translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically; motion does not resume.</source>
        <translation>Keine Daten vom Roboter. Die Verbindung wird automatisch wiederhergestellt; die Bewegung wird nicht fortgesetzt.</translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation>Die Daten des Roboters sind verspätet. Warten auf neue Daten.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Übernehme Steuerung…</translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. STOP still works.</source>
        <translation>Nur beobachten: Dieses Fenster ändert am Roboter nichts. STOP funktioniert weiterhin.</translation>
    </message>
    <message>
        <source>“Monitor only” is off. Commands to the robot are enabled.</source>
        <translation>„Nur beobachten“ ist aus. Befehle an den Roboter sind möglich.</translation>
    </message>
    <message>
        <source>%1: refused. %2</source>
        <translation>%1: abgelehnt. %2</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Steuerung übernehmen</translation>
    </message>
    <message>
        <source>Control was lost: the control connection did not respond for 0.5 s or was closed. STOP, Space and Esc still stop the robot. Take control again.</source>
        <translation>Die Steuerung ging verloren: Die Steuerverbindung hat 0,5 s lang nicht geantwortet oder wurde geschlossen. STOP, Leertaste und Esc halten den Roboter weiterhin an. Übernehmen Sie die Steuerung erneut.</translation>
    </message>
    <message numerus="yes">
        <source>The robot is sending too many messages. %n messages were not shown.</source>
        <translation>
            <numerusform>Der Roboter sendet zu viele Meldungen. %n Meldung wurde nicht angezeigt.</numerusform>
            <numerusform>Der Roboter sendet zu viele Meldungen. %n Meldungen wurden nicht angezeigt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move refused: %1.</source>
        <translation>Bewegung abgelehnt: %1.</translation>
    </message>
    <message>
        <source>Moves are refused. %1.</source>
        <translation>Bewegungen werden abgelehnt. %1.</translation>
    </message>
    <message>
        <source>No data from the robot: the arm may be moving. Reconnecting automatically.</source>
        <translation>Keine Daten vom Roboter: Der Arm bewegt sich möglicherweise. Die Verbindung wird automatisch wiederhergestellt.</translation>
    </message>
    <message>
        <source>A program is running. Wait until the program ends, or stop the program.</source>
        <translation>Ein Programm läuft. Warten Sie, bis das Programm endet, oder stoppen Sie es.</translation>
    </message>
    <message>
        <source>Stopping the other client&apos;s program to take control.</source>
        <translation>Das Programm des anderen Clients wird beendet, um die Steuerung zu übernehmen.</translation>
    </message>
    <message>
        <source>The program on the robot is paused.</source>
        <translation>Das Programm auf dem Roboter ist pausiert.</translation>
    </message>
    <message>
        <source>Robot mode: %1</source>
        <translation>Roboter-Modus: %1</translation>
    </message>
    <message>
        <source>Stopped: %1 (%2)</source>
        <translation>Gestoppt: %1 (%2)</translation>
    </message>
    <message>
        <source>Not stopped: a program is still running (%1). Press STOP again.</source>
        <translation>Nicht gestoppt: Ein Programm läuft noch (%1). Drücken Sie erneut STOP.</translation>
    </message>
    <message>
        <source>Not stopped: the arm is still moving (%1). Press STOP again.</source>
        <translation>Nicht angehalten: Der Arm bewegt sich (%1). Drücken Sie erneut STOP.</translation>
    </message>
    <message>
        <source>The robot at %1 is a %2 now. It was a %3 before.</source>
        <translation>Der Roboter an %1 ist jetzt ein %2. Vorher war es ein %3.</translation>
    </message>
    <message>
        <source>A program from another client has replaced the running program.</source>
        <translation>Ein Programm eines anderen Clients hat das laufende Programm ersetzt.</translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot. Taking control ends that program.</source>
        <translation>Ein Programm eines anderen Clients hat den Roboter übernommen. Übernehmen der Steuerung beendet es.</translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot, and control was lost. Taking control again ends that program.</source>
        <translation>Ein Programm eines anderen Clients hat den Roboter übernommen, die Steuerung ging verloren. Erneutes Übernehmen der Steuerung beendet dieses Programm.</translation>
    </message>
    <message>
        <source>A program from another client is running on the robot.</source>
        <translation>Auf dem Roboter läuft ein Programm eines anderen Clients.</translation>
    </message>
    <message>
        <source>while moving to point %1 of %2: %3</source>
        <translation>auf dem Weg zu Punkt %1 von %2: %3</translation>
    </message>
    <message>
        <source>The program from the other client has ended.</source>
        <translation>Das Programm des anderen Clients ist beendet.</translation>
    </message>
    <message>
        <source>The program started while Tiller was not connected, at most %1 s before this entry.</source>
        <translation>Das Programm startete ohne Verbindung zu Tiller, höchstens %1 s vor diesem Eintrag.</translation>
    </message>
</context>
<context>
    <name>tiller::RobotiqLink</name>
    <message>
        <source>Connecting to the gripper…</source>
        <translation>Verbinde mit dem Greifer…</translation>
    </message>
    <message>
        <source>The gripper does not send any values. Power on the arm. If the problem persists, check the gripper cable at the wrist.</source>
        <translation>Der Greifer sendet keine Werte. Schalten Sie den Arm ein; wenn das Problem bleibt, prüfen Sie das Greiferkabel am Handgelenk.</translation>
    </message>
    <message>
        <source>The gripper responds again.</source>
        <translation>Der Greifer antwortet wieder.</translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation>Der Greifer ist aktiv.</translation>
    </message>
    <message>
        <source>The gripper was not activated. Check that nothing blocks its fingers, then press “Activate” again.</source>
        <translation>Der Greifer wurde nicht aktiviert. Prüfen Sie, ob etwas seine Finger blockiert, und drücken Sie dann erneut „Aktivieren“.</translation>
    </message>
    <message>
        <source>The gripper holds an object (%1 open).</source>
        <translation>Der Greifer hält ein Objekt (%1 geöffnet).</translation>
    </message>
    <message>
        <source>The gripper lost the object.</source>
        <translation>Der Greifer hat das Objekt verloren.</translation>
    </message>
    <message>
        <source>Gripper: activate</source>
        <translation>Greifer: aktivieren</translation>
    </message>
    <message>
        <source>%1 failed. %2</source>
        <translation>%1 ist fehlgeschlagen. %2</translation>
    </message>
    <message>
        <source>No gripper service responds at %1:%2. Install Robotiq&apos;s URCap on the robot and select the gripper in the robot&apos;s installation.</source>
        <translation>Unter %1:%2 antwortet kein Greiferdienst. Installieren Sie die URCap von Robotiq auf dem Roboter und wählen Sie den Greifer in der Installation.</translation>
    </message>
    <message>
        <source>The gripper is not responding. Check the cable at the wrist and the gripper settings on the Installation tab of the teach pendant. If the problem persists, restart the robot.</source>
        <translation>Der Greifer antwortet nicht. Prüfen Sie das Kabel am Handgelenk und die Einstellungen des Greifers am Teach-Pendant unter „Installation“. Wenn das Problem bleibt, starten Sie den Roboter neu.</translation>
    </message>
    <message>
        <source>The gripper did not accept the command. Activate the gripper. If it is already active, check its settings on the Installation tab of the teach pendant.</source>
        <translation>Der Greifer hat den Befehl nicht angenommen. Aktivieren Sie ihn. Ist er aktiv, prüfen Sie seine Einstellungen am Teach-Pendant unter „Installation“.</translation>
    </message>
    <message>
        <source>The gripper is activating; the command runs afterwards.</source>
        <translation>Der Greifer wird aktiviert; der Befehl wird danach ausgeführt.</translation>
    </message>
    <message>
        <source>The gripper received a motion command before it was active. Press “Activate”.</source>
        <translation>Der Greifer hat einen Bewegungsbefehl erhalten, bevor er aktiv war. Drücken Sie „Aktivieren“.</translation>
    </message>
    <message>
        <source>The gripper is too hot. Let it cool down, then press “Activate”.</source>
        <translation>Der Greifer ist zu heiß. Lassen Sie ihn abkühlen, dann drücken Sie Aktivieren.</translation>
    </message>
    <message>
        <source>The gripper received no command for one second. Check its cable at the wrist, then press “Activate”.</source>
        <translation>Der Greifer hat eine Sekunde lang keinen Befehl erhalten. Prüfen Sie sein Kabel am Handgelenk und drücken Sie dann „Aktivieren“.</translation>
    </message>
    <message>
        <source>The supply voltage of the gripper is too low. Set the tool voltage to 24 V, then press “Activate”.</source>
        <translation>Die Versorgungsspannung des Greifers ist zu niedrig. Stellen Sie die Werkzeugspannung auf 24 V und drücken Sie dann „Aktivieren“.</translation>
    </message>
    <message>
        <source>The automatic release of the gripper is in progress. Wait until it is complete, then press “Activate”.</source>
        <translation>Das automatische Lösen des Greifers läuft. Warten Sie, bis es abgeschlossen ist, und drücken Sie dann „Aktivieren“.</translation>
    </message>
    <message>
        <source>The automatic release of the gripper is complete. Press “Activate”.</source>
        <translation>Das automatische Lösen des Greifers ist abgeschlossen. Drücken Sie „Aktivieren“.</translation>
    </message>
    <message>
        <source>The gripper has an internal fault. Press “Activate”. If the fault returns, contact Robotiq.</source>
        <translation>Der Greifer hat einen internen Fehler. Drücken Sie „Aktivieren“; wenn der Fehler erneut auftritt, wenden Sie sich an Robotiq.</translation>
    </message>
    <message>
        <source>Activation failed. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation>Die Aktivierung ist fehlgeschlagen. Prüfen Sie, ob etwas die Finger blockiert, und drücken Sie dann „Aktivieren“.</translation>
    </message>
    <message>
        <source>The gripper draws too much current. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation>Der Greifer nimmt zu viel Strom auf. Prüfen Sie, ob etwas die Finger blockiert, und drücken Sie dann „Aktivieren“.</translation>
    </message>
    <message>
        <source>The gripper reports fault %1. Press “Activate”. If the fault returns, see the gripper manual.</source>
        <translation>Der Greifer meldet Fehler %1. Drücken Sie „Aktivieren“; wenn der Fehler erneut auftritt, lesen Sie sein Handbuch.</translation>
    </message>
    <message>
        <source>The robot closed the connection to the gripper and may be restarting. Tiller reconnects automatically; the gripper continues to hold its object.</source>
        <translation>Der Roboter hat die Verbindung zum Greifer geschlossen und startet eventuell neu. Tiller verbindet sich automatisch neu; der Greifer hält weiter.</translation>
    </message>
</context>
<context>
    <name>tiller::RouteRunner</name>
    <message>
        <source>The route has no waypoints. Teach or select waypoints first.</source>
        <translation>Die Route enthält keine Wegpunkte. Teachen oder wählen Sie zuerst Wegpunkte.</translation>
    </message>
    <message>
        <source>A waypoint of the route was deleted from the project. Select the waypoints of the route again.</source>
        <translation>Ein Wegpunkt der Route wurde aus dem Projekt gelöscht. Wählen Sie die Wegpunkte der Route erneut aus.</translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation>„%1“: %2</translation>
    </message>
    <message>
        <source>A loop requires at least two waypoints. Select more waypoints, or clear “Loop”.</source>
        <translation>Eine Schleife benötigt mindestens zwei Wegpunkte. Wählen Sie weitere Wegpunkte oder schalten Sie die Schleife aus.</translation>
    </message>
    <message>
        <source>There is no waypoint before the first waypoint of the route.</source>
        <translation>Vor dem ersten Wegpunkt der Route gibt es keinen Wegpunkt.</translation>
    </message>
</context>
<context>
    <name>tiller::RunBar</name>
    <message>
        <source>Run (hold)</source>
        <translation>Starten (halten)</translation>
    </message>
    <message>
        <source>Run the program (hold)</source>
        <translation>Programm ausführen, halten</translation>
    </message>
    <message>
        <source>Move to start (hold)</source>
        <translation>Zum Start (halten)</translation>
    </message>
    <message>
        <source>Move to the start position (hold)</source>
        <translation>Zur Startposition fahren, halten</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>No program is selected. Create or select a program first.</source>
        <translation>Kein Programm ausgewählt. Erstellen oder wählen Sie zuerst ein Programm.</translation>
    </message>
    <message>
        <source>Stops the program</source>
        <translation>Hält das Programm an</translation>
    </message>
    <message>
        <source>Runs the program at the programmed speed until it ends or is stopped. The arm also stops when Tiller closes or the connection is lost.</source>
        <translation>Führt das Programm mit der programmierten Geschwindigkeit aus, bis es endet oder angehalten wird. Der Arm stoppt auch, wenn Tiller geschlossen wird oder die Verbindung abbricht.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Finish cycle</source>
        <translation>Zyklus beenden</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation>Es läuft kein Programm.</translation>
    </message>
    <message>
        <source>Continues the program</source>
        <translation>Setzt das Programm fort</translation>
    </message>
    <message>
        <source>Pauses the program before its next step</source>
        <translation>Pausiert das Programm vor dem nächsten Schritt</translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation>Pausieren Sie zuerst das Programm.</translation>
    </message>
    <message>
        <source>Runs one step and then pauses the program</source>
        <translation>Führt einen Schritt aus und pausiert dann das Programm</translation>
    </message>
    <message>
        <source>The program has no endless loop.</source>
        <translation>Das Programm hat keine Endlosschleife.</translation>
    </message>
    <message>
        <source>Ends the program before the next cycle of its endless loop</source>
        <translation>Beendet das Programm vor dem nächsten Durchlauf seiner Endlosschleife</translation>
    </message>
    <message>
        <source>Start from here</source>
        <translation>Ab hier</translation>
    </message>
    <message>
        <source>Select one step.</source>
        <translation>Wählen Sie einen Schritt aus.</translation>
    </message>
    <message>
        <source>Moves all joints to the start position while the button is held</source>
        <translation>Fährt alle Gelenke zur Startposition, solange die Taste gehalten wird</translation>
    </message>
    <message>
        <source>Continue at %1</source>
        <translation>Weiter bei %1</translation>
    </message>
    <message>
        <source>Continue (hold)</source>
        <translation>Fortsetzen (halten)</translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation>Das Programm ist auf dem Roboter pausiert. Setzen Sie es am Teach-Pendant fort.</translation>
    </message>
    <message>
        <source>Run program</source>
        <translation>Programm ausführen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The value of “%1” is being changed.</source>
        <translation>Der Wert von „%1“ wird geändert.</translation>
    </message>
    <message>
        <source>Continue program</source>
        <translation>Programm fortsetzen</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>From step %1 ✕</source>
        <translation>Ab %1 ✕</translation>
    </message>
    <message>
        <source>Starts the program at the selected step. Move the arm to the start position first.</source>
        <translation>Beginnt das Programm beim ausgewählten Schritt. Fahren Sie den Arm zuerst zur Startposition.</translation>
    </message>
    <message>
        <source>Hold “Continue (hold)” to continue.</source>
        <translation>Halten Sie „Fortsetzen (halten)“ gedrückt, um fortzufahren.</translation>
    </message>
    <message>
        <source>The preview did not run %1, so these steps were not checked for collisions and other problems. Test them with “Run (hold)”, or set the inputs and preview the program again.</source>
        <translation>Die Vorschau hat nicht alle Schritte ausgeführt (%1). Kollisionen und andere Probleme in diesen Schritten sind nicht bekannt. Testen Sie sie mit „Starten (halten)“, oder setzen Sie die Eingänge und starten Sie die Vorschau erneut.</translation>
    </message>
    <message>
        <source>A variable was changed. The moves after this change were not previewed, so they were not checked for collisions and other problems.</source>
        <translation>Eine Variable wurde geändert. Für die Bewegungen nach dieser Änderung gibt es keine Vorschau. Kollisionen und andere Probleme sind nicht bekannt.</translation>
    </message>
    <message>
        <source>Runs the program while the button is held, no faster than the jog speed. The program ends when you release the button. If the arm is not at the start position of a complete preview, joint moves are slower so that no possible path exceeds the speed limit.</source>
        <translation>Führt das Programm aus, solange die Taste gehalten wird, höchstens mit der Jog-Geschwindigkeit. Das Programm endet beim Loslassen. Gelenkbewegungen sind langsamer, wenn der Arm nicht an der Startposition einer vollständigen Vorschau steht, weil die Geschwindigkeitsgrenze dann für jeden möglichen Weg gelten muss.</translation>
    </message>
    <message>
        <source>The program starts at step %1. Press to start from the beginning instead.</source>
        <translation>Das Programm beginnt bei Schritt %1. Drücken Sie, um wieder am Anfang zu beginnen.</translation>
    </message>
    <message>
        <source>The program started with a jog speed of %1 and cannot continue at a lower speed. Select this speed again, or stop the program.</source>
        <translation>Das Programm wurde mit einer Verfahrgeschwindigkeit von %1 gestartet und kann nicht langsamer fortgesetzt werden. Wählen Sie diese Geschwindigkeit wieder oder stoppen Sie das Programm.</translation>
    </message>
    <message>
        <source>%1 Preview the program with the current inputs, or select a higher jog speed, so that the program can run to the end.</source>
        <translation>%1 Simulieren Sie das Programm mit den aktuellen Eingängen oder wählen Sie eine höhere Verfahrgeschwindigkeit, damit es bis zum Ende laufen kann.</translation>
    </message>
</context>
<context>
    <name>tiller::SceneDock</name>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>No joint positions to replay</source>
        <translation>Keine Gelenkpositionen zum Wiedergeben</translation>
    </message>
    <message>
        <source>Robot model unknown</source>
        <translation>Robotermodell unbekannt</translation>
    </message>
</context>
<context>
    <name>tiller::SceneKeys</name>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Default view (perspective)</source>
        <translation>Standardansicht (perspektivisch)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Look from the front: base X to the right, Z up</source>
        <translation>Blick von vorn: X der Basis nach rechts, Z nach oben</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Look from the side: base Y to the right, Z up</source>
        <translation>Blick von der Seite: Y der Basis nach rechts, Z nach oben</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Look from above: base X to the right, Y up</source>
        <translation>Blick von oben: X der Basis nach rechts, Y nach oben</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view</source>
        <translation>Arm, Ziel und Wegpunkte in die Ansicht einpassen</translation>
    </message>
</context>
<context>
    <name>tiller::SceneView</name>
    <message>
        <source>Arm view</source>
        <translation>Ansicht des Arms</translation>
    </message>
    <message>
        <source>Drag or use the arrow keys to rotate the view; hold Shift or the right button to pan. Zoom with the wheel or with plus and minus. Double-click or press Home for the default view. The robot does not move.</source>
        <translation>Ziehen oder Pfeiltasten drehen die Ansicht; mit Umschalt oder der rechten Maustaste verschieben. Zoomen mit dem Mausrad oder mit Plus und Minus. Doppelklick oder Pos1 zeigt die Standardansicht. Der Roboter bewegt sich nicht.</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>KEINE DATEN</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>ghost “%1” · out of reach</source>
        <translation>Vorschau „%1“ · außer Reichweite</translation>
    </message>
    <message>
        <source>ghost “%1” · reachable · largest rotation %2 %3 · %4 s at %5</source>
        <translation>Vorschau „%1“ · erreichbar · größte Drehung %2 %3 · %4 s bei %5</translation>
    </message>
    <message>
        <source>1 name hidden: zoom in</source>
        <translation>1 Name verborgen: heranzoomen</translation>
    </message>
    <message numerus="yes">
        <source>%n names hidden: zoom in</source>
        <translation>
            <numerusform>%n Name verborgen: heranzoomen</numerusform>
            <numerusform>%n Namen verborgen: heranzoomen</numerusform>
        </translation>
    </message>
    <message>
        <source>ghost “%1” · reachable</source>
        <translation>Vorschau „%1“ · erreichbar</translation>
    </message>
    <message>
        <source>ghost “%1” · %2 · largest rotation %3 %4 · %5 s at %6</source>
        <translation>Vorschau „%1“ · %2 · größte Drehung %3 %4 · %5 s bei %6</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Danach: %1</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Vorher: %1</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>WIEDERGABE</translation>
    </message>
    <message>
        <source>LIVE ARM</source>
        <translation>ROBOTERARM LIVE</translation>
    </message>
    <message>
        <source>ghost “%1” · taught with a different robot model</source>
        <translation>Vorschau „%1“ · mit einem anderen Robotermodell geteacht</translation>
    </message>
</context>
<context>
    <name>tiller::SignalStore</name>
    <message>
        <source>compute a signal</source>
        <translation>ein Signal berechnen</translation>
    </message>
    <message>
        <source>%1 is not part of the same RTDE packets as the other signals.</source>
        <translation>%1 ist nicht in denselben RTDE-Paketen wie die anderen Signale.</translation>
    </message>
    <message>
        <source>Derived</source>
        <translation>Abgeleitet</translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. Remove other signals first.</source>
        <translation>Der Roboter kann nicht so viele Signale auf einmal senden: Entfernen Sie zuerst andere Signale.</translation>
    </message>
    <message>
        <source>The recording %1 contains no samples. Open a different recording.</source>
        <translation>Die Aufzeichnung %1 enthält keine Messwerte. Öffnen Sie eine andere Aufzeichnung.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>The history memory is too small to show %1. Increase the memory in the “Layout” menu.</source>
        <translation>Der Verlaufsspeicher ist zu klein, um %1 zu zeigen: Vergrößern Sie ihn im Menü Layout.</translation>
    </message>
    <message>
        <source>%1 could not be computed completely: %2</source>
        <translation>%1 konnte nicht vollständig berechnet werden: %2</translation>
    </message>
</context>
<context>
    <name>tiller::SignalTree</name>
    <message>
        <source>Search signals</source>
        <translation>Signale suchen</translation>
    </message>
    <message>
        <source>Robot signals</source>
        <translation>Signale des Roboters</translation>
    </message>
    <message>
        <source>New: |F| [N] = norm(…)</source>
        <translation>Neu: |F| [N] = norm(…)</translation>
    </message>
    <message>
        <source>Derived signal</source>
        <translation>Abgeleitetes Signal</translation>
    </message>
    <message>
        <source>%1: not sent by this robot.</source>
        <translation>%1: Dieser Roboter sendet es nicht.</translation>
    </message>
    <message>
        <source>Enter a name, an optional unit in brackets, and an expression that uses signals. Drag signals here to insert their names. Functions: norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ and standard functions. Press Return to create the signal.</source>
        <translation>Geben Sie einen Namen, optional eine Einheit in Klammern und einen Ausdruck mit Signalen ein. Ziehen Sie Signale hierher, um ihre Namen einzufügen. Funktionen: norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ und Standardfunktionen. Enter erstellt das Signal.</translation>
    </message>
</context>
<context>
    <name>tiller::SimulationChip</name>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>This robot is simulated. No real robot moves.</source>
        <translation>Dieser Roboter ist simuliert. Kein echter Roboter bewegt sich.</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULATION</translation>
    </message>
</context>
<context>
    <name>tiller::SpeedChip</name>
    <message>
        <source>Speed slider</source>
        <translation>Geschwindigkeitsregler</translation>
    </message>
    <message>
        <source>Robot speed slider, 2 to 100 %</source>
        <translation>Geschwindigkeitsregler des Roboters, 2 bis 100 %</translation>
    </message>
    <message>
        <source>SPEED</source>
        <translation>TEMPO</translation>
    </message>
</context>
<context>
    <name>tiller::StatusLine</name>
    <message>
        <source>Recording, project and last message</source>
        <translation>Aufzeichnung, Projekt und letzte Meldung</translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation>REC %1</translation>
    </message>
    <message>
        <source>%1 samples · %2 · %3 free</source>
        <translation>%1 Werte · %2 · %3 frei</translation>
    </message>
    <message>
        <source>Recording stopped</source>
        <translation>Aufzeichnung beendet</translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation>Keine Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>tiller::StepForm</name>
    <message>
        <source>Select one step to edit it.</source>
        <translation>Wählen Sie einen Schritt aus, um ihn zu bearbeiten.</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(keine)</translation>
    </message>
</context>
<context>
    <name>tiller::StepPalette</name>
    <message>
        <source>Steps to add</source>
        <translation>Verfügbare Schritte</translation>
    </message>
</context>
<context>
    <name>tiller::StepTree</name>
    <message>
        <source>Program steps</source>
        <translation>Schritte des Programms</translation>
    </message>
</context>
<context>
    <name>tiller::StopButton</name>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Software stop. Not an emergency stop. Power stays on.</source>
        <translation>Software-Stopp. Kein Not-Halt. Die Stromversorgung bleibt an.</translation>
    </message>
    <message>
        <source>Space and Esc also stop the arm.</source>
        <translation>Leertaste und Esc stoppen den Arm ebenfalls.</translation>
    </message>
    <message>
        <source>Click to stop the arm. Space and Esc stop the arm only while this window is in control.</source>
        <translation>Zum Anhalten klicken. Leertaste und Esc halten nur an, solange dieses Fenster die Steuerung hat.</translation>
    </message>
    <message>
        <source>Space / Esc</source>
        <translation>Leertaste / Esc</translation>
    </message>
    <message>
        <source>click</source>
        <translation>klicken</translation>
    </message>
    <message>
        <source>not an e-stop</source>
        <translation>kein Not-Halt</translation>
    </message>
</context>
<context>
    <name>tiller::StopPlot</name>
    <message>
        <source>Maximum in the last five seconds: %1</source>
        <translation>Höchstwert der letzten fünf Sekunden: %1</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>max. %1</translation>
    </message>
    <message>
        <source>no data before the stop</source>
        <translation>keine Daten vor dem Stopp</translation>
    </message>
</context>
<context>
    <name>tiller::TcpPage</name>
    <message>
        <source>In use</source>
        <translation>In Gebrauch</translation>
    </message>
    <message>
        <source>Enter a name for the TCP.</source>
        <translation>Geben Sie einen Namen für den TCP ein.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>„%1“ in „%2“ umbenennen</translation>
    </message>
    <message>
        <source>TCPs</source>
        <translation>TCPs</translation>
    </message>
    <message>
        <source>No TCPs yet.
Press “From robot” to store the active TCP, or “Teach…” to teach a TCP with the arm.</source>
        <translation>Noch keine TCPs.
Drücken Sie „Vom Roboter“, um den aktiven TCP zu speichern, oder „Teachen…“, um einen mit dem Arm zu teachen.</translation>
    </message>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>Relative to the flange. Press Return to apply the value to the project. The robot&apos;s TCP does not change.</source>
        <translation>Relativ zum Flansch. Mit Enter in das Projekt übernehmen. Der TCP des Roboters ändert sich nicht.</translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation>Am Roboter setzen</translation>
    </message>
    <message>
        <source>Use this TCP and set it on the robot</source>
        <translation>Diesen TCP verwenden und am Roboter setzen</translation>
    </message>
    <message>
        <source>Teach…</source>
        <translation>Teachen…</translation>
    </message>
    <message>
        <source>Teach a TCP with the arm</source>
        <translation>Einen TCP mit dem Arm teachen</translation>
    </message>
    <message>
        <source>From robot</source>
        <translation>Vom Roboter</translation>
    </message>
    <message>
        <source>Store the active TCP of the robot</source>
        <translation>Aktiven TCP des Roboters speichern</translation>
    </message>
    <message>
        <source>Teach the selected TCP again…</source>
        <translation>Den gewählten TCP neu teachen…</translation>
    </message>
    <message>
        <source>Enter new TCP</source>
        <translation>Neuen TCP eingeben</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Rename TCP</source>
        <translation>TCP umbenennen</translation>
    </message>
    <message>
        <source>Duplicate TCP</source>
        <translation>TCP duplizieren</translation>
    </message>
    <message>
        <source>Delete TCP</source>
        <translation>TCP löschen</translation>
    </message>
    <message>
        <source>Change the TCP “%1”</source>
        <translation>Den TCP „%1“ ändern</translation>
    </message>
    <message>
        <source>Teach the TCP “%1” again</source>
        <translation>Den TCP „%1“ neu teachen</translation>
    </message>
    <message>
        <source>Add the TCP “%1”</source>
        <translation>Den TCP „%1“ hinzufügen</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>Kein Roboter ist verbunden. Verbinden Sie einen oder probieren Sie den Simulator.</translation>
    </message>
    <message>
        <source>The active TCP of the robot is already stored as “%1”.</source>
        <translation>Der aktive TCP des Roboters ist bereits als „%1“ gespeichert.</translation>
    </message>
    <message>
        <source>Teach “%1” again</source>
        <translation>„%1“ neu teachen</translation>
    </message>
    <message>
        <source>Teach a new TCP</source>
        <translation>Einen neuen TCP teachen</translation>
    </message>
    <message>
        <source>Select the TCP to set.</source>
        <translation>Wählen Sie einen TCP zum Setzen.</translation>
    </message>
    <message>
        <source>Use the TCP “%1”</source>
        <translation>Den TCP „%1“ verwenden</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller hat nicht die Steuerung. Übernehmen Sie zuerst die Steuerung.</translation>
    </message>
    <message>
        <source>Delete the TCP “%1”</source>
        <translation>Den TCP „%1“ löschen</translation>
    </message>
    <message>
        <source>%1, relative to the flange</source>
        <translation>%1, vom Flansch</translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation>%1, auf dem Roboter aktiv</translation>
    </message>
    <message>
        <source>%1, %2 from the robot&apos;s TCP</source>
        <translation>%1, %2 von dem des Roboters</translation>
    </message>
    <message>
        <source>The robot&apos;s TCP differs from “%1”</source>
        <translation>Der TCP des Roboters weicht von „%1“ ab</translation>
    </message>
    <message>
        <source>On the robot: %1. In the project: %2. Difference: %3. Nothing was changed.</source>
        <translation>Am Roboter: %1. Im Projekt: %2. Abstand: %3. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>„%1“ am Roboter setzen</translation>
    </message>
    <message>
        <source>Set TCP on robot</source>
        <translation>TCP am Roboter setzen</translation>
    </message>
    <message>
        <source>A TCP named “%1” already exists. Choose a different name.</source>
        <translation>Ein TCP mit dem Namen „%1“ ist bereits vorhanden. Wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>tiller::TcpTeacher</name>
    <message>
        <source>Record pose</source>
        <translation>Pose nehmen</translation>
    </message>
    <message>
        <source>Redo least accurate pose</source>
        <translation>Ungenaueste Pose neu nehmen</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Nehmen</translation>
    </message>
    <message>
        <source>Keep TCP</source>
        <translation>TCP behalten</translation>
    </message>
    <message>
        <source>Teach the TCP</source>
        <translation>Den TCP teachen</translation>
    </message>
    <message>
        <source>Record pose for the tool orientation</source>
        <translation>Pose für die Orientierung nehmen</translation>
    </message>
    <message>
        <source>Tool orientation</source>
        <translation>Werkzeugorientierung</translation>
    </message>
    <message>
        <source>Keep current orientation</source>
        <translation>Aktuelle Orientierung behalten</translation>
    </message>
    <message>
        <source>Orientation from one pose: tool straight down</source>
        <translation>Orientierung aus einer Pose: Werkzeug senkrecht nach unten</translation>
    </message>
    <message>
        <source>Orientation from three poses: along +Z, towards +X</source>
        <translation>Orientierung aus drei Posen: entlang +Z, Richtung +X</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Tip at %1. The poses agree within %2 (RMS); pose %3 deviates most, by %4.</source>
        <translation>Spitze bei %1. Die Posen stimmen auf %2 (RMS) überein; Pose %3 weicht mit %4 am stärksten ab.</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the poses again.</source>
        <translation>Der Roboter hat eine ungültige Position gesendet. Nehmen Sie die Posen erneut.</translation>
    </message>
    <message>
        <source>The tool keeps the current orientation.</source>
        <translation>Das Werkzeug behält die aktuelle Orientierung.</translation>
    </message>
    <message>
        <source>Rotate the tool until it points straight down and its X axis is parallel to the base X axis, then record the pose.</source>
        <translation>Drehen Sie das Werkzeug, bis es senkrecht nach unten zeigt und seine X-Achse parallel zur X-Achse der Basis ist, und nehmen Sie dann die Pose.</translation>
    </message>
    <message>
        <source>Orientation recorded. Record another pose to replace the orientation.</source>
        <translation>Orientierung genommen. Nehmen Sie sie erneut, um sie zu ersetzen.</translation>
    </message>
    <message>
        <source>Record the pose at the current position. After that, do not rotate the tool: jog along X, Y and Z only.</source>
        <translation>Nehmen Sie die Pose an der aktuellen Position. Drehen Sie das Werkzeug ab jetzt nicht: Verfahren Sie nur X, Y und Z.</translation>
    </message>
    <message>
        <source>Move the tool along its +Z direction, away from the flange, by at least %1, and record the pose.</source>
        <translation>Bewegen Sie das Werkzeug entlang seiner +Z-Richtung um mindestens %1 vom Flansch weg und nehmen Sie die Pose.</translation>
    </message>
    <message>
        <source>Now move the tool along its +X direction by at least %1, and record the pose.</source>
        <translation>Bewegen Sie das Werkzeug nun um mindestens %1 entlang seiner +X-Richtung und nehmen Sie die Pose.</translation>
    </message>
    <message>
        <source>Orientation recorded: %1 along +Z, %2 along +X; maximum flange rotation %3 at pose %4.</source>
        <translation>Orientierung genommen: %1 entlang +Z, %2 entlang +X; größte Flanschdrehung %3 bei Pose %4.</translation>
    </message>
    <message>
        <source>The flange rotated by up to %1 (pose %2). Record the three poses again without rotating the tool.</source>
        <translation>Der Flansch hat sich um bis zu %1 gedreht (Pose %2). Nehmen Sie die drei Posen erneut, ohne das Werkzeug zu drehen.</translation>
    </message>
    <message>
        <source>The distance along +Z is only %1. Record the three poses again, at least %2 apart.</source>
        <translation>Der Abstand entlang +Z beträgt nur %1. Nehmen Sie die drei Posen mindestens %2 auseinander erneut.</translation>
    </message>
    <message>
        <source>The distance along +X is only %1. Record the three poses again, at least %2 apart.</source>
        <translation>Der Abstand entlang +X beträgt nur %1. Nehmen Sie die drei Posen mindestens %2 auseinander erneut.</translation>
    </message>
    <message>
        <source>The three poses are collinear: the third pose is only %1 from the line. Record the three poses again.</source>
        <translation>Die drei Posen liegen auf einer Linie: Die dritte ist nur %1 von der Linie entfernt. Nehmen Sie die drei Posen erneut.</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the three poses again.</source>
        <translation>Der Roboter hat eine ungültige Position gesendet. Nehmen Sie die drei Posen erneut.</translation>
    </message>
    <message>
        <source>Redo last pose</source>
        <translation>Letzte Pose erneut nehmen</translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation>Pose %1 nehmen</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>Pose %1</translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation>  ◀ am ungenauesten</translation>
    </message>
    <message>
        <source>Poses can be recorded only while the robot sends data. Connect to a robot, or wait for new data.</source>
        <translation>Posen können nur genommen werden, solange der Roboter Daten sendet. Verbinden Sie sich mit einem Roboter oder warten Sie auf neue Daten.</translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool tilted by at least 30° in a different direction.</source>
        <translation>Die Werkzeugorientierungen sind zu ähnlich. Nehmen Sie eine weitere Pose, um 30° oder mehr in eine andere Richtung geneigt.</translation>
    </message>
    <message>
        <source>Jog the tip to a fixed, sharp point and record the pose. Record four poses in total, each with the tip on the same point and the tool tilted in a different direction.</source>
        <translation>Fahren Sie die Spitze an einen festen, spitzen Punkt und nehmen Sie die Pose. Nehmen Sie insgesamt vier Posen, jeweils mit der Spitze am selben Punkt und dem Werkzeug in eine andere Richtung geneigt.</translation>
    </message>
    <message numerus="yes">
        <source>Tilt the tool in a different direction, move the tip to the same point again, and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>Neigen Sie das Werkzeug in eine andere Richtung, bringen Sie die Spitze wieder an denselben Punkt und nehmen Sie die Pose. Noch benötigte Posen: %n.</numerusform>
            <numerusform>Neigen Sie das Werkzeug in eine andere Richtung, bringen Sie die Spitze wieder an denselben Punkt und nehmen Sie die Pose. Noch benötigte Posen: %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::ToolsTab</name>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Nutzlast</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positionen</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <source>TCP, payload, positions or cell</source>
        <translation>TCP, Nutzlast, Positionen oder Zelle</translation>
    </message>
</context>
<context>
    <name>tiller::TravelWatch</name>
    <message>
        <source>%1: %2 left until %3 is %4 from %5</source>
        <translation>%1: noch %2, bis %3 %4 von %5 entfernt ist</translation>
    </message>
    <message>
        <source>%1: %2 left until the %3 joint limit</source>
        <translation>%1: noch %2 bis zur Grenze von %3</translation>
    </message>
    <message>
        <source>%1: %2 left until the reach limit or a singularity</source>
        <translation>%1: noch %2 bis zur Reichweitengrenze oder einer Singularität</translation>
    </message>
</context>
<context>
    <name>tiller::VariableList</name>
    <message>
        <source>Program variables</source>
        <translation>Variablen des Programms</translation>
    </message>
    <message>
        <source>The variable list changed during editing, so the value was not applied. Enter the value again.</source>
        <translation>Die Variablenliste hat sich während der Eingabe geändert, daher wurde der Wert nicht übernommen. Geben Sie ihn erneut ein.</translation>
    </message>
</context>
<context>
    <name>tiller::VariableModel</name>
    <message>
        <source>%1 (changing…)</source>
        <translation>%1 (wird geändert …)</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
</context>
<context>
    <name>tiller::VectorEditor</name>
    <message>
        <source>%1. Press Return to apply the value. The robot does not move.</source>
        <translation>%1. Mit Enter übernehmen. Der Roboter bewegt sich nicht.</translation>
    </message>
</context>
<context>
    <name>tiller::ViewCard</name>
    <message>
        <source>Collapse</source>
        <translation>Einklappen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>The view is too small to expand this card</source>
        <translation>Die Ansicht ist zu klein, um diese Karte auszuklappen</translation>
    </message>
    <message>
        <source>Expand</source>
        <translation>Ausklappen</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointDetails</name>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>In the waypoint frame. Press Return to apply the values. Only the waypoint changes; the robot does not move.</source>
        <translation>Im Koordinatensystem des Wegpunkts. Mit Enter übernehmen. Nur der Wegpunkt ändert sich; der Roboter bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Selected waypoint</source>
        <translation>Gewählter Wegpunkt</translation>
    </message>
    <message>
        <source>Waypoint frame</source>
        <translation>System des Wegpunkts</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Koordinatensysteme</translation>
    </message>
    <message numerus="yes">
        <source>used in %n steps</source>
        <translation>
            <numerusform>in %n Schritt verwendet</numerusform>
            <numerusform>in %n Schritten verwendet</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the current pose</source>
        <translation>%1 von der jetzigen Pose</translation>
    </message>
    <message>
        <source>joints have priority</source>
        <translation>Gelenke haben Vorrang</translation>
    </message>
    <message>
        <source>pose has priority</source>
        <translation>Pose hat Vorrang</translation>
    </message>
    <message>
        <source>cell of “%1”</source>
        <translation>Platz von „%1“</translation>
    </message>
    <message>
        <source>corner of “%1”</source>
        <translation>Ecke von „%1“</translation>
    </message>
    <message>
        <source>home position “%1”</source>
        <translation>Home, „%1“</translation>
    </message>
    <message>
        <source>position “%1”</source>
        <translation>Position „%1“</translation>
    </message>
    <message>
        <source>Run route</source>
        <translation>Route</translation>
    </message>
    <message>
        <source>Shows the route controls instead of the values.</source>
        <translation>Zeigt die Bedienung der Route statt der Werte.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Shows the values instead of the route controls.</source>
        <translation>Zeigt die Werte statt der Bedienung der Route.</translation>
    </message>
    <message>
        <source>TCP “%1”</source>
        <translation>TCP „%1“</translation>
    </message>
    <message>
        <source>TCP at the flange</source>
        <translation>TCP am Flansch</translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation>TCP %1 vom Flansch</translation>
    </message>
    <message>
        <source>Reference frame of the waypoint. Changing the frame does not move the waypoint. “—” means no frame: the joint positions have priority.</source>
        <translation>Bezugs-Koordinatensystem des Wegpunkts. Die Position im Raum ändert sich nicht. „—“: kein Koordinatensystem, Gelenkpositionen haben Vorrang</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointDialogs</name>
    <message>
        <source>Select waypoints to change.</source>
        <translation>Wählen Sie Wegpunkte zum Ändern.</translation>
    </message>
    <message numerus="yes">
        <source>Change the properties of %n waypoints</source>
        <translation>
            <numerusform>Eigenschaften von %n Wegpunkt ändern</numerusform>
            <numerusform>Eigenschaften von %n Wegpunkten ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>Select waypoints to move.</source>
        <translation>Wählen Sie Wegpunkte zum Verschieben.</translation>
    </message>
    <message>
        <source>Change the pattern “%1”</source>
        <translation>Das Muster „%1“ ändern</translation>
    </message>
    <message>
        <source>Create the pattern “%1”</source>
        <translation>Muster „%1“ erstellen</translation>
    </message>
    <message>
        <source>Convert the pattern “%1” to waypoints</source>
        <translation>Muster „%1“ in Wegpunkte umwandeln</translation>
    </message>
    <message>
        <source>Select a waypoint that belongs to a pattern.</source>
        <translation>Wählen Sie einen Platz eines Musters.</translation>
    </message>
    <message>
        <source>Delete the pattern “%1”</source>
        <translation>Das Muster „%1“ löschen</translation>
    </message>
    <message>
        <source>Select a waypoint to see its history.</source>
        <translation>Wählen Sie einen Wegpunkt, um seinen Verlauf zu sehen.</translation>
    </message>
    <message>
        <source>Restore an earlier version of “%1”</source>
        <translation>Frühere Version von „%1“ wiederherstellen</translation>
    </message>
    <message>
        <source>Import waypoints</source>
        <translation>Wegpunkte importieren</translation>
    </message>
    <message>
        <source>Waypoint files (*.csv *.txt *.json *.tiller);;All files (*)</source>
        <translation>Wegpunkte (*.csv *.txt *.json *.tiller);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export waypoints</source>
        <translation>Wegpunkte exportieren</translation>
    </message>
    <message>
        <source>CSV file (*.csv);;JSON file (*.json)</source>
        <translation>CSV-Datei (*.csv);;JSON-Datei (*.json)</translation>
    </message>
    <message>
        <source>Import failed</source>
        <translation>Import fehlgeschlagen</translation>
    </message>
    <message>
        <source>%1 is too large. The maximum size of a waypoint file is 64 MB.</source>
        <translation>%1 ist zu groß. Eine Wegpunktdatei darf höchstens 64 MB groß sein.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>Wegpunkt</translation>
    </message>
    <message numerus="yes">
        <source>Import %n waypoints</source>
        <translation>
            <numerusform>%n Wegpunkt importieren</numerusform>
            <numerusform>%n Wegpunkte importieren</numerusform>
        </translation>
    </message>
    <message>
        <source>The project contains no waypoints to export. Teach a waypoint first.</source>
        <translation>Das Projekt enthält keine Wegpunkte zum Exportieren. Teachen Sie zuerst einen Wegpunkt.</translation>
    </message>
    <message>
        <source>Export failed</source>
        <translation>Export fehlgeschlagen</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints exported to %1</source>
        <translation>
            <numerusform>%n Wegpunkt nach %1 geschrieben</numerusform>
            <numerusform>%n Wegpunkte nach %1 geschrieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the waypoints to add actions to.</source>
        <translation>Wählen Sie die Wegpunkte, denen Aktionen hinzugefügt werden sollen.</translation>
    </message>
    <message numerus="yes">
        <source>Change the actions at %n waypoints</source>
        <translation>
            <numerusform>Die Aktionen an %n Wegpunkt ändern</numerusform>
            <numerusform>Die Aktionen an %n Wegpunkten ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>Teach three waypoints at the corners of the pattern first.</source>
        <translation>Teachen Sie zuerst drei Wegpunkte an den Ecken des Musters.</translation>
    </message>
    <message>
        <source>The earlier version cannot be restored because its frame was deleted from the project. Select a different version.</source>
        <translation>Die frühere Version kann nicht wiederhergestellt werden, weil ihr Koordinatensystem aus dem Projekt gelöscht wurde. Wählen Sie eine andere Version.</translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>%n Wegpunkt versetzen, drehen oder spiegeln</numerusform>
            <numerusform>%n Wegpunkte versetzen, drehen oder spiegeln</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 contains no waypoints. Choose a different file.</source>
        <translation>In %1 sind keine Wegpunkte. Wählen Sie eine andere Datei.</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointEditing</name>
    <message>
        <source>Duplicate “%1”</source>
        <translation>„%1“ duplizieren</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n waypoints</source>
        <translation>
            <numerusform>%n Wegpunkt duplizieren</numerusform>
            <numerusform>%n Wegpunkte duplizieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste failed</source>
        <translation>Einfügen fehlgeschlagen</translation>
    </message>
    <message>
        <source>The clipboard contains no waypoints. Copy waypoints first.</source>
        <translation>Die Zwischenablage enthält keine Wegpunkte. Kopieren Sie zuerst Wegpunkte.</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>Wegpunkt</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n waypoints</source>
        <translation>
            <numerusform>%n Wegpunkt einfügen</numerusform>
            <numerusform>%n Wegpunkte einfügen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::WaypointHistoryDialog</name>
    <message>
        <source>History of “%1”</source>
        <translation>Verlauf von „%1“</translation>
    </message>
    <message>
        <source>Changes, newest first</source>
        <translation>Änderungen, die neueste zuerst</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>%1  %2  (%3)</source>
        <translation>%1  %2  (%3)</translation>
    </message>
    <message>
        <source>Restore the version before this change</source>
        <translation>Version vor dieser Änderung wiederherstellen</translation>
    </message>
    <message>
        <source>Name: “%1” → “%2”</source>
        <translation>Name: „%1“ → „%2“</translation>
    </message>
    <message>
        <source>Position: moved by %1 (%2, base frame)</source>
        <translation>Position: um %1 verschoben (%2, Basis-Koordinatensystem)</translation>
    </message>
    <message>
        <source>Joints: largest change %2 (%1)</source>
        <translation>Gelenke: größte Änderung %2 (%1)</translation>
    </message>
    <message>
        <source>none (joints have priority)</source>
        <translation>keiner (Gelenke haben Vorrang)</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>a deleted frame</source>
        <translation>ein gelöschtes Koordinatensystem</translation>
    </message>
    <message>
        <source>Frame: %1 → %2</source>
        <translation>System: %1 → %2</translation>
    </message>
    <message>
        <source>Move: MoveL → MoveJ</source>
        <translation>Art: MoveL → MoveJ</translation>
    </message>
    <message>
        <source>Move: MoveJ → MoveL</source>
        <translation>Art: MoveJ → MoveL</translation>
    </message>
    <message>
        <source>MoveJ speed: %1 → %2</source>
        <translation>Geschwindigkeit von MoveJ: %1 → %2</translation>
    </message>
    <message>
        <source>MoveL speed: %1 → %2</source>
        <translation>Geschwindigkeit von MoveL: %1 → %2</translation>
    </message>
    <message>
        <source>Blend: %1 → %2</source>
        <translation>Überschleifen: %1 → %2</translation>
    </message>
    <message>
        <source>TCP: taught with a different TCP</source>
        <translation>TCP: mit einem anderen TCP geteacht</translation>
    </message>
    <message>
        <source>Group: “%1” → “%2”</source>
        <translation>Gruppe: „%1“ → „%2“</translation>
    </message>
    <message>
        <source>Colour: %1 → %2</source>
        <translation>Farbe: %1 → %2</translation>
    </message>
    <message>
        <source>Note: “%1” → “%2”</source>
        <translation>Notiz: „%1“ → „%2“</translation>
    </message>
    <message>
        <source>Actions: changed</source>
        <translation>Aktionen: geändert</translation>
    </message>
    <message>
        <source>No changes have been recorded for this waypoint.</source>
        <translation>Für diesen Wegpunkt wurden keine Änderungen aufgezeichnet.</translation>
    </message>
    <message>
        <source>The version before this change is identical to the current version.</source>
        <translation>Die Version vor dieser Änderung ist mit der aktuellen identisch.</translation>
    </message>
    <message>
        <source>Changes from the version before this change to the current version:</source>
        <translation>Änderungen von der Version vor dieser Änderung zur aktuellen Version:</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointModel</name>
    <message>
        <source>✕ joint</source>
        <translation>✕ Gelenk</translation>
    </message>
    <message>
        <source>✕ frame</source>
        <translation>✕ System</translation>
    </message>
    <message>
        <source>✕ line</source>
        <translation>✕ Linie</translation>
    </message>
    <message>
        <source>✕ reach</source>
        <translation>✕ zu weit</translation>
    </message>
    <message>
        <source>Out of reach. Touch up the waypoint closer to the base.</source>
        <translation>Außer Reichweite. Teachen Sie den Wegpunkt näher an der Basis nach.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>MoveJ: all joints start and stop together</source>
        <translation>MoveJ: Alle Gelenke beginnen und enden gemeinsam</translation>
    </message>
    <message>
        <source>MoveL: the TCP moves along a straight line</source>
        <translation>MoveL: Der TCP fährt entlang einer geraden Linie</translation>
    </message>
    <message>
        <source>Joints have priority: the arm returns to the same configuration</source>
        <translation>Gelenke haben Vorrang: Der Arm kehrt in dieselbe Stellung zurück</translation>
    </message>
    <message>
        <source>The pose has priority: the waypoint moves with its frame</source>
        <translation>Die Pose hat Vorrang: Der Wegpunkt bewegt sich mit seinem Koordinatensystem</translation>
    </message>
    <message>
        <source>Within reach</source>
        <translation>In Reichweite</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Blend %1</source>
        <translation>Blend %1</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Enter a name for the waypoint.</source>
        <translation>Geben Sie einen Namen für den Wegpunkt ein.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>„%1“ in „%2“ umbenennen</translation>
    </message>
    <message>
        <source>Change “%1” to MoveJ</source>
        <translation>„%1“ auf MoveJ ändern</translation>
    </message>
    <message>
        <source>Change “%1” to MoveL</source>
        <translation>„%1“ auf MoveL ändern</translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation>Die Pose von „%1“ ändern</translation>
    </message>
    <message>
        <source>Use joint positions for “%1”</source>
        <translation>Gelenkstellungen für „%1“ verwenden</translation>
    </message>
    <message>
        <source>Change the frame of “%1” to %2</source>
        <translation>Koordinatensystem von „%1“ auf %2 ändern</translation>
    </message>
    <message>
        <source>Set the blend of “%1”</source>
        <translation>Das Überschleifen von „%1“ setzen</translation>
    </message>
    <message>
        <source>Set the speed of “%1”</source>
        <translation>Die Geschwindigkeit von „%1“ setzen</translation>
    </message>
    <message>
        <source>Group: %1</source>
        <translation>Gruppe: %1</translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation>Farbe: %1</translation>
    </message>
    <message>
        <source>Name %1, next waypoint</source>
        <translation>Name %1, nächster Wegpunkt</translation>
    </message>
    <message>
        <source>Actions: %1</source>
        <translation>Aktionen: %1</translation>
    </message>
    <message>
        <source>Name %1</source>
        <translation>Name %1</translation>
    </message>
    <message numerus="yes">
        <source>%n actions</source>
        <translation>
            <numerusform>%n Aktion</numerusform>
            <numerusform>%n Aktionen</numerusform>
        </translation>
    </message>
    <message>
        <source>✕ model</source>
        <translation>✕ Modell</translation>
    </message>
    <message>
        <source>✕ path</source>
        <translation>✕ Bahn</translation>
    </message>
    <message>
        <source>The arm cannot reach this pose, so “%1” was not changed. Enter a different pose.</source>
        <translation>Der Arm kann diese Pose nicht erreichen. „%1“ wurde nicht geändert. Geben Sie eine andere Pose ein.</translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation>„%1“ ist keine Zahl. Geben Sie eine Zahl ein.</translation>
    </message>
    <message>
        <source>%1 is out of range. Enter a value from %2 to %3.</source>
        <translation>%1 liegt außerhalb des Bereichs. Geben Sie einen Wert von %2 bis %3 ein.</translation>
    </message>
    <message>
        <source>A joint would exceed its limit. Touch up the waypoint with a different arm configuration.</source>
        <translation>Ein Gelenk würde seinen Bereich überschreiten. Teachen Sie den Wegpunkt mit einer anderen Armstellung nach.</translation>
    </message>
    <message>
        <source>The frame of the waypoint is not in this project. Choose a different frame.</source>
        <translation>Das Koordinatensystem des Wegpunkts ist nicht in diesem Projekt. Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>The straight line from the current position leaves the reach of the arm. Use MoveJ, or start from a different position.</source>
        <translation>Die gerade Linie von der aktuellen Position verlässt die Reichweite des Arms. Verwenden Sie MoveJ oder beginnen Sie an einer anderen Position.</translation>
    </message>
    <message>
        <source>Waypoint %2 is already named “%1”. Choose a different name.</source>
        <translation>Wegpunkt %2 heißt bereits „%1“. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The project has no frame named “%1”. Choose a different frame.</source>
        <translation>Das Projekt hat kein Koordinatensystem „%1“. Wählen Sie ein anderes Koordinatensystem.</translation>
    </message>
    <message>
        <source>The project was taught with a different robot model. Use “Adapt project to this robot…” first.</source>
        <translation>Das Projekt wurde mit einem anderen Robotermodell geteacht. Verwenden Sie zuerst „Projekt an diesen Roboter anpassen…“.</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointProperties</name>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>Rosa</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Himmelblau</translation>
    </message>
    <message>
        <source>Only the selected properties are changed.</source>
        <translation>Nur die gewählten Eigenschaften werden geändert.</translation>
    </message>
    <message>
        <source>Properties of “%1”</source>
        <translation>Eigenschaften von „%1“</translation>
    </message>
    <message numerus="yes">
        <source>Properties of %n waypoints</source>
        <translation>
            <numerusform>Eigenschaften von %n Wegpunkt</numerusform>
            <numerusform>Eigenschaften von %n Wegpunkten</numerusform>
        </translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>MoveJ speed</source>
        <translation>Geschwindigkeit von MoveJ</translation>
    </message>
    <message>
        <source>MoveL speed</source>
        <translation>Geschwindigkeit von MoveL</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überschleifen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointSearch</name>
    <message>
        <source>Find waypoints</source>
        <translation>Wegpunkte suchen</translation>
    </message>
    <message>
        <source>Find waypoints by name, group or note</source>
        <translation>Wegpunkte nach Name, Gruppe oder Notiz suchen</translation>
    </message>
    <message>
        <source>Name, group or note</source>
        <translation>Name, Gruppe oder Notiz</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Show all waypoints</source>
        <translation>Alle Wegpunkte zeigen</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n gefunden</numerusform>
            <numerusform>%n gefunden</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::WaypointShift</name>
    <message>
        <source>Transformation type</source>
        <translation>Art der Transformation</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Tool of each waypoint</source>
        <translation>Werkzeug des jeweiligen Wegpunkts</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Offset X, Y, Z</source>
        <translation>Versatz X, Y, Z</translation>
    </message>
    <message>
        <source>Offset %1</source>
        <translation>Versatz %1</translation>
    </message>
    <message>
        <source>Rotation axis or mirror normal</source>
        <translation>Drehachse oder Spiegelnormale</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>The arm cannot reach these waypoints after the move: %1. Choose a different offset, rotation or mirror plane. No waypoint will be moved.</source>
        <translation>Der Arm kann diese Wegpunkte nach dem Verschieben nicht erreichen: %1. Wählen Sie einen anderen Versatz, eine andere Drehung oder Spiegelebene. Es wird kein Wegpunkt verschoben.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the moved waypoints will be out of reach. They will be kept and marked.</source>
        <translation>
            <numerusform>%n davon wäre außer Reichweite. Er wird behalten und markiert.</numerusform>
            <numerusform>%n davon wären außer Reichweite. Sie werden behalten und markiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirrors across the plane through the origin that is perpendicular to the axis. The tool approaches from the mirrored side.</source>
        <translation>Spiegelt an der Ebene durch den Ursprung senkrecht zur Achse. Das Werkzeug nähert sich von der gespiegelten Seite.</translation>
    </message>
    <message>
        <source>All waypoints remain within reach.</source>
        <translation>Alle bleiben in Reichweite.</translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>%n Wegpunkt versetzen, drehen oder spiegeln</numerusform>
            <numerusform>%n Wegpunkte versetzen, drehen oder spiegeln</numerusform>
        </translation>
    </message>
    <message>
        <source>The frame of a selected waypoint is not in the project. Choose a different frame for the waypoint first.</source>
        <translation>Das Koordinatensystem eines ausgewählten Wegpunkts ist nicht im Projekt. Wählen Sie für den Wegpunkt zuerst ein anderes Koordinatensystem.</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointTable</name>
    <message>
        <source>Waypoints</source>
        <translation>Wegpunkte</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointsTab</name>
    <message>
        <source>Waypoints</source>
        <translation>Wegpunkte</translation>
    </message>
    <message>
        <source>Teach here  T</source>
        <translation>Hier teachen  T</translation>
    </message>
    <message>
        <source>Teach here</source>
        <translation>Hier teachen</translation>
    </message>
    <message>
        <source>Touch up  U</source>
        <translation>Nachteachen  U</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Nachteachen</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>No waypoints yet.
Jog the arm to a position and press “Teach here” (T).</source>
        <translation>Noch keine Wegpunkte.
Fahren Sie den Arm an eine Position und drücken Sie „Hier teachen“ (T).</translation>
    </message>
    <message>
        <source>Select a waypoint to go to.</source>
        <translation>Wählen Sie einen Wegpunkt zum Anfahren.</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller hat nicht die Steuerung. Übernehmen Sie zuerst die Steuerung.</translation>
    </message>
    <message>
        <source>Add the current position after the selection (T)</source>
        <translation>Aktuelle Position nach der Auswahl hinzufügen (T)</translation>
    </message>
    <message>
        <source>Replace the selected waypoint with the current position (U)</source>
        <translation>Gewählten Wegpunkt durch die aktuelle Position ersetzen (U)</translation>
    </message>
    <message>
        <source>Select a waypoint to touch up.</source>
        <translation>Wählen Sie einen Wegpunkt zum Nachteachen.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Copy as table</source>
        <translation>Als Tabelle kopieren</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>Wegpunkt</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>„%1“ teachen</translation>
    </message>
    <message>
        <source>The current position is %1 away (%2, base frame). Largest joint change: %3 %4.</source>
        <translation>Die aktuelle Position ist %1 entfernt (%2, Basis-Koordinatensystem). Größte Gelenkänderung: %3 %4.</translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>„%1“ nachteachen?</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>„%1“ nachteachen</translation>
    </message>
    <message>
        <source>Path recorded</source>
        <translation>Bahn aufgezeichnet</translation>
    </message>
    <message>
        <source>Import waypoints…</source>
        <translation>Wegpunkte importieren…</translation>
    </message>
    <message>
        <source>Export waypoints…</source>
        <translation>Wegpunkte exportieren…</translation>
    </message>
    <message>
        <source>Find waypoints</source>
        <translation>Wegpunkte suchen</translation>
    </message>
    <message>
        <source>Group, colour, note, speeds…</source>
        <translation>Gruppe, Farbe, Notiz, Geschwindigkeiten…</translation>
    </message>
    <message>
        <source>Offset, rotate or mirror…</source>
        <translation>Versetzen, drehen oder spiegeln…</translation>
    </message>
    <message>
        <source>History…</source>
        <translation>Verlauf…</translation>
    </message>
    <message>
        <source>Convert pattern to waypoints</source>
        <translation>Muster in Wegpunkte umwandeln</translation>
    </message>
    <message>
        <source>Delete pattern and its waypoints</source>
        <translation>Das Muster und seine Wegpunkte löschen</translation>
    </message>
    <message>
        <source>Actions…</source>
        <translation>Aktionen…</translation>
    </message>
    <message>
        <source>Import and export</source>
        <translation>Import und Export</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Taught “%1”</source>
        <translation>„%1“ geteacht</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Create or edit pattern…</source>
        <translation>Muster erstellen oder ändern…</translation>
    </message>
    <message>
        <source>The frame of “%1” is not in this project. Choose a different frame first.</source>
        <translation>Das Koordinatensystem von „%1“ ist nicht in diesem Projekt. Wählen Sie zuerst ein anderes.</translation>
    </message>
</context>
<context>
    <name>tiller::app::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Befehle suchen</translation>
    </message>
    <message>
        <source>Type a command or keyword</source>
        <translation>Befehl oder Stichwort eingeben</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Gefundene Befehle</translation>
    </message>
    <message>
        <source>not available now</source>
        <translation>derzeit nicht verfügbar</translation>
    </message>
</context>
<context>
    <name>tiller::app::ConnectDialog</name>
    <message>
        <source>Enter the robot&apos;s address, as shown on the teach pendant under About.</source>
        <translation>Geben Sie die Adresse des Roboters ein, wie das Teach-Pendant sie unter „Über“ zeigt.</translation>
    </message>
    <message>
        <source>An IP address consists of four numbers from 0 to 255, e.g. 192.168.0.10.</source>
        <translation>Eine IP-Adresse besteht aus vier Zahlen von 0 bis 255, z. B. 192.168.0.10.</translation>
    </message>
    <message>
        <source>A host name contains only letters, digits, dots and hyphens.</source>
        <translation>Ein Hostname enthält nur Buchstaben, Ziffern, Punkte und Bindestriche.</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Start the simulated robot</source>
        <translation>Den simulierten Roboter starten</translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation>Beispielprojekt öffnen…</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Before you move a real arm: keep everyone out of its reach, keep the emergency stop within reach, check the payload and the TCP, and start slowly. STOP in this window is not an emergency stop.</source>
        <translation>Bevor Sie einen echten Arm bewegen: Halten Sie alle Personen aus seinem Arbeitsbereich fern, halten Sie den Not-Halt griffbereit, prüfen Sie Nutzlast und TCP und beginnen Sie langsam. STOP in diesem Fenster ist kein Not-Halt.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Projekt öffnen…</translation>
    </message>
    <message>
        <source>Opens a project without a robot, to view and edit waypoints and programs.</source>
        <translation>Öffnet ein Projekt ohne Roboter, um Wegpunkte und Programme anzusehen und zu bearbeiten.</translation>
    </message>
    <message>
        <source>Try the simulator</source>
        <translation>Den Simulator probieren</translation>
    </message>
    <message>
        <source>A simulated UR5e that runs in Tiller. All functions are available without risk.</source>
        <translation>Ein simulierter UR5e, der in Tiller läuft. Alle Funktionen sind gefahrlos verfügbar.</translation>
    </message>
    <message>
        <source>Starts the simulated robot and opens a project with taught waypoints.</source>
        <translation>Startet den simulierten Roboter und öffnet ein Projekt mit geteachten Wegpunkten.</translation>
    </message>
    <message>
        <source>Connect to a robot</source>
        <translation>Einen Roboter verbinden</translation>
    </message>
    <message>
        <source>Address or host name of the robot</source>
        <translation>Adresse oder Hostname des Roboters</translation>
    </message>
    <message>
        <source>Display name of the robot</source>
        <translation>Anzeigename des Roboters</translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation>Labor-UR5e</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Recently connected robots</source>
        <translation>Zuletzt verbundene Roboter</translation>
    </message>
    <message>
        <source>Removes the selected robot from this list (Delete). The robot itself is not affected.</source>
        <translation>Entfernt den gewählten Roboter aus dieser Liste (Entf). Am Roboter ändert sich nichts.</translation>
    </message>
</context>
<context>
    <name>tiller::app::Demonstration</name>
    <message>
        <source>Cannot create the folder %1. Choose a folder that you have permission to write to.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden. Wählen Sie einen Ordner, in den Sie schreiben dürfen.</translation>
    </message>
    <message>
        <source>connect</source>
        <translation>verbinden</translation>
    </message>
    <message>
        <source>power on</source>
        <translation>einschalten</translation>
    </message>
    <message>
        <source>release the brakes</source>
        <translation>die Bremsen lösen</translation>
    </message>
    <message>
        <source>take control</source>
        <translation>die Steuerung übernehmen</translation>
    </message>
    <message>
        <source>start recording</source>
        <translation>die Aufzeichnung beginnen</translation>
    </message>
    <message>
        <source>teach the first waypoint</source>
        <translation>den ersten Wegpunkt teachen</translation>
    </message>
    <message>
        <source>jog X+ in Base for 50 mm</source>
        <translation>X+ in Basis 50 mm fahren</translation>
    </message>
    <message>
        <source>teach the second waypoint</source>
        <translation>den zweiten Wegpunkt teachen</translation>
    </message>
    <message>
        <source>move to the first waypoint (button held)</source>
        <translation>den ersten Wegpunkt anfahren (gehalten)</translation>
    </message>
    <message>
        <source>digital output 0 on</source>
        <translation>Digitalausgang 0 ein</translation>
    </message>
    <message>
        <source>digital output 0 off</source>
        <translation>Digitalausgang 0 aus</translation>
    </message>
    <message>
        <source>take the screenshots</source>
        <translation>die Bildschirmfotos aufnehmen</translation>
    </message>
    <message>
        <source>Cannot write the screenshots to %1. Check the permissions of the folder and the free disk space.</source>
        <translation>Die Bildschirmfotos können nicht nach %1 geschrieben werden. Prüfen Sie die Berechtigungen des Ordners und den freien Speicherplatz.</translation>
    </message>
    <message>
        <source>stop recording</source>
        <translation>die Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>%1: not completed within %2 s (%3)</source>
        <translation>%1: nicht innerhalb von %2 s abgeschlossen (%3)</translation>
    </message>
    <message>
        <source>the robot reported no reason</source>
        <translation>der Roboter hat keinen Grund gemeldet</translation>
    </message>
    <message>
        <source>pressed again        %1 times: the motion had stopped before the button was released</source>
        <translation>erneut gedrückt      %1-mal: Die Bewegung hatte vor dem Loslassen gestoppt</translation>
    </message>
    <message>
        <source>jogged               </source>
        <translation>gefahren               </translation>
    </message>
    <message>
        <source>release to standstill </source>
        <translation>Loslassen bis Stillstand </translation>
    </message>
    <message>
        <source>packets              </source>
        <translation>Pakete              </translation>
    </message>
    <message>
        <source> received, </source>
        <translation> empfangen, </translation>
    </message>
    <message>
        <source> late, </source>
        <translation> spät, </translation>
    </message>
    <message>
        <source> lost
</source>
        <translation> verloren
</translation>
    </message>
    <message>
        <source>recorded             </source>
        <translation>aufgezeichnet             </translation>
    </message>
    <message>
        <source> rows, </source>
        <translation> Zeilen, </translation>
    </message>
    <message>
        <source>files                </source>
        <translation>Dateien                </translation>
    </message>
    <message>
        <source>the window has no button “%1”</source>
        <translation>das Fenster enthält keine Taste „%1“</translation>
    </message>
    <message>
        <source>release the jog button</source>
        <translation>die Verfahrtaste loslassen</translation>
    </message>
    <message>
        <source>release the “Go to” button</source>
        <translation>die Taste „Anfahren“ loslassen</translation>
    </message>
</context>
<context>
    <name>tiller::app::DeviceSettings</name>
    <message>
        <source>Jog device</source>
        <translation>Verfahrgerät</translation>
    </message>
    <message>
        <source>Test device…</source>
        <translation>Gerät testen…</translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation>Zeigt die aktuellen Werte jedes Geräts und die Richtung, in die sich der Arm bewegen würde.</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>SpaceMouse</source>
        <translation>SpaceMouse</translation>
    </message>
    <message>
        <source>%1 dead zone</source>
        <translation>Totzone: %1</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Deflection below which the device does not move the arm.</source>
        <translation>Auslenkung, unterhalb derer das Gerät den Arm nicht bewegt.</translation>
    </message>
    <message>
        <source>%1 curve</source>
        <translation>Kennlinie: %1</translation>
    </message>
    <message>
        <source>exponent </source>
        <translation>Exponent </translation>
    </message>
    <message>
        <source>1: linear. Higher values: finer near the centre, faster at full deflection.</source>
        <translation>1: linear. Höher: feiner nahe der Mitte, schneller bei voller Auslenkung.</translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation>Nur dominante Achse</translation>
    </message>
    <message>
        <source>%1: dominant axis only</source>
        <translation>%1: nur dominante Achse</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>Totzone</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kennlinie</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation>Kein Gamepad und keine SpaceMouse gefunden. Schließen Sie ein Gerät an; es wird automatisch erkannt.</translation>
    </message>
    <message>
        <source>The device moves the arm only while the hold-to-run button is held. The selection is not stored: after a restart, no device moves the arm.</source>
        <translation>Bewegt den Arm nur, solange die Zustimmtaste gehalten wird. Wird nicht gespeichert: Nach einem Neustart bewegt kein Gerät den Arm.</translation>
    </message>
</context>
<context>
    <name>tiller::app::DockStage</name>
    <message>
        <source>No panels are shown. Select a perspective at the lower right, or show a panel from the View menu.</source>
        <translation>Es werden keine Bereiche angezeigt. Wählen Sie unten rechts eine Arbeitsansicht oder zeigen Sie einen Bereich über das Menü Ansicht an.</translation>
    </message>
</context>
<context>
    <name>tiller::app::HelpPage</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>Übungsaufgaben</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch (englisch)</translation>
    </message>
    <message>
        <source>Jogging and keys</source>
        <translation>Verfahren und Tasten</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>&lt;h2&gt;The manual is not installed on this PC&lt;/h2&gt;&lt;p&gt;The Debian package of Tiller contains the manual. To add the manual to your own build, install the package python3-sphinx:&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;Then build again. You can also read the pages as text in the folder packaging/manual of the source code. The page “Jogging and keys” of this window contains the jogging rules and all shortcuts.&lt;/p&gt;</source>
        <translation>&lt;h2&gt;Das Handbuch ist auf diesem Rechner nicht installiert&lt;/h2&gt;&lt;p&gt;Das Debian-Paket von Tiller enthält es. Für einen eigenen Build installieren Sie das Paket python3-sphinx:&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;Bauen Sie danach noch einmal. Sie können die Seiten auch als Text im Ordner packaging/manual des Quelltexts lesen. Die Regeln des Verfahrens und alle Tasten sind auf der anderen Seite dieses Fensters.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;h2&gt;Moving the arm&lt;/h2&gt;&lt;p&gt;The arm moves while you hold a jog button, and stops when you release it. It also stops when&lt;/p&gt;&lt;ul&gt;&lt;li&gt;the pointer leaves the button, a different mouse button is pressed, or a second input device is used;&lt;/li&gt;&lt;li&gt;a modifier or an opposite key is pressed while a keyboard key is held;&lt;/li&gt;&lt;li&gt;the window loses focus, a dialog or menu opens, or the frame, speed, step or tab changes;&lt;/li&gt;&lt;li&gt;data from the robot are late, Tiller hangs, or the robot mode, the safety mode or Remote control changes;&lt;/li&gt;&lt;li&gt;the screen is locked, the PC goes to sleep, or the input device is unplugged or stops sending data;&lt;/li&gt;&lt;li&gt;the key-state check fails: on X11, Tiller checks every 10 ms with the display server that the button or key is still pressed. If the button or key is not pressed, or if the server does not respond for 100 ms, the motion ends. If the check is not available, the header and Settings show a note;&lt;/li&gt;&lt;li&gt;the maximum hold time is reached: %1 s for a jog (Settings), five minutes for Freedrive, the duration of the move plus 5 s for a move to a position. The last 3 s are counted down.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;After a stop, press the button or key again to move the arm. While Tiller is in control, &lt;b&gt;Space&lt;/b&gt; and &lt;b&gt;Esc&lt;/b&gt; stop the arm from every window, dialog and text field. When Tiller is not in control, they act on the focused element; click &lt;b&gt;STOP&lt;/b&gt; to stop a program from another client. This is a software stop, not an emergency stop: keep the emergency stop within reach.&lt;/p&gt;&lt;p&gt;Hold &lt;b&gt;Ctrl&lt;/b&gt; for one-tenth of the speed, or &lt;b&gt;Shift&lt;/b&gt; for three times the speed, up to the speed cap. On a keyboard without Latin letters, the letters below refer to key positions on a US keyboard.&lt;/p&gt;&lt;h2&gt;Commands&lt;/h2&gt;</source>
        <translation>&lt;h2&gt;Den Arm bewegen&lt;/h2&gt;&lt;p&gt;Der Arm bewegt sich, solange Sie eine Verfahrtaste halten, und stoppt, wenn Sie sie loslassen. Er stoppt auch, wenn&lt;/p&gt;&lt;ul&gt;&lt;li&gt;der Zeiger die Taste verlässt, eine andere Maustaste gedrückt oder ein zweites Eingabegerät benutzt wird;&lt;/li&gt;&lt;li&gt;eine Umschalttaste oder eine entgegengesetzte Taste gedrückt wird, während eine Taste der Tastatur gehalten wird;&lt;/li&gt;&lt;li&gt;das Fenster den Fokus verliert, ein Dialog oder Menü sich öffnet oder sich Koordinatensystem, Geschwindigkeit, Schrittweite oder Register ändern;&lt;/li&gt;&lt;li&gt;die Daten vom Roboter verspätet sind, dieses Programm nicht reagiert oder der Roboter „Läuft“, seinen Sicherheitsmodus oder die Fernsteuerung verlässt;&lt;/li&gt;&lt;li&gt;der Bildschirm gesperrt wird, der PC in den Ruhezustand wechselt oder das Eingabegerät getrennt wird oder keine Daten mehr sendet;&lt;/li&gt;&lt;li&gt;die Tastenprüfung fehlschlägt: Unter X11 prüft Tiller alle 10 ms beim Display-Server, ob die Taste noch gedrückt ist. Ist sie es nicht oder antwortet der Server 100 ms lang nicht, endet die Bewegung. Ist die Prüfung nicht verfügbar, zeigen es die Kopfzeile und die Einstellungen;&lt;/li&gt;&lt;li&gt;die maximale Haltezeit erreicht ist: %1 s beim Verfahren (Einstellungen), fünf Minuten bei Freedrive, die Dauer der Bewegung plus 5 s bei einer Bewegung zu einer Position. Die letzten 3 s werden heruntergezählt.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;Nach einem Stopp muss die Taste erneut gedrückt werden. Solange Tiller die Steuerung hat, stoppen &lt;b&gt;Leertaste&lt;/b&gt; und &lt;b&gt;Esc&lt;/b&gt; den Arm aus jedem Fenster, Dialog und Textfeld. Hat Tiller die Steuerung nicht, wirken sie auf das fokussierte Bedienelement; klicken Sie auf &lt;b&gt;STOP&lt;/b&gt;, um ein Programm eines anderen Clients zu stoppen. Das ist ein Software-Stopp, kein Not-Halt: Halten Sie den Not-Halt in Reichweite.&lt;/p&gt;&lt;p&gt;Mit &lt;b&gt;Strg&lt;/b&gt; bewegt ein Druck zehnmal feiner, mit &lt;b&gt;Umschalt&lt;/b&gt; dreimal schneller, aber nie über der Grenze. Auf einer Tastatur ohne lateinische Buchstaben bezeichnet ein Buchstabe unten seine Position auf einer US-Tastatur.&lt;/p&gt;&lt;h2&gt;Befehle&lt;/h2&gt;</translation>
    </message>
</context>
<context>
    <name>tiller::app::ImportDialog</name>
    <message>
        <source>Colours, sizes and units</source>
        <translation>Farben, Größen und Einheiten</translation>
    </message>
    <message>
        <source>Speed cap and maximum hold time</source>
        <translation>Geschwindigkeitsgrenze und maximale Haltezeit</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation>Gamepad und SpaceMouse</translation>
    </message>
    <message>
        <source>Robots and their grippers</source>
        <translation>Roboter und ihre Greifer</translation>
    </message>
    <message>
        <source>I/O names and scales</source>
        <translation>Namen und Skalen der Ein- und Ausgänge</translation>
    </message>
    <message>
        <source>Window layout</source>
        <translation>Anordnung des Fensters</translation>
    </message>
    <message>
        <source>Other settings</source>
        <translation>Weitere Einstellungen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Einstellungen importieren</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed.</source>
        <translation>%1 wurde nicht importiert. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1:</source>
        <translation>Die gewählten Einstellungen werden durch die in %1 ersetzt:</translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1 (written by Tiller %2):</source>
        <translation>Die gewählten Einstellungen werden durch die in %1 ersetzt (geschrieben von Tiller %2):</translation>
    </message>
    <message>
        <source>%1: identical</source>
        <translation>%1: identisch</translation>
    </message>
    <message>
        <source>%1: not in the file</source>
        <translation>%1: nicht in der Datei</translation>
    </message>
    <message>
        <source>%1: %2 in Tiller, %3 in the file</source>
        <translation>%1: %2 in Tiller, %3 in der Datei</translation>
    </message>
    <message>
        <source>The replaced settings are saved to a separate file, which can be imported again.</source>
        <translation>Die ersetzten Einstellungen werden in einer eigenen Datei gespeichert, die wieder importiert werden kann.</translation>
    </message>
    <message>
        <source>All settings in the file match the current settings.</source>
        <translation>Alle Einstellungen der Datei stimmen mit den aktuellen überein.</translation>
    </message>
</context>
<context>
    <name>tiller::app::MainWindow</name>
    <message>
        <source>Tiller</source>
        <translation>Tiller</translation>
    </message>
    <message>
        <source>Keyboard jogging disarmed</source>
        <translation>Tastatur abgeschaltet</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Systeme</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/A</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>%1 disconnected. The arm was stopped.</source>
        <translation>%1 getrennt. Der Arm wurde gestoppt.</translation>
    </message>
    <message>
        <source>%1 stopped sending data while it was moving the arm. The arm was stopped. Release the device; if the problem persists, reconnect it.</source>
        <translation>%1 hat während der Bewegung des Arms keine Daten mehr gesendet. Der Arm wurde gestoppt. Lassen Sie das Gerät los; wenn das Problem bleibt, schließen Sie es neu an.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Open recent project</source>
        <translation>Zuletzt geöffnete Projekte</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Projekt öffnen…</translation>
    </message>
    <message>
        <source>Opens a project file.</source>
        <translation>Öffnet eine Projektdatei.</translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation>Beispielprojekt öffnen…</translation>
    </message>
    <message>
        <source>Opens a copy of a sample project to try on the simulated robot.</source>
        <translation>Öffnet eine Kopie eines Beispielprojekts zum Ausprobieren am simulierten Roboter.</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>Projekt speichern unter…</translation>
    </message>
    <message>
        <source>Saves the project to a different file, and saves all further changes to that file automatically.</source>
        <translation>Speichert jetzt in diese Datei und danach alle weiteren Änderungen automatisch.</translation>
    </message>
    <message>
        <source>Show waypoints</source>
        <translation>Wegpunkte zeigen</translation>
    </message>
    <message>
        <source>Show frames</source>
        <translation>Koordinatensysteme zeigen</translation>
    </message>
    <message>
        <source>Show I/O</source>
        <translation>E/A zeigen</translation>
    </message>
    <message>
        <source>Show log</source>
        <translation>Protokoll zeigen</translation>
    </message>
    <message>
        <source>Shows this tab.</source>
        <translation>Zeigt dieses Register.</translation>
    </message>
    <message>
        <source>Show gripper</source>
        <translation>Greifer zeigen</translation>
    </message>
    <message>
        <source>Shows the Gripper page of the I/O tab.</source>
        <translation>Zeigt die Seite Greifer im Register E/A.</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Restores the panel layout of the current perspective.</source>
        <translation>Stellt die Anordnung der Bereiche der aktuellen Arbeitsansicht wieder her.</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Helle Farben</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Dunkle Farben</translation>
    </message>
    <message>
        <source>Changes the colour theme. The setting is stored.</source>
        <translation>Ändert das Farbschema. Die Einstellung wird gespeichert.</translation>
    </message>
    <message>
        <source>Zero the force in the plots, or show the measured force</source>
        <translation>Kraft in den Diagrammen auf null setzen, oder zeigen wie gemessen</translation>
    </message>
    <message>
        <source>Subtracts the current TCP force in the plots. Press again to show the measured force.</source>
        <translation>Zieht in den Diagrammen die aktuelle TCP-Kraft ab. Erneut drücken, um die gemessene Kraft anzuzeigen.</translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation>Befehle…</translation>
    </message>
    <message>
        <source>Finds a command by name.</source>
        <translation>Findet einen Befehl nach seinem Namen.</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Einstellungen…</translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation>Einstellungen exportieren…</translation>
    </message>
    <message>
        <source>Saves all settings to one file, for another computer or as a backup.</source>
        <translation>Speichert alle Einstellungen in eine Datei, für einen anderen Computer oder als Sicherung.</translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation>Einstellungen importieren…</translation>
    </message>
    <message>
        <source>Shows which settings a file will replace, then imports them.</source>
        <translation>Zeigt, welche Einstellungen eine Datei ersetzt, und importiert sie dann.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Stops the arm, ends the connection and closes the window.</source>
        <translation>Stoppt den Arm, beendet die Verbindung und schließt das Fenster.</translation>
    </message>
    <message>
        <source>Load program</source>
        <translation>Programm laden</translation>
    </message>
    <message>
        <source>Name of the program on the robot, as shown on the teach pendant</source>
        <translation>Name des Programms auf dem Roboter, wie am Teach-Pendant angezeigt</translation>
    </message>
    <message>
        <source>Name of the program on the robot, e.g. pick.urp</source>
        <translation>Name des Programms auf dem Roboter, z. B. pick.urp</translation>
    </message>
    <message>
        <source>Speed cap set to %1</source>
        <translation>Geschwindigkeitsgrenze auf %1 gesetzt</translation>
    </message>
    <message>
        <source>A recording is running. Stop the recording first.</source>
        <translation>Eine Aufzeichnung läuft. Beenden Sie sie zuerst.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message numerus="yes">
        <source>The cell has more boxes or planes than the simulated robot supports: %n are ignored.</source>
        <translation>
            <numerusform>%n Quader oder Ebene der Zelle übersteigt die Kapazität des simulierten Roboters und wird von ihm ignoriert.</numerusform>
            <numerusform>%n Quader oder Ebenen der Zelle übersteigen die Kapazität des simulierten Roboters und werden von ihm ignoriert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Problem melden…</translation>
    </message>
    <message>
        <source>Shows versions, log and settings, then saves them to one file for support.</source>
        <translation>Zeigt Versionen, Protokoll und Einstellungen und speichert sie dann in einer Datei für den Support.</translation>
    </message>
    <message>
        <source>Report saved: %1</source>
        <translation>Bericht gespeichert: %1</translation>
    </message>
    <message>
        <source>Tiller closed unexpectedly</source>
        <translation>Tiller wurde unerwartet beendet</translation>
    </message>
    <message>
        <source>Tiller saved a crash log. You can attach it to a problem report.</source>
        <translation>Tiller hat ein Absturzprotokoll gespeichert. Sie können es einem Problembericht beifügen.</translation>
    </message>
    <message>
        <source>Opens the manual page for the focused control, the list of commands and shortcuts, and the jogging rules.</source>
        <translation>Öffnet die Handbuchseite zum Element mit Fokus, die Liste der Befehle und Tastenkürzel und die Regeln des Verfahrens.</translation>
    </message>
    <message>
        <source>The settings could not be saved. %1</source>
        <translation>Die Einstellungen konnten nicht gespeichert werden. %1</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Rückgängig gemacht: %1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>Wiederhergestellt: %1</translation>
    </message>
    <message>
        <source>Adapt project to this robot…</source>
        <translation>Projekt an diesen Roboter anpassen…</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Steuerung übernehmen</translation>
    </message>
    <message>
        <source>A program is paused on the robot.</source>
        <translation>Auf dem Roboter ist ein Programm angehalten.</translation>
    </message>
    <message>
        <source>A program is running on the robot.</source>
        <translation>Auf dem Roboter läuft ein Programm.</translation>
    </message>
    <message>
        <source>The program “%1” is paused on the robot.</source>
        <translation>Das Programm „%1“ ist auf dem Roboter angehalten.</translation>
    </message>
    <message>
        <source>The program “%1” is running on the robot.</source>
        <translation>Das Programm „%1“ läuft auf dem Roboter.</translation>
    </message>
    <message>
        <source>Taking control stops the program. The program cannot be resumed, only restarted.</source>
        <translation>Wenn Sie die Steuerung übernehmen, wird das Programm gestoppt. Es lässt sich nicht fortsetzen, nur neu starten.</translation>
    </message>
    <message>
        <source>Stop program and take control</source>
        <translation>Programm stoppen und Steuerung übernehmen</translation>
    </message>
    <message>
        <source>Keep program</source>
        <translation>Programm beibehalten</translation>
    </message>
    <message>
        <source>Waypoints, Program, Frames, Tools, I/O, Log</source>
        <translation>Punkte, Programm, Systeme, Werkzeuge, E/A, Protokoll</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Powering off stops the program. The program cannot be resumed, only restarted.</source>
        <translation>Das Ausschalten stoppt das Programm. Es kann nicht fortgesetzt, sondern nur neu gestartet werden.</translation>
    </message>
    <message>
        <source>Stop program and power off</source>
        <translation>Programm stoppen und ausschalten</translation>
    </message>
    <message>
        <source>A path is being recorded. Stop the path recording first.</source>
        <translation>Eine Bahn wird aufgezeichnet. Beenden Sie zuerst die Aufzeichnung.</translation>
    </message>
    <message>
        <source>Close window</source>
        <translation>Fenster schließen</translation>
    </message>
    <message>
        <source>A recording is running.</source>
        <translation>Eine Aufzeichnung läuft.</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>Neues Projekt…</translation>
    </message>
    <message>
        <source>Starts an empty project in a new file.</source>
        <translation>Beginnt ein leeres Projekt in einer neuen Datei.</translation>
    </message>
    <message>
        <source>The change takes effect immediately and may disturb the program.</source>
        <translation>Die Änderung wirkt sofort und kann das Programm stören.</translation>
    </message>
    <message>
        <source>Change anyway</source>
        <translation>Trotzdem ändern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Change while a program is active</source>
        <translation>Änderung bei aktivem Programm</translation>
    </message>
    <message>
        <source>Change connection</source>
        <translation>Verbindung wechseln</translation>
    </message>
    <message>
        <source>Do not ask again during this program</source>
        <translation>Während dieses Programms nicht erneut fragen</translation>
    </message>
    <message>
        <source>A program is loaded on the robot.</source>
        <translation>Auf dem Roboter ist ein Programm geladen.</translation>
    </message>
    <message>
        <source>The program “%1” is loaded on the robot.</source>
        <translation>Das Programm „%1“ ist auf dem Roboter geladen.</translation>
    </message>
    <message>
        <source>Pausing stops the arm until the program is resumed.</source>
        <translation>Der Arm steht still, bis das Programm fortgesetzt wird.</translation>
    </message>
    <message>
        <source>The program cannot be resumed, only restarted.</source>
        <translation>Das Programm kann nicht fortgesetzt, nur neu gestartet werden.</translation>
    </message>
    <message>
        <source>The arm may move immediately. Make sure that no one is within reach of the arm.</source>
        <translation>Der Arm kann sich sofort bewegen. Stellen Sie sicher, dass niemand in Reichweite des Arms ist.</translation>
    </message>
    <message>
        <source>Resume program</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Start program</source>
        <translation>Programm starten</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Stoppen und schließen</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>Weiterlaufen lassen</translation>
    </message>
    <message>
        <source>Stop and continue</source>
        <translation>Stoppen und fortfahren</translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation>Ein Programm läuft. Halten Sie zuerst das Programm an.</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Keyboard jogging was disarmed, because an input field has the focus: the keys now edit the field. Arm the keyboard again to jog.</source>
        <translation>Die Tastatur wurde abgeschaltet, weil ein Eingabefeld den Fokus hat: Die Tasten bearbeiten jetzt das Feld. Schalten Sie die Tastatur zum Joggen wieder scharf.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>robot, address</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 — Tiller</source>
        <translation>%1 — Tiller</translation>
    </message>
    <message>
        <source>Keyboard jogging armed: arrow keys move along X and Y, PgUp and PgDn along Z; with Alt, they rotate the tool. Hold 1 to 6 and press + or − to move a joint. Space and Esc stop the arm.</source>
        <translation>Tastatur-Verfahren scharf: Pfeiltasten verfahren in X und Y, Bild auf und Bild ab in Z; mit Alt drehen sie das Werkzeug. 1 bis 6 halten und + oder − drücken verfährt ein Gelenk. Leertaste und Esc stoppen den Arm.</translation>
    </message>
    <message>
        <source>Changes the theme, sizes, units, speed cap, devices and keyboard shortcuts.</source>
        <translation>Farbschema, Größen, Einheiten, Geschwindigkeitsgrenze, Geräte und Tastenkürzel.</translation>
    </message>
    <message>
        <source>This activity stops when you close the window.</source>
        <translation>Das endet, wenn Sie das Fenster schließen.</translation>
    </message>
    <message>
        <source>This activity stops when you change the connection.</source>
        <translation>Das endet, wenn Sie die Verbindung wechseln.</translation>
    </message>
    <message>
        <source>Saves the project now. Tiller also saves all changes automatically. If another window or program has changed the file, Tiller asks whether to reload the file or keep both versions.</source>
        <translation>Speichert das Projekt sofort. Tiller speichert alle Änderungen auch automatisch. Wenn ein anderes Fenster oder Programm die Datei geändert hat, wird gefragt, ob sie neu geladen wird oder beide Fassungen behalten werden.</translation>
    </message>
    <message>
        <source>Converts a project for a different robot model, keeping either the poses or the joint positions.</source>
        <translation>Rechnet ein Projekt für ein anderes Robotermodell um und behält die Posen oder die Gelenkpositionen bei.</translation>
    </message>
    <message>
        <source>A program is running. Stop the program before you open a different project.</source>
        <translation>Ein Programm läuft. Halten Sie das Programm an, bevor Sie ein anderes Projekt öffnen.</translation>
    </message>
</context>
<context>
    <name>tiller::app::PanelDock</name>
    <message>
        <source>Dock</source>
        <translation>Andocken</translation>
    </message>
    <message>
        <source>Moves this panel back to the main window.</source>
        <translation>Verschiebt dieses Panel zurück in das Hauptfenster.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes this panel. Use the View menu to show it again.</source>
        <translation>Schließt diesen Bereich. Über das Menü Ansicht zeigen Sie ihn wieder an.</translation>
    </message>
    <message>
        <source>Move, float or close %1</source>
        <translation>%1 verschieben, lösen oder schließen</translation>
    </message>
    <message>
        <source>Click to move, float or close this panel. Drag to move it.</source>
        <translation>Klicken, um diesen Bereich zu verschieben, zu lösen oder zu schließen. Ziehen, um ihn zu verschieben.</translation>
    </message>
</context>
<context>
    <name>tiller::app::PerspectiveActions</name>
    <message>
        <source>Save perspective</source>
        <translation>Arbeitsansicht speichern</translation>
    </message>
    <message>
        <source>Saves the current panel layout to the current perspective.</source>
        <translation>Speichert die aktuelle Anordnung der Bereiche in der aktuellen Arbeitsansicht.</translation>
    </message>
    <message>
        <source>Save perspective as…</source>
        <translation>Arbeitsansicht speichern unter…</translation>
    </message>
    <message>
        <source>Saves the current panel layout under a new name.</source>
        <translation>Speichert die aktuelle Anordnung der Bereiche unter einem neuen Namen.</translation>
    </message>
    <message>
        <source>Save perspective as</source>
        <translation>Arbeitsansicht speichern unter</translation>
    </message>
    <message>
        <source>Rename perspective…</source>
        <translation>Arbeitsansicht umbenennen…</translation>
    </message>
    <message>
        <source>Renames the current perspective.</source>
        <translation>Benennt die aktuelle Arbeitsansicht um.</translation>
    </message>
    <message>
        <source>Rename perspective</source>
        <translation>Arbeitsansicht umbenennen</translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be renamed.</source>
        <translation>Diese Arbeitsansicht ist vordefiniert und kann nicht umbenannt werden.</translation>
    </message>
    <message>
        <source>Delete perspective…</source>
        <translation>Arbeitsansicht löschen…</translation>
    </message>
    <message>
        <source>Deletes the current perspective. The panel layout does not change.</source>
        <translation>Löscht die aktuelle Arbeitsansicht. Die Anordnung der Bereiche ändert sich nicht.</translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be deleted.</source>
        <translation>Diese Arbeitsansicht ist vordefiniert und kann nicht gelöscht werden.</translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation>Arbeitsansicht %1</translation>
    </message>
    <message>
        <source>Perspective %1. Select a panel layout, or save the current layout.</source>
        <translation>Arbeitsansicht %1. Wählen Sie eine Anordnung der Bereiche oder speichern Sie die aktuelle.</translation>
    </message>
    <message>
        <source>Perspective name</source>
        <translation>Name der Arbeitsansicht</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Delete perspective</source>
        <translation>Arbeitsansicht löschen</translation>
    </message>
    <message>
        <source>Delete the perspective “%1”? This cannot be undone.</source>
        <translation>Die Arbeitsansicht „%1“ löschen? Das kann nicht rückgängig gemacht werden.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>This perspective is built in. Save it under a different name.</source>
        <translation>Diese Arbeitsansicht ist vordefiniert. Speichern Sie sie unter einem anderen Namen.</translation>
    </message>
</context>
<context>
    <name>tiller::app::Perspectives</name>
    <message>
        <source>Teach</source>
        <translation>Teachen</translation>
    </message>
    <message>
        <source>Shows the view, the waypoints next to it and the plots below.</source>
        <translation>Zeigt die Ansicht, die Wegpunkte daneben und die Diagramme darunter.</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>Beobachten</translation>
    </message>
    <message>
        <source>Shows inputs and outputs, a smaller view next to them and taller plots below.</source>
        <translation>Zeigt Ein- und Ausgänge, daneben eine kleinere Ansicht und darunter höhere Diagramme.</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Shows only the plots, as large as possible.</source>
        <translation>Zeigt nur die Diagramme, so groß wie möglich.</translation>
    </message>
    <message>
        <source>Shows the panels as you saved them.</source>
        <translation>Zeigt die Bereiche, wie Sie sie gespeichert haben.</translation>
    </message>
    <message>
        <source>The perspective “%1” cannot be shown because the stored layout is damaged. Arrange the panels and save the perspective again.</source>
        <translation>Die Arbeitsansicht „%1“ kann nicht angezeigt werden: Ihre gespeicherte Anordnung ist beschädigt. Ordnen Sie die Bereiche an und speichern Sie sie erneut.</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Geben Sie einen Namen ein.</translation>
    </message>
    <message>
        <source>The maximum number of perspectives has been reached. Delete a perspective first.</source>
        <translation>Die maximale Zahl an Arbeitsansichten ist erreicht. Löschen Sie zuerst eine.</translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the layout of the earlier version is not compatible. Arrange the panels again. The new layout is saved automatically.</source>
        <translation>Die Anordnung der Bereiche wurde auf die Arbeitsansicht „%1“ zurückgesetzt: Die Anordnung der früheren Version ist nicht kompatibel. Ordnen Sie die Bereiche neu an. Die neue Anordnung wird automatisch gespeichert.</translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the stored layout is damaged or from another version. Arrange the panels again. The new layout is saved automatically.</source>
        <translation>Die Anordnung der Bereiche wurde auf die Arbeitsansicht „%1“ zurückgesetzt: Die gespeicherte Anordnung ist beschädigt oder stammt von einer anderen Version. Ordnen Sie die Bereiche neu an. Die neue Anordnung wird automatisch gespeichert.</translation>
    </message>
    <message>
        <source>The name is too long. Enter a shorter name.</source>
        <translation>Der Name ist zu lang. Geben Sie einen kürzeren Namen ein.</translation>
    </message>
    <message>
        <source>A perspective with this name already exists. Choose a different name.</source>
        <translation>Eine Arbeitsansicht mit diesem Namen ist bereits vorhanden. Wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>tiller::app::RecordingSettings</name>
    <message>
        <source>Folder for recordings</source>
        <translation>Ordner für Aufzeichnungen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder for recordings</source>
        <translation>Den Ordner für Aufzeichnungen wählen</translation>
    </message>
    <message>
        <source>File name pattern</source>
        <translation>Dateinamenmuster</translation>
    </message>
    <message>
        <source>{date}, {time}, {robot} and {number} are replaced when a recording starts.</source>
        <translation>{date}, {time}, {robot} und {number} werden beim Start einer Aufzeichnung ersetzt.</translation>
    </message>
    <message>
        <source>Packets/row</source>
        <translation>Pakete/Zeile</translation>
    </message>
    <message>
        <source>Search signals</source>
        <translation>Signale suchen</translation>
    </message>
    <message>
        <source>Signals in a recording</source>
        <translation>Signale in einer Aufzeichnung</translation>
    </message>
    <message>
        <source>All signals</source>
        <translation>Alle Signale</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>File name</source>
        <translation>Dateiname</translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation>Labor-UR5e</translation>
    </message>
    <message>
        <source>Example: %1. {date}, {time}, {robot}, {number} are placeholders. Existing files are never overwritten.</source>
        <translation>Beispiel: %1. {date}, {time}, {robot} und {number} sind Platzhalter. Vorhandene Dateien werden nie überschrieben.</translation>
    </message>
    <message numerus="yes">
        <source>%n packet(s) per row: %1 rows per second from a robot that sends 500 packets per second.</source>
        <translation>
            <numerusform>%n Paket je Zeile: %1 Zeilen je Sekunde von einem Roboter, der 500 Pakete je Sekunde sendet.</numerusform>
            <numerusform>%n Pakete je Zeile: %1 Zeilen je Sekunde von einem Roboter, der 500 Pakete je Sekunde sendet.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording format</source>
        <translation>Aufzeichnungsformat</translation>
    </message>
    <message>
        <source>Free disk space to keep, in megabytes</source>
        <translation>Freizuhaltender Speicherplatz in Megabyte</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Recording stops, and the file is saved, before the free disk space falls below this value.</source>
        <translation>Eine Aufzeichnung wird beendet und abgeschlossen, bevor der freie Speicherplatz unter diesen Wert fällt.</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Keep free</source>
        <translation>Frei halten</translation>
    </message>
    <message>
        <source>Maximum duration of a file, in minutes</source>
        <translation>Maximale Dauer einer Datei in Minuten</translation>
    </message>
    <message>
        <source>Maximum size of a file, in megabytes</source>
        <translation>Maximale Größe einer Datei in Megabyte</translation>
    </message>
    <message>
        <source>Recorded time before the trigger, in seconds</source>
        <translation>Aufgezeichnete Zeit vor dem Trigger in Sekunden</translation>
    </message>
    <message>
        <source>Recorded time after the trigger, in seconds</source>
        <translation>Aufgezeichnete Zeit nach dem Trigger in Sekunden</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Kein Limit</translation>
    </message>
    <message>
        <source>A longer recording continues in a new file without losing packets.</source>
        <translation>Eine längere Aufzeichnung wird ohne Verlust von Paketen in einer neuen Datei fortgesetzt.</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation>Metadaten der Aufzeichnungen</translation>
    </message>
    <message>
        <source>When to enter metadata</source>
        <translation>Wann Metadaten eingegeben werden</translation>
    </message>
    <message>
        <source>Use for each recording</source>
        <translation>Für jede Aufzeichnung verwenden</translation>
    </message>
    <message>
        <source>Ask before each recording</source>
        <translation>Vor jeder Aufzeichnung fragen</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>None: recording starts at once</source>
        <translation>Keiner: Aufzeichnung beginnt sofort</translation>
    </message>
    <message>
        <source>Combine conditions with “and” and “or”, for example:
norm(actual_TCP_force_0, actual_TCP_force_1) &gt; 20 and robot_mode = 7
actual_digital_input_bits:3 = 1
runtime_state changes
program starts</source>
        <translation>Verknüpfen Sie Bedingungen mit „and“ und „or“, zum Beispiel:
norm(actual_TCP_force_0, actual_TCP_force_1) &gt; 20 and robot_mode = 7
actual_digital_input_bits:3 = 1
runtime_state changes
program starts</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>New file after</source>
        <translation>Neue Datei nach</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>Metadaten</translation>
    </message>
    <message>
        <source>Before trigger</source>
        <translation>Vor dem Trigger</translation>
    </message>
    <message>
        <source>after</source>
        <translation>danach</translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation>Metadaten…</translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>Metadaten (%n Feld)…</numerusform>
            <numerusform>Metadaten (%n Felder)…</numerusform>
        </translation>
    </message>
    <message>
        <source>With a trigger, Tiller records only while the condition is true, in numbered files.</source>
        <translation>Mit einem Trigger zeichnet Tiller nur auf, solange die Bedingung erfüllt ist, in nummerierten Dateien.</translation>
    </message>
</context>
<context>
    <name>tiller::app::ReportDialog</name>
    <message>
        <source>Include names and addresses of robots, inputs, outputs and files</source>
        <translation>Mit Namen und Adressen von Robotern, Ein- und Ausgängen und Dateien</translation>
    </message>
    <message>
        <source>Report a problem</source>
        <translation>Problem melden</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>What did you do? What did you expect? What happened?</source>
        <translation>Was haben Sie getan? Was haben Sie erwartet? Was ist geschehen?</translation>
    </message>
    <message>
        <source>Report files</source>
        <translation>Dateien des Berichts</translation>
    </message>
    <message>
        <source>File content</source>
        <translation>Inhalt dieser Datei</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>Bericht speichern…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The report is one file with the information that support needs. The complete content is listed below. You choose where to save the file. Tiller does not send it.</source>
        <translation>Eine Datei mit den Informationen, die der Support benötigt. Ihr vollständiger Inhalt steht unten. Die Datei wird dort gespeichert, wo Sie wollen; Tiller sendet sie nicht.</translation>
    </message>
    <message>
        <source>Tiller report %1.zip</source>
        <translation>Tiller-Bericht %1.zip</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Zip archives (*.zip)</source>
        <translation>Zip-Archive (*.zip)</translation>
    </message>
</context>
<context>
    <name>tiller::app::SampleDialog</name>
    <message>
        <source>Open sample project</source>
        <translation>Beispielprojekt öffnen</translation>
    </message>
    <message>
        <source>Each project was taught with a UR5e and runs on the simulated robot. You work on a copy. To keep your changes, save the project to a new file.</source>
        <translation>Jedes Projekt wurde mit einem UR5e geteacht und läuft auf dem simulierten Roboter. Sie arbeiten an einer Kopie: Wählen Sie zum Speichern eine neue Datei.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open “%1”</source>
        <translation>„%1“ öffnen</translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Appearance and motion</source>
        <translation>Aussehen und Bewegung</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation>Einstellungen exportieren…</translation>
    </message>
    <message>
        <source>Save all settings to one file, for another computer or as a backup</source>
        <translation>Alle Einstellungen in eine Datei speichern, für einen anderen Computer oder als Sicherung</translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation>Einstellungen importieren…</translation>
    </message>
    <message>
        <source>Show which settings a file will replace, then import them</source>
        <translation>Zeigen, welche Einstellungen eine Datei ersetzt, und sie dann importieren</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Control size</source>
        <translation>Größe der Bedienelemente</translation>
    </message>
    <message>
        <source>Compact</source>
        <translation>Kompakt</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Touch</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Interface size</source>
        <translation>Oberflächengröße</translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation>Längeneinheit</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Orientation format</source>
        <translation>Orientierungsformat</translation>
    </message>
    <message>
        <source>Roll, pitch, yaw in degrees</source>
        <translation>Roll, Nick, Gier in Grad</translation>
    </message>
    <message>
        <source>Rotation vector in radians, as in scripts</source>
        <translation>Rotationsvektor in Radiant, wie in Skripten</translation>
    </message>
    <message>
        <source>Tiller speed cap</source>
        <translation>Geschwindigkeitsgrenze von Tiller</translation>
    </message>
    <message>
        <source>Maximum hold time</source>
        <translation>Maximale Haltezeit</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>After this time, a jog stops and its button must be pressed again. Freedrive has a limit of five minutes. A move to a position has a limit of its duration plus 5 s.</source>
        <translation>Nach dieser Zeit stoppt das Verfahren, und die Taste muss erneut gedrückt werden. Freedrive: fünf Minuten. Bewegung zu einer Position: ihre Dauer plus 5 s.</translation>
    </message>
    <message>
        <source>Touch: large enough for fingers. In windows less than %1 px high, joint buttons, tabs and title bars remain smaller.</source>
        <translation>Touch: groß genug für Finger. In Fenstern niedriger als %1 px bleiben Gelenktasten, Register und Titelleisten kleiner.</translation>
    </message>
    <message>
        <source>Units for displaying and entering lengths, TCP speeds and orientations. The units in plots and files do not change.</source>
        <translation>Einheiten für Anzeige und Eingabe von Längen, TCP-Geschwindigkeiten und Orientierungen. Die Einheiten in Diagrammen und Dateien ändern sich nicht.</translation>
    </message>
    <message>
        <source>Speed cap</source>
        <translation>Geschwindigkeitsgrenze</translation>
    </message>
    <message>
        <source>Scales text, controls, plots and the view.</source>
        <translation>Skaliert Text, Bedienelemente, Diagramme und die Ansicht.</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted, limited to %1 % on this screen.</source>
        <translation>Wird beim nächsten Start von Tiller wirksam, auf diesem Bildschirm begrenzt auf %1 %.</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted.</source>
        <translation>Wird beim nächsten Start von Tiller wirksam.</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Restore default shortcuts</source>
        <translation>Vorgegebene Tasten wiederherstellen</translation>
    </message>
    <message>
        <source>Shortcut for %1</source>
        <translation>Tastenkürzel für %1</translation>
    </message>
    <message>
        <source>%1 is reserved for stopping the arm.</source>
        <translation>%1 ist für das Stoppen des Arms reserviert.</translation>
    </message>
    <message>
        <source>%1 is assigned to “%2”. Remove that shortcut first.</source>
        <translation>%1 ist „%2“ zugewiesen. Entfernen Sie zuerst dieses Tastenkürzel.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>System language: %1</source>
        <translation>Systemsprache: %1</translation>
    </message>
    <message>
        <source>Reopen window</source>
        <translation>Fenster neu öffnen</translation>
    </message>
    <message>
        <source>Stops the arm, gives control back and reconnects. The plots restart. The project is saved.</source>
        <translation>Stoppt den Arm, gibt die Steuerung ab und verbindet sich neu. Die Diagramme beginnen neu. Das Projekt wird gespeichert.</translation>
    </message>
    <message>
        <source>Language of the window and of the connection check. Files and scripts are not affected.</source>
        <translation>Sprache des Fensters und der Verbindungsprüfung. Dateien und Skripte sind nicht betroffen.</translation>
    </message>
    <message>
        <source>Monitor only</source>
        <translation>Nur beobachten</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>For PCs that only monitor: this window does not take control, set outputs or start programs. STOP still works.</source>
        <translation>Für PCs, die nur beobachten: Dieses Fenster übernimmt keine Steuerung, setzt keine Ausgänge und startet keine Programme. STOP funktioniert weiterhin.</translation>
    </message>
    <message>
        <source>Monitor only (set on the command line)</source>
        <translation>Nur beobachten (auf der Befehlszeile gesetzt)</translation>
    </message>
    <message>
        <source>Press the new shortcut in the field, or Backspace to remove the shortcut. While Tiller is in control, Space and Esc always stop the arm.</source>
        <translation>Drücken Sie das neue Tastenkürzel im Feld; die Rücktaste entfernt es. Solange Tiller die Steuerung hat, stoppen Leertaste und Esc den Arm immer.</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted or the window is reopened. The plots then restart.</source>
        <translation>Wirkt, wenn Tiller neu gestartet oder das Fenster neu geöffnet wird. Die Diagramme beginnen dann neu.</translation>
    </message>
    <message>
        <source>Maximum speed of the TCP and elbow for all motion commanded by Tiller. A change takes effect immediately and stops any motion.</source>
        <translation>Höchstgeschwindigkeit von TCP und Ellbogen für alle von Tiller befohlenen Bewegungen. Wird sofort wirksam und stoppt laufende Bewegungen.</translation>
    </message>
    <message>
        <source>▲ Above %1. Manual mode and the enabling device of the teach pendant do not limit jogging from a PC. The header shows a warning. The cap is reset when Tiller is closed.</source>
        <translation>▲ Über %1. Der manuelle Modus und die Zustimmeinrichtung des Teach-Pendants begrenzen das Verfahren vom PC nicht. Der Kopf zeigt eine Warnung. Die Grenze wird beim Schließen von Tiller zurückgesetzt.</translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsTransfer</name>
    <message>
        <source>Tiller settings (*.json)</source>
        <translation>Einstellungen von Tiller (*.json)</translation>
    </message>
    <message>
        <source>Export settings</source>
        <translation>Einstellungen exportieren</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Einstellungen importieren</translation>
    </message>
    <message>
        <source>Settings exported to %1</source>
        <translation>Einstellungen exportiert nach %1</translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed. %2</source>
        <translation>%1 wurde nicht importiert. Nichts wurde geändert. %2</translation>
    </message>
    <message>
        <source>Settings imported from %1. The previous settings were saved to %2.</source>
        <translation>Einstellungen aus %1 importiert. Die vorherigen Einstellungen wurden in %2 gespeichert.</translation>
    </message>
</context>
<context>
    <name>tiller::app::Tutorial</name>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Shows a checklist in the view, from powering on to recording.</source>
        <translation>Zeigt in der Ansicht eine Checkliste vom Einschalten bis zur Aufzeichnung.</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>Übungsaufgaben</translation>
    </message>
    <message>
        <source>Five tasks on the simulated robot. Each task checks the result.</source>
        <translation>Fünf Aufgaben am simulierten Roboter. Jede Aufgabe prüft das Ergebnis.</translation>
    </message>
    <message>
        <source>Practice works only with the built-in simulated robot. The current robot is “%1”. Connect to the simulated robot first.</source>
        <translation>Übungen gibt es nur mit dem eingebauten simulierten Roboter. Der aktuelle Roboter ist „%1“. Verbinden Sie sich zuerst mit dem simulierten Roboter.</translation>
    </message>
    <message>
        <source>Practice: add “%1”</source>
        <translation>Übung: „%1“ hinzufügen</translation>
    </message>
</context>
</TS>
