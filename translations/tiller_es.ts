<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en">
<context>
    <name>ActionStep</name>
    <message>
        <source>No gripper is configured for this robot. Select a gripper under I/O &gt; Gripper.</source>
        <translation>No hay ninguna pinza configurada para este robot. Selecciónela en E/S &gt; Pinza.</translation>
    </message>
    <message>
        <source>Run route</source>
        <translation>Ruta</translation>
    </message>
    <message>
        <source>%1 did not turn on within %2 s. Check the connected device, then try again.</source>
        <translation>%1 no se activó en %2 s. Compruebe el dispositivo conectado e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>%1 did not turn off within %2 s. Check the connected device, then try again.</source>
        <translation>%1 no se desactivó en %2 s. Compruebe el dispositivo conectado e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>The action “%1” was not completed. %2</source>
        <translation>La acción «%1» no se completó. %2</translation>
    </message>
    <message>
        <source>The gripper did not stop moving within %1 s. Check the gripper, then try again.</source>
        <translation>La pinza no se detuvo en %1 s. Compruebe la pinza e inténtelo de nuevo.</translation>
    </message>
</context>
<context>
    <name>ActionTable</name>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Proyecto</translation>
    </message>
    <message>
        <source>Power and safety</source>
        <translation>Alimentación y seguridad</translation>
    </message>
    <message>
        <source>Control and programs</source>
        <translation>Control y programas</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Movimiento manual</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Puntos de paso</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Sistemas de coordenadas</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/S</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Perspectives</source>
        <translation>Perspectivas</translation>
    </message>
    <message>
        <source>Move panels</source>
        <translation>Mover paneles</translation>
    </message>
    <message>
        <source>Application</source>
        <translation>Aplicación</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Program steps</source>
        <translation>Pasos del programa</translation>
    </message>
</context>
<context>
    <name>ActionWords</name>
    <message>
        <source>%1 on</source>
        <translation>%1 activada</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1 desactivada</translation>
    </message>
    <message>
        <source>%1 on for %2 s</source>
        <translation>%1 activada %2 s</translation>
    </message>
    <message>
        <source>%1 off for %2 s</source>
        <translation>%1 desactivada %2 s</translation>
    </message>
    <message>
        <source>Wait until %1 is on (max. %2 s)</source>
        <translation>Esperar hasta que %1 esté activada (máx. %2 s)</translation>
    </message>
    <message>
        <source>Wait until %1 is off (max. %2 s)</source>
        <translation>Esperar hasta que %1 esté desactivada (máx. %2 s)</translation>
    </message>
    <message>
        <source>Wait until %1 is on</source>
        <translation>Esperar hasta que %1 esté activada</translation>
    </message>
    <message>
        <source>Wait until %1 is off</source>
        <translation>Esperar hasta que %1 esté desactivada</translation>
    </message>
    <message>
        <source>Wait %1 s</source>
        <translation>Esperar %1 s</translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation>Abrir la pinza</translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation>Cerrar la pinza</translation>
    </message>
    <message>
        <source>Set an output</source>
        <translation>Fijar una salida</translation>
    </message>
    <message>
        <source>Pulse an output</source>
        <translation>Dar un pulso a una salida</translation>
    </message>
    <message>
        <source>Wait for an input</source>
        <translation>Esperar una entrada</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Esperar</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Jog, teach, run and monitor a Universal Robots arm from a PC.</source>
        <translation>Mover, enseñar, ejecutar y supervisar un brazo de Universal Robots desde un PC.</translation>
    </message>
    <message>
        <source>Start with the built-in simulated UR5e.</source>
        <translation>Empezar con el UR5e simulado incorporado.</translation>
    </message>
    <message>
        <source>Connect to the robot at this address or host name.</source>
        <translation>Conectar con el robot en esta dirección o nombre de host.</translation>
    </message>
    <message>
        <source>Run the scripted demonstration on the simulated robot, write its files to this folder, and exit.</source>
        <translation>Ejecutar la demostración en el robot simulado, escribir sus archivos en esta carpeta y salir.</translation>
    </message>
    <message>
        <source>Open this project file (.tiller).</source>
        <translation>Abrir este archivo de proyecto (.tiller).</translation>
    </message>
    <message>
        <source>Colour theme: light or dark.</source>
        <translation>Tema de colores: light (claro) o dark (oscuro).</translation>
    </message>
    <message>
        <source>see tiller --help</source>
        <translation>véase tiller --help</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>argumento inesperado &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--theme must be light or dark, not &quot;%1&quot;</source>
        <translation>--theme admite light o dark, no &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--robot and --simulator cannot be combined</source>
        <translation>--robot y --simulator no se pueden combinar</translation>
    </message>
    <message>
        <source>--demo works only on the simulated robot and cannot be combined with --robot</source>
        <translation>--demo solo funciona con el robot simulado y no se puede combinar con --robot</translation>
    </message>
    <message>
        <source>--demo requires a folder</source>
        <translation>--demo necesita una carpeta</translation>
    </message>
    <message>
        <source>--robot requires an address, e.g. --robot 192.168.0.10</source>
        <translation>--robot necesita una dirección, p. ej. --robot 192.168.0.10</translation>
    </message>
    <message>
        <source>only one project can be opened; remove &quot;%1&quot;</source>
        <translation>solo se puede abrir un proyecto; quite &quot;%1&quot;</translation>
    </message>
    <message>
        <source>Monitor only: do not change anything on the robot; STOP still works. Cannot be turned off in Settings.</source>
        <translation>Solo supervisión: no cambiar nada en el robot; STOP sigue funcionando. No se puede desactivar en los ajustes.</translation>
    </message>
    <message>
        <source>--demo moves the simulated robot and cannot be combined with --monitor-only</source>
        <translation>--demo mueve el robot simulado y no se puede combinar con --monitor-only</translation>
    </message>
    <message>
        <source>Open these recordings in the plots.</source>
        <translation>Abrir estas grabaciones en los gráficos.</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>Joint positions</source>
        <translation>Posiciones de las articulaciones</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>Posición del TCP</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>Corrientes de las articulaciones</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Fuerza en el TCP</translation>
    </message>
    <message>
        <source>%1: not compared</source>
        <translation>%1: no se comparan</translation>
    </message>
    <message>
        <source>%1: no values</source>
        <translation>%1: sin valores</translation>
    </message>
    <message>
        <source>%1: within %2 at all times, maximum %3 at %4 s</source>
        <translation>%1: siempre dentro de %2, máximo %3 a los %4 s</translation>
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
        <translation>El brazo y el modelo difieren a los %1 s: %2 se desvía %3</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the TCP deviates by %2</source>
        <translation>El brazo y el modelo difieren a los %1 s: el TCP se desvía %2</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the current of %2 deviates by %3</source>
        <translation>El brazo y el modelo difieren a los %1 s: la corriente de %2 se desvía %3</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: a force of %2 acts on the TCP</source>
        <translation>El brazo y el modelo difieren a los %1 s: una fuerza de %2 actúa en el TCP</translation>
    </message>
    <message>
        <source>The motion matches the model of a %1</source>
        <translation>El movimiento coincide con el modelo de un %1</translation>
    </message>
    <message>
        <source>Nothing to compare: the arm was powered off or guided by hand for the whole recording.</source>
        <translation>Nada que comparar: el brazo estuvo apagado o guiado a mano durante toda la grabación.</translation>
    </message>
    <message>
        <source>The arm deviates from the model from the start of the recording. Check the payload and the robot model, and check whether something was touching the arm.</source>
        <translation>El brazo y el modelo difieren desde el inicio de la grabación. Compruebe la carga útil, el modelo de robot y si algo tocaba el brazo.</translation>
    </message>
    <message>
        <source>From this time on, the arm was pushed or held, its payload differed, or a joint did not follow its target.</source>
        <translation>A partir de ese momento, el brazo fue empujado o sujetado, su carga útil era otra o una articulación no siguió su consigna.</translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: its sampling interval is too long. Record every packet.</source>
        <translation>Esta grabación no se puede comparar con un modelo: su intervalo de muestreo es demasiado largo. Grabe todos los paquetes.</translation>
    </message>
    <message>
        <source>Not compared with the arm model.</source>
        <translation>No comparado con el modelo del brazo.</translation>
    </message>
    <message>
        <source>The compared values match the model of a %1; other values were not recorded</source>
        <translation>Los valores comparados coinciden con el modelo de un %1; otros valores no se han registrado</translation>
    </message>
    <message>
        <source>The recorded arm is a %1, but it was compared with the model of a %2</source>
        <translation>El brazo registrado es un %1, pero se comparó con el modelo de un %2</translation>
    </message>
    <message>
        <source>No deviation from the model of a %1, but the recorded values may fit other models too</source>
        <translation>Sin desviación respecto al modelo de un %1, pero los valores registrados también pueden corresponder a otros modelos</translation>
    </message>
    <message>
        <source>Compare the recording with the model of a %1.</source>
        <translation>Compare el registro con el modelo de un %1.</translation>
    </message>
    <message>
        <source>%1: not compared because the recording has no %2; record all signals to an MCAP file</source>
        <translation>%1: no comparado porque la grabación no contiene %2; grabe todas las señales en MCAP</translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: target or actual joint positions are missing. Record all signals to an MCAP file.</source>
        <translation>Esta grabación no se puede comparar con un modelo: faltan las posiciones articulares de consigna o reales. Grabe todas las señales en MCAP.</translation>
    </message>
    <message>
        <source>%1: exceeds %2 starting at %3 s (%4), maximum %5 at %6 s</source>
        <translation>%1: supera %2 desde %3 s (%4), máximo %5 a los %6 s</translation>
    </message>
</context>
<context>
    <name>ControllerCodes</name>
    <message>
        <source>Near a joint limit</source>
        <translation>Cerca del límite de una articulación</translation>
    </message>
    <message>
        <source>A joint came close to its limit.</source>
        <translation>Una articulación se acercó al final de su rango.</translation>
    </message>
    <message>
        <source>Jog the joint away from the limit, or change the waypoint.</source>
        <translation>Aleje la articulación del límite o cambie el punto de paso.</translation>
    </message>
    <message>
        <source>Near a tool orientation limit</source>
        <translation>Cerca del límite de orientación de la herramienta</translation>
    </message>
    <message>
        <source>The tool orientation came close to the limit set in the safety configuration.</source>
        <translation>La orientación de la herramienta se acercó al límite de la configuración de seguridad.</translation>
    </message>
    <message>
        <source>Rotate the tool away from the limit, or change the waypoint.</source>
        <translation>Gire la herramienta hacia atrás o cambie el punto de paso.</translation>
    </message>
    <message>
        <source>Near a safety plane</source>
        <translation>Cerca de un plano de seguridad</translation>
    </message>
    <message>
        <source>The arm came close to a safety plane.</source>
        <translation>El brazo se acercó a un plano de seguridad.</translation>
    </message>
    <message>
        <source>Jog away from the plane, or change the waypoint.</source>
        <translation>Aléjese del plano o cambie el punto de paso.</translation>
    </message>
    <message>
        <source>Position deviates from path</source>
        <translation>La posición se desvía de la trayectoria</translation>
    </message>
    <message>
        <source>The arm is not at the commanded position.</source>
        <translation>El brazo no está en la posición ordenada.</translation>
    </message>
    <message>
        <source>Check for obstacles; check payload, centre of gravity and mounting; reduce the acceleration.</source>
        <translation>Compruebe si hay obstáculos; compruebe la carga útil, el centro de gravedad y el montaje; reduzca la aceleración.</translation>
    </message>
    <message>
        <source>Singularity</source>
        <translation>Singularidad</translation>
    </message>
    <message>
        <source>The linear move passes through a singularity of the arm.</source>
        <translation>El movimiento lineal atraviesa una singularidad del brazo.</translation>
    </message>
    <message>
        <source>Jog individual joints away from the singularity. Use MoveJ to pass through the region.</source>
        <translation>Salga de ella moviendo articulaciones una a una; use MoveJ para pasar por esta zona.</translation>
    </message>
    <message>
        <source>Cannot hold position</source>
        <translation>No puede mantener su posición</translation>
    </message>
    <message>
        <source>The arm sagged or was pushed while at standstill.</source>
        <translation>El brazo cedió o fue empujado estando en reposo.</translation>
    </message>
    <message>
        <source>Check payload, centre of gravity and mounting.</source>
        <translation>Compruebe carga útil, centro de gravedad y montaje.</translation>
    </message>
    <message>
        <source>Wrong payload or mounting</source>
        <translation>Carga útil o montaje incorrectos</translation>
    </message>
    <message>
        <source>The measured forces do not match the payload, or the arm was pushed when Freedrive started.</source>
        <translation>Las fuerzas medidas no corresponden a la carga útil, o el brazo fue empujado al iniciar el movimiento libre.</translation>
    </message>
    <message>
        <source>Collision detected by a joint</source>
        <translation>Colisión detectada por una articulación</translation>
    </message>
    <message>
        <source>A joint required more torque than expected for the motion.</source>
        <translation>Una articulación necesitó más par del que requiere el movimiento.</translation>
    </message>
    <message>
        <source>Remove the obstacle. If the arm did not touch anything, check the payload.</source>
        <translation>Quite el obstáculo; si no lo había, compruebe la carga útil.</translation>
    </message>
    <message>
        <source>Collision detected at the tool</source>
        <translation>Colisión detectada en la herramienta</translation>
    </message>
    <message>
        <source>The force at the tool exceeded the limit.</source>
        <translation>La fuerza en la herramienta superó su límite.</translation>
    </message>
    <message>
        <source>Position deviation</source>
        <translation>Desviación de posición</translation>
    </message>
    <message>
        <source>A joint deviated from its commanded position.</source>
        <translation>Una articulación se apartó de su posición ordenada.</translation>
    </message>
    <message>
        <source>Check for obstacles, and check payload and mounting.</source>
        <translation>Compruebe si hay obstáculos, y compruebe la carga útil y el montaje.</translation>
    </message>
    <message>
        <source>Too many protective stops</source>
        <translation>Demasiadas paradas de protección</translation>
    </message>
    <message>
        <source>One joint had fifty protective stops within eight hours.</source>
        <translation>Una articulación tuvo cincuenta paradas de protección en ocho horas.</translation>
    </message>
    <message>
        <source>Find and correct the cause of the stops, then restart the controller.</source>
        <translation>Encuentre y corrija la causa de las paradas y reinicie después el controlador.</translation>
    </message>
    <message>
        <source>Sudden change in target position</source>
        <translation>Cambio brusco de la posición objetivo</translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in position.</source>
        <translation>Un programa ordenó un salto de posición.</translation>
    </message>
    <message>
        <source>Start the program at the current position of the arm, and send servo targets in small steps.</source>
        <translation>Inicie el programa en la posición actual del brazo y use pasos de servo pequeños.</translation>
    </message>
    <message>
        <source>Sudden change in target speed</source>
        <translation>Cambio brusco de la velocidad objetivo</translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in speed.</source>
        <translation>Un programa ordenó un salto de velocidad.</translation>
    </message>
    <message>
        <source>Reduce the acceleration, or smooth the path.</source>
        <translation>Reduzca la aceleración o suavice la trayectoria.</translation>
    </message>
    <message>
        <source>Protective stop requested by a program</source>
        <translation>Parada de protección solicitada por un programa</translation>
    </message>
    <message>
        <source>The running program requested the stop.</source>
        <translation>El programa en ejecución solicitó la parada.</translation>
    </message>
    <message>
        <source>See the preceding program messages in the log.</source>
        <translation>Consulte los mensajes anteriores del programa en el registro.</translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation>El robot está en control local</translation>
    </message>
    <message>
        <source>A script was sent, but the robot accepts commands only from its teach pendant.</source>
        <translation>Se envió un script, pero el robot solo acepta órdenes de su consola portátil.</translation>
    </message>
    <message>
        <source>Switch to Remote control on the teach pendant.</source>
        <translation>Cambie a control remoto en la consola portátil.</translation>
    </message>
    <message>
        <source>Controller message C%1</source>
        <translation>Mensaje C%1 del controlador</translation>
    </message>
    <message>
        <source>Tiller has no description of this message code.</source>
        <translation>Tiller no tiene ninguna descripción de este código de mensaje.</translation>
    </message>
    <message>
        <source>Look up C%1 in the manufacturer&apos;s error code directory.</source>
        <translation>Busque C%1 en el directorio de códigos de error del fabricante.</translation>
    </message>
    <message>
        <source>Correct the payload and the mounting, and do not push the arm when Freedrive starts.</source>
        <translation>Corrija la carga útil y el montaje, y no empuje el brazo al iniciar Freedrive.</translation>
    </message>
</context>
<context>
    <name>DerivedSignal</name>
    <message>
        <source>compute a signal</source>
        <translation>calcular una señal</translation>
    </message>
    <message>
        <source>The signal “%1” does not exist. See the signal list for the names.</source>
        <translation>No existe la señal «%1». Consulte los nombres en la lista de señales.</translation>
    </message>
    <message>
        <source>The expression contains no signal. Add the name of a signal.</source>
        <translation>La expresión no contiene ninguna señal. Añada el nombre de una señal.</translation>
    </message>
    <message>
        <source>The expression contains too many signals. Use fewer signals.</source>
        <translation>La expresión contiene demasiadas señales. Use menos señales.</translation>
    </message>
    <message>
        <source>The expression must evaluate to one number.</source>
        <translation>El resultado de la expresión debe ser un número.</translation>
    </message>
    <message>
        <source>The text is too long. Use a shorter name or expression.</source>
        <translation>El texto es demasiado largo. Use un nombre o una expresión más cortos.</translation>
    </message>
    <message>
        <source>Enter a name, an equals sign and an expression, for example |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</source>
        <translation>Introduzca un nombre, un signo igual y una expresión, p. ej., |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</translation>
    </message>
    <message>
        <source>Too many equals signs. Use == to compare values.</source>
        <translation>Demasiados signos igual. Para comparar, use ==</translation>
    </message>
    <message>
        <source>The functions are nested too deeply. Use at most %1 levels.</source>
        <translation>Las funciones están anidadas a demasiada profundidad. Use como máximo %1 niveles.</translation>
    </message>
    <message>
        <source>The closing parenthesis of “%1” is missing.</source>
        <translation>Falta el paréntesis de cierre de «%1».</translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression, a cut-off frequency in Hz and optionally the order (1 to 8), for example %1(actual_q_0, 10, 2).</source>
        <translation>«%1» necesita una señal o una expresión, una frecuencia de corte en Hz y, opcionalmente, el orden (de 1 a 8), por ejemplo %1(actual_q_0, 10, 2).</translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression and a time window in seconds, for example %1(actual_q_0, 0.5).</source>
        <translation>«%1» necesita una señal o una expresión y una ventana de tiempo en segundos, por ejemplo %1(actual_q_0, 0.5).</translation>
    </message>
    <message>
        <source>The cut-off frequency of “%1” must be between %2 and %3 Hz.</source>
        <translation>La frecuencia de corte de «%1» debe estar entre %2 y %3 Hz.</translation>
    </message>
    <message>
        <source>The time window of “%1” must be between 0.001 and 60 seconds.</source>
        <translation>La ventana de tiempo de «%1» debe estar entre 0,001 y 60 segundos.</translation>
    </message>
    <message>
        <source>The function “%1” does not exist.</source>
        <translation>La función «%1» no existe.</translation>
    </message>
    <message>
        <source>“%1” contains a decimal comma. Write decimal numbers with a point: %2</source>
        <translation>«%1» contiene una coma decimal. Escriba los decimales con punto: %2</translation>
    </message>
</context>
<context>
    <name>DeviceTrainer</name>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Device axes</source>
        <translation>Ejes del dispositivo</translation>
    </message>
</context>
<context>
    <name>Doctor</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>The robot&apos;s software is too old. Update the software to %1.%2 or newer.</source>
        <translation>El software del robot es demasiado antiguo. Actualícelo a %1.%2 o posterior.</translation>
    </message>
    <message>
        <source>Some values and the control registers are missing. Update the robot&apos;s software to %1.%2 or newer.</source>
        <translation>Faltan algunos valores y los registros para el control. Actualice el software del robot a %1.%2 o posterior.</translation>
    </message>
    <message>
        <source>Inspect the arm and remove the cause. Then press “Recover…” in the Tiller header, or use the teach pendant.</source>
        <translation>Inspeccione el brazo, elimine la causa y recupérelo: pulse «Recuperar…» en la cabecera o use la consola portátil.</translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes, with the button in the Tiller header or on the teach pendant.</source>
        <translation>Encienda el brazo y libere los frenos con el botón de la cabecera de Tiller o en la consola portátil.</translation>
    </message>
    <message>
        <source>the RTDE port accepts connections but does not respond</source>
        <translation>el puerto RTDE acepta conexiones pero no responde</translation>
    </message>
    <message>
        <source>the service on port %1 does not use RTDE</source>
        <translation>el servicio del puerto %1 no usa RTDE</translation>
    </message>
    <message>
        <source>Too many RTDE clients are connected, or the controller has stopped responding. Close other programs, then restart the controller.</source>
        <translation>Demasiados clientes RTDE, o el controlador no responde: cierre otros programas y reinicie el controlador.</translation>
    </message>
    <message>
        <source>Check the address. The address may belong to another device, or another program may be using the port.</source>
        <translation>Compruebe la dirección: es otro dispositivo, u otro programa usa el puerto.</translation>
    </message>
    <message>
        <source>protocol version %1</source>
        <translation>versión de protocolo %1</translation>
    </message>
    <message>
        <source>another program uses %1</source>
        <translation>otro programa usa %1</translation>
    </message>
    <message>
        <source>Close the other program that controls this robot (another Tiller window, ROS, ur_rtde).</source>
        <translation>Cierre el otro programa que controla este robot (otra ventana, ROS, ur_rtde).</translation>
    </message>
    <message>
        <source>this software version has no registers 24 to 47</source>
        <translation>esta versión de software no tiene registros 24 a 47</translation>
    </message>
    <message>
        <source>Update the robot&apos;s software to 3.9, 5.3 or newer.</source>
        <translation>Actualice el software del robot a 3.9, 5.3 o posterior.</translation>
    </message>
    <message>
        <source>registers 24 to 47 are free</source>
        <translation>los registros 24 a 47 están libres</translation>
    </message>
    <message>
        <source>a fieldbus adapter or another program uses %1</source>
        <translation>un adaptador de bus de campo u otro programa usa %1</translation>
    </message>
    <message>
        <source>No action needed for jogging. To use these registers, disable EtherNet/IP, PROFINET or MODBUS in the robot&apos;s installation.</source>
        <translation>No hay que hacer nada para mover el brazo. Para usar estos registros, desactive EtherNet/IP, PROFINET o MODBUS en la instalación del robot.</translation>
    </message>
    <message>
        <source>registers 0 to 23 are free</source>
        <translation>los registros 0 a 23 están libres</translation>
    </message>
    <message>
        <source>the robot accepts the subscription but sends no data</source>
        <translation>el robot acepta la suscripción pero no envía datos</translation>
    </message>
    <message>
        <source>Close other RTDE programs, then restart the robot&apos;s controller.</source>
        <translation>Cierre otros programas RTDE y reinicie el controlador del robot.</translation>
    </message>
    <message>
        <source>%1 of %2 packets per second</source>
        <translation>%1 de %2 paquetes por segundo</translation>
    </message>
    <message>
        <source>Packets are missing. Use a cable instead of a wireless link, and close other programs that put load on the robot or this PC.</source>
        <translation>Faltan paquetes. Use un cable en lugar de un enlace por radio y cierre otros programas que cargan el robot o este PC.</translation>
    </message>
    <message>
        <source>priority %1</source>
        <translation>prioridad %1</translation>
    </message>
    <message>
        <source>the system does not grant this user real-time priority</source>
        <translation>el sistema no concede a este usuario prioridad de tiempo real</translation>
    </message>
    <message>
        <source>CPUs may enter deep sleep states, which delay real-time loops</source>
        <translation>las CPU pueden entrar en reposo profundo, lo que retrasa los bucles de tiempo real</translation>
    </message>
    <message>
        <source>TCP %1 mm from the flange, payload %2 kg</source>
        <translation>TCP a %1 mm de la brida, carga útil %2 kg</translation>
    </message>
    <message>
        <source>If a tool is mounted, set the TCP and the payload in the robot&apos;s installation: a wrong payload causes protective stops and makes the arm drift in Freedrive.</source>
        <translation>Si hay una herramienta montada, ajuste el TCP y la carga útil en la instalación del robot: una carga útil incorrecta causa paradas de protección y hace que el brazo se desplace solo en movimiento libre.</translation>
    </message>
    <message>
        <source>“%1” is not a valid address, and no host with this name was found</source>
        <translation>&quot;%1&quot; no es una dirección válida y no se encontró ningún host con ese nombre</translation>
    </message>
    <message>
        <source>Enter the IP address shown on the teach pendant under About, or ask your network administrator for the host name.</source>
        <translation>Introduzca la dirección IP que muestra la consola portátil en «Acerca de», o pida el nombre de host al administrador de la red.</translation>
    </message>
    <message>
        <source>%1 does not respond</source>
        <translation>%1 no responde</translation>
    </message>
    <message>
        <source>no network route to %1</source>
        <translation>no hay ruta de red hasta %1</translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and no firewall blocks the connection.</source>
        <translation>Compruebe que el robot está encendido, que el cable está conectado y que ningún cortafuegos bloquea la conexión.</translation>
    </message>
    <message>
        <source>Assign this PC an address in the robot&apos;s network (the same first three numbers), and check the cable.</source>
        <translation>Dé a este PC una dirección en la red del robot (los mismos tres primeros números) y compruebe el cable.</translation>
    </message>
    <message>
        <source>%1 responds, but provides no robot services</source>
        <translation>%1 responde, pero no ofrece servicios de robot</translation>
    </message>
    <message>
        <source>Check that this is the address of the robot. A robot that has just been switched on may need another minute.</source>
        <translation>Compruebe que es la dirección del robot. Un robot recién encendido puede necesitar un minuto más.</translation>
    </message>
    <message>
        <source>%1 responds</source>
        <translation>%1 responde</translation>
    </message>
    <message>
        <source>dashboard, port %1</source>
        <translation>dashboard, puerto %1</translation>
    </message>
    <message>
        <source>port %1</source>
        <translation>puerto %1</translation>
    </message>
    <message>
        <source>port %1 is closed</source>
        <translation>el puerto %1 está cerrado</translation>
    </message>
    <message>
        <source>port %1 does not respond</source>
        <translation>el puerto %1 no responde</translation>
    </message>
    <message>
        <source>Enable this interface on the robot under Settings &gt; Security &gt; Services.</source>
        <translation>Active esta interfaz en el robot en Ajustes &gt; Seguridad &gt; Servicios.</translation>
    </message>
    <message>
        <source>A firewall may be blocking this port. Allow TCP port %1 to the robot.</source>
        <translation>Puede que un cortafuegos bloquee este puerto. Permita el puerto TCP %1 hacia el robot.</translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant. Until then, Tiller can only monitor.</source>
        <translation>Cambie el robot a Control remoto arriba a la derecha en la consola portátil. Hasta entonces, Tiller solo puede observar.</translation>
    </message>
    <message>
        <source>the dashboard accepts connections but does not respond</source>
        <translation>el dashboard acepta conexiones pero no responde</translation>
    </message>
    <message>
        <source>the service on port %1 is not a dashboard server</source>
        <translation>el servicio del puerto %1 no es un servidor Dashboard</translation>
    </message>
    <message>
        <source>Restart the robot&apos;s controller. If the problem persists, see the controller log.</source>
        <translation>Reinicie el controlador del robot; si el problema continúa, consulte su registro.</translation>
    </message>
    <message>
        <source>Check the address, and check that no other program is using this port.</source>
        <translation>Compruebe la dirección y que ningún otro programa usa este puerto.</translation>
    </message>
    <message>
        <source>this series has no Local/Remote switch</source>
        <translation>esta serie no tiene conmutador Local/Remoto</translation>
    </message>
    <message>
        <source>Remote</source>
        <translation>Remoto</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>Local</translation>
    </message>
    <message>
        <source>neither the dashboard (port %1) nor the Robot API (port %2) is available</source>
        <translation>ni el Dashboard (puerto %1) ni la Robot API (puerto %2) están disponibles</translation>
    </message>
    <message>
        <source>the primary interface sends no data about the arm</source>
        <translation>la interfaz primaria no envía datos del brazo</translation>
    </message>
    <message>
        <source>Check that this is the address of the robot, and restart its controller.</source>
        <translation>Compruebe que es la dirección del robot y reinicie su controlador.</translation>
    </message>
    <message>
        <source>robot type %1 is not known to this version of Tiller</source>
        <translation>esta versión de Tiller no conoce el tipo de robot %1</translation>
    </message>
    <message>
        <source>Monitoring works. Limits and previews use the dimensions that the robot reports; jog slowly at first.</source>
        <translation>La observación funciona. Los límites y las vistas previas usan las dimensiones que comunica el robot; al principio mueva despacio.</translation>
    </message>
    <message>
        <source>Address resolves</source>
        <translation>La dirección se resuelve</translation>
    </message>
    <message>
        <source>Host responds</source>
        <translation>El host responde</translation>
    </message>
    <message>
        <source>RTDE port</source>
        <translation>Puerto RTDE</translation>
    </message>
    <message>
        <source>Primary port</source>
        <translation>Puerto primario</translation>
    </message>
    <message>
        <source>Secondary port</source>
        <translation>Puerto secundario</translation>
    </message>
    <message>
        <source>Real-time port</source>
        <translation>Puerto de tiempo real</translation>
    </message>
    <message>
        <source>Dashboard or Robot API</source>
        <translation>Dashboard o Robot API</translation>
    </message>
    <message>
        <source>RTDE protocol</source>
        <translation>Protocolo RTDE</translation>
    </message>
    <message>
        <source>Controller software</source>
        <translation>Software del controlador</translation>
    </message>
    <message>
        <source>Robot model</source>
        <translation>Modelo de robot</translation>
    </message>
    <message>
        <source>Remote control</source>
        <translation>Control remoto</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Seguridad</translation>
    </message>
    <message>
        <source>Power and brakes</source>
        <translation>Alimentación y frenos</translation>
    </message>
    <message>
        <source>Control registers free</source>
        <translation>Registros para el control libres</translation>
    </message>
    <message>
        <source>Data rate</source>
        <translation>Frecuencia de datos</translation>
    </message>
    <message>
        <source>Real-time priority on this PC</source>
        <translation>Prioridad de tiempo real en este PC</translation>
    </message>
    <message>
        <source>TCP and payload</source>
        <translation>TCP y carga útil</translation>
    </message>
    <message>
        <source>real-time loops can keep the CPUs out of deep sleep states</source>
        <translation>los bucles de tiempo real pueden evitar el reposo profundo de las CPU</translation>
    </message>
    <message>
        <source>Enable the dashboard server on the robot under Settings &gt; Security &gt; Services. On PolyScope X, the Robot API requires version 10.11 or newer.</source>
        <translation>Active el servidor Dashboard en el robot en Ajustes &gt; Seguridad &gt; Servicios. PolyScope X necesita la versión 10.11 o posterior para la Robot API.</translation>
    </message>
    <message>
        <source>Robot API %1, port %2; popups can be closed only on the teach pendant</source>
        <translation>Robot API %1, puerto %2; las ventanas emergentes solo se pueden cerrar en la consola portátil</translation>
    </message>
    <message>
        <source>Fieldbus registers free</source>
        <translation>Registros de bus de campo libres</translation>
    </message>
    <message>
        <source>Wake-up latency on this PC</source>
        <translation>Latencia de activación en este PC</translation>
    </message>
</context>
<context>
    <name>Freedrive</name>
    <message>
        <source>All axes</source>
        <translation>Todos los ejes</translation>
    </message>
    <message>
        <source>Position only</source>
        <translation>Solo posición</translation>
    </message>
    <message>
        <source>Orientation only</source>
        <translation>Solo orientación</translation>
    </message>
    <message>
        <source>XY plane</source>
        <translation>Plano XY</translation>
    </message>
    <message>
        <source>Z only</source>
        <translation>Solo Z</translation>
    </message>
    <message>
        <source>Wait for standstill before you start Freedrive.</source>
        <translation>Espere al reposo antes de iniciar el movimiento libre.</translation>
    </message>
    <message>
        <source>The arm would drift: the robot measures %1 with a payload of %2 kg. Do not touch the tool, or correct the payload and the TCP.</source>
        <translation>El brazo se desplazaría solo: mide %1 con una carga útil de %2 kg. Suelte la herramienta o corrija la carga útil y el TCP.</translation>
    </message>
</context>
<context>
    <name>Gamepad</name>
    <message>
        <source>left bumper</source>
        <translation>botón superior izquierdo</translation>
    </message>
    <message>
        <source>Left stick: X and Y. Right stick: Z and rotation. Hold the right bumper to rotate with both sticks.</source>
        <translation>Palanca izquierda: X e Y. Palanca derecha: Z y giro. Mantenga el botón superior derecho para girar con ambas palancas.</translation>
    </message>
</context>
<context>
    <name>InterfaceSize</name>
    <message>
        <source>This screen has a high resolution. Increase “Interface size” in Settings to enlarge text, controls and plots.</source>
        <translation>Esta pantalla tiene alta resolución. Aumente «Tamaño de la interfaz» en Ajustes para agrandar texto, controles y gráficos.</translation>
    </message>
</context>
<context>
    <name>JogActions</name>
    <message>
        <source>Jog speed %1</source>
        <translation>Velocidad manual %1</translation>
    </message>
    <message>
        <source>Jog step %1, %2°</source>
        <translation>Paso manual %1, %2°</translation>
    </message>
    <message>
        <source>Arm or disarm keyboard jogging</source>
        <translation>Armar o desarmar el movimiento con teclado</translation>
    </message>
    <message>
        <source>While the keyboard is armed, the arrow keys move the arm and a border surrounds the window. The keyboard is disarmed after 30 s without use.</source>
        <translation>Con el teclado armado, las flechas mueven el brazo y un marco rodea la ventana. Se desarma tras 30 s sin uso.</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse…</source>
        <translation>Gamepad y SpaceMouse…</translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation>Muestra los valores actuales de cada dispositivo y la dirección en que se movería el brazo.</translation>
    </message>
    <message>
        <source>Zero here</source>
        <translation>Cero aquí</translation>
    </message>
    <message>
        <source>Shows the TCP displacement from the current position. Press again to show the displacement since the start of the last motion.</source>
        <translation>Muestra el desplazamiento del TCP desde esta posición. Pulse de nuevo para mostrarlo desde el inicio del último movimiento.</translation>
    </message>
    <message>
        <source>Stops the arm. The next press uses this speed.</source>
        <translation>Detiene el brazo. La siguiente pulsación usa esta velocidad.</translation>
    </message>
    <message>
        <source>Moves the arm by this distance while the button is held.</source>
        <translation>Mueve el brazo esta distancia mientras se mantiene el botón.</translation>
    </message>
    <message>
        <source>Each press moves the arm by this distance.</source>
        <translation>Cada pulsación mueve el brazo esta distancia.</translation>
    </message>
    <message>
        <source>Jog until contact (%1 N)</source>
        <translation>Mover hasta contacto (%1 N)</translation>
    </message>
    <message>
        <source>Moves slowly while the button is held and stops when the contact force reaches this value.</source>
        <translation>Mueve despacio mientras se mantiene el botón y se detiene cuando la fuerza de contacto alcanza este valor.</translation>
    </message>
    <message>
        <source>Other jog speed…</source>
        <translation>Otra velocidad manual…</translation>
    </message>
    <message>
        <source>Sets the TCP speed. Rotation and joint speeds change in proportion.</source>
        <translation>Define la velocidad del TCP. Las velocidades de giro y de las articulaciones cambian en proporción.</translation>
    </message>
    <message>
        <source>Other jog step…</source>
        <translation>Otro paso manual…</translation>
    </message>
    <message>
        <source>Sets the step length. The step angle does not change.</source>
        <translation>Define la longitud del paso. El ángulo del paso no cambia.</translation>
    </message>
    <message>
        <source>Other jog angle…</source>
        <translation>Otro giro manual…</translation>
    </message>
    <message>
        <source>Sets the step angle of tool and joint rotations. The step length does not change.</source>
        <translation>Define el ángulo del paso para giros de la herramienta y de las articulaciones. La longitud no cambia.</translation>
    </message>
    <message>
        <source>Other contact force for jogging…</source>
        <translation>Otra fuerza de contacto manual…</translation>
    </message>
    <message>
        <source>Sets the contact force in N that ends the motion.</source>
        <translation>Define la fuerza de contacto en N que termina el movimiento.</translation>
    </message>
    <message>
        <source>Freedrive: %1</source>
        <translation>Movimiento libre: %1</translation>
    </message>
    <message>
        <source>Selects the axes that can be moved by hand during Freedrive.</source>
        <translation>Selecciona los ejes que se pueden mover a mano en el movimiento libre.</translation>
    </message>
</context>
<context>
    <name>JogColumn</name>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
</context>
<context>
    <name>JointNames</name>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Hombro</translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation>Codo</translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation>Muñeca 1</translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation>Muñeca 2</translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation>Muñeca 3</translation>
    </message>
</context>
<context>
    <name>KeyStateProbe</name>
    <message>
        <source>Key-state check unavailable on this platform (%1): Tiller relies on window events to detect key releases.</source>
        <translation>Comprobación de teclas no disponible en esta plataforma (%1): Tiller detecta que se sueltan las teclas mediante eventos de la ventana.</translation>
    </message>
    <message>
        <source>Key-state check active: Tiller checks with the display server every 10 ms whether the button or key is still pressed.</source>
        <translation>Comprobación de teclas activa: Tiller comprueba cada 10 ms en el servidor gráfico si el botón o la tecla sigue pulsado.</translation>
    </message>
    <message>
        <source>Key-state check unavailable: Tiller could not open a second connection to the display server. Tiller relies on window events to detect key releases.</source>
        <translation>Comprobación de teclas no disponible: no hay segunda conexión con el servidor gráfico. Tiller detecta que se sueltan las teclas mediante eventos de la ventana.</translation>
    </message>
</context>
<context>
    <name>LimiterAdvice</name>
    <message>
        <source>Elbow almost straight</source>
        <translation>Codo casi recto</translation>
    </message>
    <message>
        <source>Elbow almost straight: %1 speed</source>
        <translation>Codo casi recto: %1 de la velocidad</translation>
    </message>
    <message>
        <source>bend the elbow</source>
        <translation>doble el codo</translation>
    </message>
    <message>
        <source>jog %1 or bend the elbow</source>
        <translation>mueva %1 o doble el codo</translation>
    </message>
    <message>
        <source>Wrist near the base axis</source>
        <translation>Muñeca cerca del eje de la base</translation>
    </message>
    <message>
        <source>Wrist near the base axis: %1 speed</source>
        <translation>Muñeca cerca del eje de la base: %1 de la velocidad</translation>
    </message>
    <message>
        <source>move outwards</source>
        <translation>mueva hacia fuera</translation>
    </message>
    <message>
        <source>jog %1 or rotate the base</source>
        <translation>mueva %1 o gire la base</translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°</source>
        <translation>Muñeca 2 cerca de 0° o 180°</translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°: %1 speed</source>
        <translation>Muñeca 2 cerca de 0° o 180°: %1 de la velocidad</translation>
    </message>
    <message>
        <source>rotate wrist 2</source>
        <translation>gire la muñeca 2</translation>
    </message>
    <message>
        <source>jog %1 or rotate wrist 2</source>
        <translation>mueva %1 o gire la muñeca 2</translation>
    </message>
    <message>
        <source>%1 %2° from its limit</source>
        <translation>%1 a %2° de su límite</translation>
    </message>
    <message>
        <source>rotate %1 %2</source>
        <translation>gire %1 %2</translation>
    </message>
    <message>
        <source>jog %1 or rotate %2 %3</source>
        <translation>mueva %1 o gire %2 %3</translation>
    </message>
    <message>
        <source>TCP at the speed cap: %1 speed</source>
        <translation>TCP en el límite de velocidad: %1 de la velocidad</translation>
    </message>
    <message>
        <source>change the cap in Settings</source>
        <translation>cambie el límite en Ajustes</translation>
    </message>
    <message>
        <source>Elbow at the speed cap: %1 speed</source>
        <translation>Codo en el límite de velocidad: %1 de la velocidad</translation>
    </message>
    <message>
        <source>Rotation at the speed cap: %1 speed</source>
        <translation>Giro en el límite de velocidad: %1 de la velocidad</translation>
    </message>
    <message>
        <source>%1 at its maximum speed: %2 speed</source>
        <translation>%1 a su velocidad máxima: %2 de la velocidad</translation>
    </message>
    <message>
        <source>choose a lower speed</source>
        <translation>elija una velocidad menor</translation>
    </message>
    <message>
        <source>move away</source>
        <translation>alejarse</translation>
    </message>
    <message>
        <source>jog %1</source>
        <translation>mover %1</translation>
    </message>
    <message>
        <source>%1 is %2 from %3: %4 speed</source>
        <translation>%1 está a %2 de %3: %4 de la velocidad</translation>
    </message>
    <message>
        <source>%1 is %2 from %3</source>
        <translation>%1 está a %2 de %3</translation>
    </message>
</context>
<context>
    <name>LocalSimulator</name>
    <message>
        <source>Simulated UR5e</source>
        <translation>UR5e simulado</translation>
    </message>
</context>
<context>
    <name>ModeLook</name>
    <message>
        <source>FREEDRIVE</source>
        <translation>MOVIMIENTO LIBRE</translation>
    </message>
    <message>
        <source>The arm can be moved by hand.</source>
        <translation>El brazo se puede mover a mano.</translation>
    </message>
    <message>
        <source>MOVING</source>
        <translation>EN MOVIMIENTO</translation>
    </message>
    <message>
        <source>The robot reports that the arm is moving.</source>
        <translation>El robot indica que el brazo se mueve.</translation>
    </message>
    <message>
        <source>Remote</source>
        <translation>Remoto</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>Local</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>SIN DATOS</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Tomando el control…</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>Movimiento libre</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>In control</source>
        <translation>Con control</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Rechazado</translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation>Sin control</translation>
    </message>
    <message>
        <source>Commands take longer than 20 ms: the arm responds with a delay. Jog slowly.</source>
        <translation>Las órdenes tardan más de 20 ms: el brazo responde con retraso. Mueva despacio.</translation>
    </message>
    <message>
        <source>Good: the arm responds immediately and stops within 250 ms if the link fails.</source>
        <translation>Bien: el brazo responde al instante y se detiene en 250 ms si falla el enlace.</translation>
    </message>
    <message>
        <source>Last 10 s: %1 packets, %2 late, %3 lost</source>
        <translation>Últimos 10 s: %1 paquetes, %2 tarde, %3 perdidos</translation>
    </message>
    <message>
        <source>Since connecting: %1 packets, %2 late, %3 lost</source>
        <translation>Desde la conexión: %1 paquetes, %2 tarde, %3 perdidos</translation>
    </message>
    <message>
        <source>A packet counts as late when it arrives more than half a period after its expected time.</source>
        <translation>Un paquete se considera tardío si llega más de medio período después de lo esperado.</translation>
    </message>
    <message>
        <source>No robot connected</source>
        <translation>Ningún robot conectado</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Conectando…</translation>
    </message>
    <message>
        <source>Late: %1 s</source>
        <translation>Tarde: %1 s</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source> · %1 late</source>
        <translation> · %1 tarde</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · %1 perdidos</translation>
    </message>
    <message>
        <source>LINK · JOG STOPS</source>
        <translation>ENLACE · SE DETIENE</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>ENLACE</translation>
    </message>
    <message>
        <source>LINK · JOG MAY STOP</source>
        <translation>ENLACE · PUEDE PARAR</translation>
    </message>
    <message>
        <source>LINK · ARM LAGS</source>
        <translation>ENLACE · CON RETRASO</translation>
    </message>
    <message>
        <source>LINK · GOOD</source>
        <translation>ENLACE · BUENO</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Conectar…</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Encender</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>Liberar frenos</translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation>Recuperar…</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Tomar el control</translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation>Enciende el brazo. Los frenos siguen puestos.</translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation>El brazo puede ceder unos milímetros. Manténgase apartado.</translation>
    </message>
    <message>
        <source>Shows the cause of the stop, the five seconds before it, and the recovery steps. The arm does not move.</source>
        <translation>Muestra la causa de la parada, los cinco segundos anteriores y los pasos de recuperación. El brazo no se mueve.</translation>
    </message>
    <message>
        <source>Data late</source>
        <translation>Datos con retraso</translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation>Inicia el programa de control en el robot. Pregunta antes de detener otro programa.</translation>
    </message>
    <message>
        <source>Monitoring</source>
        <translation>Observando</translation>
    </message>
    <message>
        <source>Select the simulator or enter the address of a robot.</source>
        <translation>Seleccione el simulador o introduzca la dirección de un robot.</translation>
    </message>
    <message>
        <source>Packets are late or lost: jogging may stop and plots may have gaps. Use a cable instead of a wireless link, and close other programs.</source>
        <translation>Los paquetes llegan tarde o se pierden: el movimiento puede detenerse y los gráficos tienen huecos. Use un cable en vez de un enlace inalámbrico y cierre otros programas.</translation>
    </message>
</context>
<context>
    <name>ModeWords</name>
    <message>
        <source>No controller</source>
        <translation>Sin controlador</translation>
    </message>
    <message>
        <source>The robot&apos;s controller is not running. Restart the control box.</source>
        <translation>El controlador del robot no está en marcha. Reinicie la caja de control.</translation>
    </message>
    <message>
        <source>Arm disconnected</source>
        <translation>Brazo sin conexión</translation>
    </message>
    <message>
        <source>The controller has no connection to the arm. See the teach pendant for the cause.</source>
        <translation>El controlador no tiene conexión con el brazo. Mire la consola portátil.</translation>
    </message>
    <message>
        <source>Confirm safety</source>
        <translation>Confirmar seguridad</translation>
    </message>
    <message>
        <source>Confirm the safety configuration on the teach pendant.</source>
        <translation>Confirme la configuración de seguridad en la consola portátil.</translation>
    </message>
    <message>
        <source>Booting</source>
        <translation>Arrancando</translation>
    </message>
    <message>
        <source>The arm is starting. Wait a few seconds.</source>
        <translation>El brazo está arrancando. Espere unos segundos.</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>Apagado</translation>
    </message>
    <message>
        <source>The arm is powered off. Power on the arm.</source>
        <translation>El brazo está apagado. Enciéndalo.</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Encendido</translation>
    </message>
    <message>
        <source>The arm is powered on and initializing. Wait a moment.</source>
        <translation>El brazo está encendido y se está inicializando. Espere un momento.</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>En reposo</translation>
    </message>
    <message>
        <source>The brakes are engaged. Release the brakes.</source>
        <translation>Los frenos están puestos. Libérelos.</translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation>Backdrive</translation>
    </message>
    <message>
        <source>The arm is being moved by hand with its brakes released. Release the Freedrive button.</source>
        <translation>El brazo se mueve a mano con los frenos liberados. Suelte el botón de movimiento libre.</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marcha</translation>
    </message>
    <message>
        <source>Updating firmware</source>
        <translation>Actualizando firmware</translation>
    </message>
    <message>
        <source>The joints&apos; firmware is being updated. Do not switch off the power until the update is complete.</source>
        <translation>Se actualiza el firmware de las articulaciones. No apague la alimentación hasta que termine la actualización.</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>No safety stop is active.</source>
        <translation>Ninguna parada de seguridad está activa.</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reducido</translation>
    </message>
    <message>
        <source>The reduced safety limits are active.</source>
        <translation>Los límites de seguridad reducidos están activos.</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>Parada de protección</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Recuperación</translation>
    </message>
    <message>
        <source>The arm is outside a safety limit. Use the teach pendant to move the arm back within the limits.</source>
        <translation>El brazo está fuera de un límite de seguridad. Devuélvalo a sus límites con la consola portátil.</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>Parada de salvaguarda</translation>
    </message>
    <message>
        <source>A safeguard is open. Close it and, if a reset is configured, press the reset button.</source>
        <translation>Una protección está abierta. Ciérrela y, si hay un rearme configurado, pulse el botón de rearme.</translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation>Parada de emergencia del sistema</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Parada de emergencia</translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation>Infracción de seguridad</translation>
    </message>
    <message>
        <source>A safety limit was exceeded and power was cut. Check the cause, then restart the safety system.</source>
        <translation>Se superó un límite de seguridad y se cortó la corriente. Compruebe la causa y reinicie el sistema de seguridad.</translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation>Fallo de seguridad</translation>
    </message>
    <message>
        <source>The safety system found a fault. Check the robot&apos;s log, then restart the safety system.</source>
        <translation>El sistema de seguridad encontró un fallo. Compruebe el registro del robot y reinicie el sistema de seguridad.</translation>
    </message>
    <message>
        <source>Validate joints</source>
        <translation>Validar articulaciones</translation>
    </message>
    <message>
        <source>A joint was replaced. Validate the joints on the teach pendant.</source>
        <translation>Se ha sustituido una articulación. Valide las articulaciones en la consola portátil.</translation>
    </message>
    <message>
        <source>Undefined</source>
        <translation>Indefinido</translation>
    </message>
    <message>
        <source>The controller does not report its safety mode. Check the teach pendant.</source>
        <translation>El controlador no comunica su modo de seguridad. Compruebe la consola portátil.</translation>
    </message>
    <message>
        <source>Automatic safeguard stop</source>
        <translation>Parada de salvaguarda automática</translation>
    </message>
    <message>
        <source>The automatic mode safeguard is open. Close it, or switch to manual mode.</source>
        <translation>La salvaguarda del modo automático está abierta. Ciérrela o cambie al modo manual.</translation>
    </message>
    <message>
        <source>Enabling device stop</source>
        <translation>Parada del dispositivo de habilitación</translation>
    </message>
    <message>
        <source>The enabling device is not held. Hold it in its middle position.</source>
        <translation>El dispositivo de habilitación no está pulsado. Manténgalo en su posición media.</translation>
    </message>
    <message>
        <source>Pendant enabling stop</source>
        <translation>Parada de habilitación de la consola</translation>
    </message>
    <message>
        <source>IMMI emergency stop</source>
        <translation>Parada de emergencia IMMI</translation>
    </message>
    <message>
        <source>IMMI safeguard stop</source>
        <translation>Parada de salvaguarda IMMI</translation>
    </message>
    <message>
        <source>The moulding machine&apos;s safeguard is open. Close it.</source>
        <translation>La salvaguarda de la inyectora está abierta. Ciérrela.</translation>
    </message>
    <message>
        <source>PROFIsafe waiting</source>
        <translation>PROFIsafe en espera</translation>
    </message>
    <message>
        <source>The robot is waiting for the PROFIsafe controller. Check the fieldbus and the PROFIsafe parameters.</source>
        <translation>El robot espera al controlador PROFIsafe. Compruebe el bus de campo y los parámetros de PROFIsafe.</translation>
    </message>
    <message>
        <source>PROFIsafe automatic stop</source>
        <translation>Parada automática PROFIsafe</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an automatic mode safeguard stop. Clear the request on that controller.</source>
        <translation>El controlador PROFIsafe solicita la parada de salvaguarda del modo automático. Anule la solicitud allí.</translation>
    </message>
    <message>
        <source>PROFIsafe safeguard stop</source>
        <translation>Parada de salvaguarda PROFIsafe</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests a safeguard stop. Clear the request on that controller.</source>
        <translation>El controlador PROFIsafe solicita una parada de salvaguarda. Anule la solicitud allí.</translation>
    </message>
    <message>
        <source>PROFIsafe emergency stop</source>
        <translation>Parada de emergencia PROFIsafe</translation>
    </message>
    <message>
        <source>Safety API stop</source>
        <translation>Parada por Safety API</translation>
    </message>
    <message>
        <source>A program requests a safeguard stop through the safety API. Clear the request in that program.</source>
        <translation>Un programa solicita una parada de salvaguarda a través de la API de seguridad. Anule la solicitud en ese programa.</translation>
    </message>
    <message>
        <source>I/O plane stop</source>
        <translation>Parada por plano de E/S</translation>
    </message>
    <message>
        <source>The tool crossed a safety plane that is enabled by an input. Move the tool back with the teach pendant, or turn the input off.</source>
        <translation>La herramienta cruzó un plano de seguridad activado por una entrada. Sáquela con la consola portátil o desactive la entrada.</translation>
    </message>
    <message>
        <source>Program stopping</source>
        <translation>Programa deteniéndose</translation>
    </message>
    <message>
        <source>The program on the robot is stopping.</source>
        <translation>El programa del robot se está deteniendo.</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Sin programa</translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation>No hay ningún programa en marcha en el robot.</translation>
    </message>
    <message>
        <source>Program running</source>
        <translation>Programa en ejecución</translation>
    </message>
    <message>
        <source>A program is running on the robot and may move the arm.</source>
        <translation>Un programa está en marcha en el robot y puede mover el brazo.</translation>
    </message>
    <message>
        <source>Program pausing</source>
        <translation>Programa pausándose</translation>
    </message>
    <message>
        <source>The program is pausing.</source>
        <translation>El programa se está pausando.</translation>
    </message>
    <message>
        <source>Program paused</source>
        <translation>Programa en pausa</translation>
    </message>
    <message>
        <source>Press “Play” to continue the interrupted motion, or stop the program to discard it.</source>
        <translation>Pulse Reproducir para continuar el movimiento interrumpido, o detenga el programa para descartarlo.</translation>
    </message>
    <message>
        <source>Program resuming</source>
        <translation>Programa reanudándose</translation>
    </message>
    <message>
        <source>The program is resuming, and the arm may move.</source>
        <translation>El programa se reanuda: el brazo puede moverse.</translation>
    </message>
    <message>
        <source>Unknown robot mode %1. See the teach pendant.</source>
        <translation>Modo de robot desconocido %1. Mire la consola portátil.</translation>
    </message>
    <message>
        <source>Unknown safety mode %1. See the teach pendant.</source>
        <translation>Modo de seguridad desconocido %1. Mire la consola portátil.</translation>
    </message>
    <message>
        <source>Unknown program state %1. See the teach pendant.</source>
        <translation>Estado de programa desconocido %1. Mire la consola portátil.</translation>
    </message>
    <message>
        <source>The brakes are released. The arm is at standstill.</source>
        <translation>Los frenos están liberados. El brazo está en reposo.</translation>
    </message>
    <message>
        <source>The controller stopped the arm. Find the cause, wait 5 s, then unlock the protective stop.</source>
        <translation>El controlador detuvo el brazo. Averigüe la causa, espere 5 s y desbloquee la parada de protección.</translation>
    </message>
    <message>
        <source>The cell&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation>La parada de emergencia de la célula está pulsada. Suéltela, después encienda y libere los frenos.</translation>
    </message>
    <message>
        <source>The emergency stop button of the robot is pressed. Twist it clockwise to release it, then power on the arm and release the brakes.</source>
        <translation>El botón de parada de emergencia del robot está pulsado. Gírelo en sentido horario para soltarlo, después encienda y libere los frenos.</translation>
    </message>
    <message>
        <source>The moulding machine&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation>La parada de emergencia de la inyectora está pulsada. Suéltela, después encienda y libere los frenos.</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an emergency stop. Clear the request on that controller, then power on the arm and release the brakes.</source>
        <translation>El controlador PROFIsafe solicita una parada de emergencia. Anúlela allí, después encienda y libere los frenos.</translation>
    </message>
    <message>
        <source>The enabling button of the teach pendant is not held. Hold it in its middle position.</source>
        <translation>El botón de habilitación de la consola no está pulsado. Manténgalo en su posición media.</translation>
    </message>
</context>
<context>
    <name>OutputGripper</name>
    <message>
        <source>The robot did not confirm the outputs. Another program or the installation may control them.</source>
        <translation>El robot no confirmó las salidas. Puede que las controle otro programa o la instalación.</translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation>Pinza: cerrar</translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation>Pinza: abrir</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>pendiente…</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>open requested</source>
        <translation>apertura solicitada</translation>
    </message>
    <message>
        <source>close requested</source>
        <translation>cierre solicitado</translation>
    </message>
    <message>
        <source>both outputs off</source>
        <translation>ambas salidas desactivadas</translation>
    </message>
    <message>
        <source>both outputs on</source>
        <translation>ambas salidas activadas</translation>
    </message>
    <message>
        <source>Choose different outputs for closing and opening.</source>
        <translation>Elija dos salidas distintas: una cierra, la otra abre.</translation>
    </message>
</context>
<context>
    <name>PanelActions</name>
    <message>
        <source>Record</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>Records the robot data to a file until you stop the recording.</source>
        <translation>Graba los datos del robot en un archivo hasta que detenga la grabación.</translation>
    </message>
    <message>
        <source>A recording is already running.</source>
        <translation>Ya hay una grabación en curso.</translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation>Conéctese primero a un robot.</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Detener grabación</translation>
    </message>
    <message>
        <source>Stops the recording and completes its file.</source>
        <translation>Detiene la grabación y completa su archivo.</translation>
    </message>
    <message>
        <source>No recording is running.</source>
        <translation>No hay ninguna grabación en curso.</translation>
    </message>
    <message>
        <source>Pause or resume the plots</source>
        <translation>Pausar o reanudar los gráficos</translation>
    </message>
    <message>
        <source>Freezes the plots while data and recording continue. Press again to return to the newest samples.</source>
        <translation>Congela los gráficos; los datos y la grabación continúan. Pulse de nuevo para volver a las muestras más recientes.</translation>
    </message>
    <message>
        <source>Export the plots…</source>
        <translation>Exportar los gráficos…</translation>
    </message>
    <message>
        <source>Saves the visible range as an image, PDF page or table of values.</source>
        <translation>Guarda el intervalo visible como imagen, página PDF o tabla de valores.</translation>
    </message>
    <message>
        <source>Plots: last %1</source>
        <translation>Gráficos: últimos %1</translation>
    </message>
    <message>
        <source>Sets the time range of the plots.</source>
        <translation>Ajusta el intervalo de tiempo de los gráficos.</translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation>Buscar entradas y salidas</translation>
    </message>
    <message>
        <source>Finds a terminal or a register by its number or name.</source>
        <translation>Encuentra un borne o un registro por su número o nombre.</translation>
    </message>
    <message>
        <source>Rename selected input or output</source>
        <translation>Renombrar la entrada o salida seleccionada</translation>
    </message>
    <message>
        <source>Renames the input or output in the selected row of the I/O tab.</source>
        <translation>Cambia el nombre de la entrada o salida de la fila seleccionada de la pestaña E/S.</translation>
    </message>
    <message>
        <source>Switch selected output</source>
        <translation>Conmutar la salida seleccionada</translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on or off.</source>
        <translation>Activa o desactiva la salida seleccionada de la pestaña E/S.</translation>
    </message>
    <message>
        <source>Pulse selected output</source>
        <translation>Pulso en la salida seleccionada</translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on for 0.5 s, then off.</source>
        <translation>Activa durante 0,5 s la salida seleccionada de la pestaña E/S y después la desactiva.</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>Buscar en el registro</translation>
    </message>
    <message>
        <source>Shows only entries that contain the search text.</source>
        <translation>Muestra solo las entradas que contienen el texto buscado.</translation>
    </message>
    <message>
        <source>Log: show all</source>
        <translation>Registro: mostrar todo</translation>
    </message>
    <message>
        <source>Log: show warnings and errors</source>
        <translation>Registro: mostrar avisos y errores</translation>
    </message>
    <message>
        <source>Log: show errors only</source>
        <translation>Registro: mostrar errores</translation>
    </message>
    <message>
        <source>Selects which log entries are shown.</source>
        <translation>Selecciona qué entradas del registro se muestran.</translation>
    </message>
    <message>
        <source>Copy the log</source>
        <translation>Copiar el registro</translation>
    </message>
    <message>
        <source>Copies the selected entries. If no entry is selected, copies all visible entries.</source>
        <translation>Copia las entradas seleccionadas, o todas las visibles.</translation>
    </message>
    <message>
        <source>Export the log…</source>
        <translation>Exportar el registro…</translation>
    </message>
    <message>
        <source>Writes the visible entries to a file.</source>
        <translation>Escribe las entradas visibles en un archivo.</translation>
    </message>
    <message>
        <source>Search plot signals</source>
        <translation>Buscar señales para los gráficos</translation>
    </message>
    <message>
        <source>Opens the list of all signals. To add a signal to a plot, drag it, double-click it or press Return.</source>
        <translation>Abre la lista de todas las señales. Añada una a un gráfico arrastrándola, con doble clic o con Intro.</translation>
    </message>
    <message>
        <source>New plot page</source>
        <translation>Nueva página de gráficos</translation>
    </message>
    <message>
        <source>Adds an empty page at the end. All pages share the time axis.</source>
        <translation>Añade una página vacía al final. Todas comparten el eje de tiempo.</translation>
    </message>
    <message>
        <source>Show the entire history</source>
        <translation>Mostrar todo el historial</translation>
    </message>
    <message>
        <source>Shows all data in memory and scales each plot automatically.</source>
        <translation>Muestra todos los datos en memoria y ajusta automáticamente la escala de cada gráfico.</translation>
    </message>
    <message>
        <source>Add note…</source>
        <translation>Añadir nota…</translation>
    </message>
    <message>
        <source>Adds a note at the selected cursor if it is visible, otherwise at the end of the plots.</source>
        <translation>Añade una nota en el cursor seleccionado si es visible; si no, al final de los gráficos.</translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation>Mostrar u ocultar %1</translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation>Separar %1</translation>
    </message>
    <message>
        <source>Moves the panel to a separate window, e.g. on a second screen, or back to the main window.</source>
        <translation>Mueve el panel a una ventana aparte, p. ej. para una segunda pantalla, o de vuelta.</translation>
    </message>
    <message>
        <source>Moves the panel to this side of the main window.</source>
        <translation>Mueve este panel a este lado de la ventana principal.</translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation>Mostrar gráficos estándar</translation>
    </message>
    <message>
        <source>Replaces the pages of live data with the standard page. Pages with recordings are kept.</source>
        <translation>Sustituye las páginas de datos en vivo por la página estándar. Las páginas con grabaciones se conservan.</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Abrir grabación…</translation>
    </message>
    <message>
        <source>Shows a recording or a table of another program on its own page.</source>
        <translation>Muestra una grabación o una tabla de otro programa en su propia página.</translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation>Cerrar las grabaciones</translation>
    </message>
    <message>
        <source>Removes all opened recordings from the plots. The files are kept.</source>
        <translation>Quita todas las grabaciones abiertas de los gráficos. Los archivos se conservan.</translation>
    </message>
    <message>
        <source>No recording is open.</source>
        <translation>No hay ninguna grabación abierta.</translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation>Comparar con el modelo del brazo…</translation>
    </message>
    <message>
        <source>Compares the displayed recording with the model of its arm.</source>
        <translation>Compara la grabación mostrada con el modelo de su brazo.</translation>
    </message>
    <message>
        <source>Show the page of a recording first.</source>
        <translation>Muestre primero la página de una grabación.</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>Valores en los cursores</translation>
    </message>
    <message>
        <source>Shows or hides the table of values at the cursors and between them.</source>
        <translation>Muestra u oculta la tabla de valores en los cursores y entre ellos.</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>Espectro y XY</translation>
    </message>
    <message>
        <source>Shows or hides the spectrum and the XY plot of two signals.</source>
        <translation>Muestra u oculta el espectro y el gráfico XY de dos señales.</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>Mover %1 a la izquierda</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>Mover %1 a la derecha</translation>
    </message>
    <message>
        <source>%1 to the top</source>
        <translation>Mover %1 arriba</translation>
    </message>
    <message>
        <source>%1 to the bottom</source>
        <translation>Mover %1 abajo</translation>
    </message>
    <message>
        <source>Plots: start or stop playback</source>
        <translation>Gráficos: iniciar o detener la reproducción</translation>
    </message>
    <message>
        <source>Moves cursor A in real time through the recording or the paused plots. The Layout menu contains other speeds.</source>
        <translation>Mueve el cursor A en tiempo real por la grabación o los gráficos en pausa. El menú «Disposición» contiene otras velocidades.</translation>
    </message>
</context>
<context>
    <name>PlotMenu</name>
    <message>
        <source>Remove lane %1</source>
        <translation>Quitar la pista %1</translation>
    </message>
    <message>
        <source>Add note here…</source>
        <translation>Añadir nota aquí…</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Mostrar %1</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>Ocultar %1</translation>
    </message>
    <message>
        <source>Show values of %1 at the cursors</source>
        <translation>Mostrar valores de %1 en los cursores</translation>
    </message>
    <message>
        <source>Move %1 to a separate plot</source>
        <translation>Pasar %1 a un gráfico propio</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Quitar %1</translation>
    </message>
    <message>
        <source>Warn when %1</source>
        <translation>Avisar cuando %1</translation>
    </message>
    <message>
        <source>Do not warn when %1</source>
        <translation>No avisar cuando %1</translation>
    </message>
    <message>
        <source>Rate of change of %1</source>
        <translation>Tasa de cambio de %1</translation>
    </message>
    <message>
        <source>Moving mean of %1 over 0.5 s</source>
        <translation>Media móvil de %1 en 0,5 s</translation>
    </message>
    <message>
        <source>Mean %1</source>
        <translation>Media %1</translation>
    </message>
    <message>
        <source>Norm of the curves in this plot</source>
        <translation>Norma de las curvas de este gráfico</translation>
    </message>
    <message>
        <source>New plot below</source>
        <translation>Nuevo gráfico debajo</translation>
    </message>
    <message>
        <source>New plot to the right</source>
        <translation>Nuevo gráfico a la derecha</translation>
    </message>
    <message>
        <source>Remove this plot</source>
        <translation>Quitar este gráfico</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>Low-pass filter of %1 at 10 Hz</source>
        <translation>Filtro de paso bajo de %1 a 10 Hz</translation>
    </message>
    <message>
        <source>Filtered %1</source>
        <translation>%1 filtrada</translation>
    </message>
    <message>
        <source>Left axis</source>
        <translation>Eje izquierdo</translation>
    </message>
    <message>
        <source>Right axis</source>
        <translation>Eje derecho</translation>
    </message>
    <message>
        <source>Edit %1…</source>
        <translation>Editar %1…</translation>
    </message>
    <message>
        <source>Axis limits…</source>
        <translation>Límites del eje…</translation>
    </message>
    <message>
        <source>Scale to curves</source>
        <translation>Ajustar a las curvas</translation>
    </message>
</context>
<context>
    <name>PlotPane</name>
    <message>
        <source>%1 (right)</source>
        <translation>%1 (derecha)</translation>
    </message>
</context>
<context>
    <name>Practice</name>
    <message>
        <source>Waiting for the protective stop.</source>
        <translation>Esperando la parada de protección.</translation>
    </message>
    <message>
        <source>The arm is in a protective stop. Press “Recover…” in the header.</source>
        <translation>El brazo está en parada de protección. Pulse «Recuperar…» en la cabecera.</translation>
    </message>
    <message>
        <source>Unlocked. The arm is not running yet: follow the steps on the recovery page.</source>
        <translation>Desbloqueado. El brazo aún no está en marcha: siga los pasos de la página de recuperación.</translation>
    </message>
    <message>
        <source>Unlocked. Take control again.</source>
        <translation>Desbloqueado. Tome de nuevo el control.</translation>
    </message>
    <message>
        <source>The arm is running and under your control again.</source>
        <translation>El brazo está en marcha y de nuevo bajo su control.</translation>
    </message>
    <message>
        <source>No new frame yet. Use “3 points” in the Frames tab.</source>
        <translation>Aún no hay un sistema de coordenadas nuevo. Use «3 puntos» en la pestaña Sistemas de coordenadas.</translation>
    </message>
    <message>
        <source>“%1” meets the requirements.</source>
        <translation>«%1» cumple los requisitos.</translation>
    </message>
    <message>
        <source>The Z axis of “%1” differs from the base Z axis by %2°. The third point must be on the +Y side.</source>
        <translation>El eje Z de «%1» difiere %2° del eje Z de la base. El tercer punto debe estar en el lado +Y.</translation>
    </message>
    <message>
        <source>The X axis of “%1” differs from the base Y axis by %2°.</source>
        <translation>El eje X de «%1» difiere %2° del eje Y de la base.</translation>
    </message>
    <message>
        <source>“%1” was not taught with the arm: the TCP was never at its origin.</source>
        <translation>«%1» no se enseñó con el brazo: el TCP nunca estuvo en su origen.</translation>
    </message>
    <message>
        <source>The waypoint was deleted. Press “Start” to add a new waypoint.</source>
        <translation>El punto de paso se eliminó. Pulse Iniciar para añadir uno nuevo.</translation>
    </message>
    <message>
        <source>“%1” has not changed. The arm is %2 away from the waypoint along X.</source>
        <translation>«%1» no ha cambiado. El brazo está a %2 de él a lo largo de X.</translation>
    </message>
    <message>
        <source>“%1” has moved by %2 and is %3 from the expected position.</source>
        <translation>«%1» se movió %2 y está a %3 de la posición esperada.</translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the tool orientation changed.</source>
        <translation>«%1» está en la posición esperada, pero la orientación de la herramienta cambió.</translation>
    </message>
    <message>
        <source>“%1” matches the part again.</source>
        <translation>«%1» vuelve a coincidir con la pieza.</translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the arm is not. Touch up the waypoint with the arm at the part.</source>
        <translation>«%1» está en la posición esperada, pero el brazo no. Retoque el punto con el brazo en la pieza.</translation>
    </message>
    <message>
        <source>Slowed down to %1. Continue.</source>
        <translation>Ralentizado a %1. Continúe.</translation>
    </message>
    <message>
        <source>No limit reached yet. The line below the pad will show the limit.</source>
        <translation>Aún no se alcanzó ningún límite. La línea bajo los botones lo indicará.</translation>
    </message>
    <message>
        <source>Limit reached. Now jog back: %1 of %2.</source>
        <translation>Límite alcanzado. Ahora vuelva: %1 de %2.</translation>
    </message>
    <message>
        <source>You reached the limit and moved back.</source>
        <translation>Alcanzó el límite y volvió atrás.</translation>
    </message>
    <message>
        <source>Recording: %1 s of %2 s.</source>
        <translation>Grabando: %1 s de %2 s.</translation>
    </message>
    <message>
        <source>The recording is too short. Record for at least three seconds.</source>
        <translation>La grabación es demasiado corta. Grabe durante al menos tres segundos.</translation>
    </message>
    <message>
        <source>No recording yet. Press “Record” above the plots.</source>
        <translation>Aún no hay grabación. Pulse «Grabar» sobre los gráficos.</translation>
    </message>
    <message>
        <source>Recorded. Enter the force shown in the plot.</source>
        <translation>Grabado. Introduzca la fuerza que muestra el gráfico.</translation>
    </message>
    <message>
        <source>%1 does not match the recording. Look at the Fz curve.</source>
        <translation>%1 no coincide con la grabación. Observe la curva Fz.</translation>
    </message>
    <message>
        <source>Correct: the force was %1.</source>
        <translation>Correcto: la fuerza era %1.</translation>
    </message>
    <message>
        <source>Recover from a protective stop</source>
        <translation>Recuperarse de una parada de protección</translation>
    </message>
    <message>
        <source>Teach a frame</source>
        <translation>Enseñar un sistema de coordenadas</translation>
    </message>
    <message>
        <source>Touch up a waypoint</source>
        <translation>Retocar un punto de paso</translation>
    </message>
    <message>
        <source>Find the reach limit</source>
        <translation>Encontrar el límite de alcance</translation>
    </message>
    <message>
        <source>Record and measure</source>
        <translation>Grabar y medir</translation>
    </message>
    <message>
        <source>Press “Start” to simulate a collision that causes a protective stop. Find out what stopped the arm, wait five seconds, unlock the arm and take control again.</source>
        <translation>Pulse Iniciar para simular un choque que provoca una parada de protección. Averigüe qué detuvo el brazo, espere cinco segundos, desbloquéelo y tome de nuevo el control.</translation>
    </message>
    <message>
        <source>Teach a frame from three points in the Frames tab. Its X axis must point along the base Y+ direction and its Z axis up: record the origin, then a point further along Y+, then a point further along X−.</source>
        <translation>Enseñe un sistema de coordenadas con tres puntos en la pestaña Sistemas de coordenadas. Su eje X debe apuntar en Y+ de la base y su eje Z hacia arriba: tome el origen, después un punto más allá en Y+ y otro más allá en X−.</translation>
    </message>
    <message>
        <source>Press “Start” to add a waypoint “part” at the current position of the arm. The part then moves by %1 along the base X+ direction. Jog to the part, select the waypoint and touch it up (U).</source>
        <translation>Pulse Iniciar para añadir un punto de paso «pieza» en la posición actual del brazo. Después la pieza se desplaza %1 en X+ de la base. Mueva el brazo allí, seleccione el punto y retóquelo (U).</translation>
    </message>
    <message>
        <source>Jog outwards, away from the base, until a limit halves the speed. The line below the pad shows the limit and how to move away from it. Then jog back by %1.</source>
        <translation>Mueva el brazo hacia fuera, alejándolo de la base, hasta que un límite reduzca la velocidad a la mitad. La línea bajo los botones indica el límite y cómo salir de él. Después vuelva %1.</translation>
    </message>
    <message>
        <source>Press “Start” to simulate a hand pressing on the tool from above. Record for at least three seconds, then stop. Read the force Fz in the plots and enter the value.</source>
        <translation>Pulse Iniciar para simular una mano que presiona la herramienta desde arriba. Grabe al menos tres segundos y detenga la grabación. Lea la fuerza Fz en los gráficos e introdúzcala.</translation>
    </message>
    <message>
        <source>part</source>
        <translation>pieza</translation>
    </message>
</context>
<context>
    <name>ProgramText</name>
    <message>
        <source>Maximum distance</source>
        <translation>Distancia máxima</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>Fallar</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>“%1” is %2. The value must be between %3 and %4.</source>
        <translation>«%1» es %2; debe estar entre %3 y %4.</translation>
    </message>
    <message>
        <source>The group “%1” contains no waypoints. Add waypoints to the group, or select a different group.</source>
        <translation>El grupo «%1» no contiene puntos de paso. Añada puntos al grupo o seleccione otro grupo.</translation>
    </message>
    <message>
        <source>“%1” refers to an item that was deleted from the project. Select a different item.</source>
        <translation>«%1» se refiere a un elemento que se eliminó del proyecto. Seleccione otro elemento.</translation>
    </message>
    <message>
        <source>“%1” must come directly after “%2”.</source>
        <translation>«%1» debe ir justo después de «%2».</translation>
    </message>
    <message>
        <source>“%1” must be inside “%2”.</source>
        <translation>«%1» debe estar dentro de «%2».</translation>
    </message>
    <message>
        <source>Steps in “Watch in parallel” cannot move the arm. Move this step out of the section.</source>
        <translation>Los pasos en paralelo no pueden mover el brazo. Saque este paso de la sección.</translation>
    </message>
    <message>
        <source>This version of Tiller does not support the step “%1”. Update Tiller, or delete the step.</source>
        <translation>Esta versión de Tiller no admite el paso «%1». Actualice Tiller o elimine el paso.</translation>
    </message>
    <message>
        <source>A program can start only at a top-level step, and not at a branch such as Else. Select a different step.</source>
        <translation>Un programa solo puede empezar en un paso de nivel superior, y no en una rama como Si no. Seleccione otro paso.</translation>
    </message>
    <message>
        <source>The project does not contain this program. Select a different program.</source>
        <translation>El proyecto no contiene este programa. Seleccione otro programa.</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a %2. Use “Adapt project to this robot…” first.</source>
        <translation>El proyecto se enseñó con un %1, pero el robot es un %2. Use primero «Adaptar el proyecto a este robot…».</translation>
    </message>
    <message>
        <source>A program with parameters cannot be started directly. Use a “Call program” step in another program.</source>
        <translation>Un programa con parámetros no puede iniciarse directamente. Llámelo con un paso de otro programa.</translation>
    </message>
    <message>
        <source>The program has no steps. Add steps first.</source>
        <translation>El programa no tiene pasos. Añada pasos primero.</translation>
    </message>
    <message>
        <source>The variable “%1” has a different type elsewhere in the program. Use the same type or a different name.</source>
        <translation>La variable «%1» tiene otro tipo en otra parte del programa. Use el mismo tipo u otro nombre.</translation>
    </message>
    <message>
        <source>Program calls are nested too deeply. Use fewer levels of calls.</source>
        <translation>Las llamadas a programas están anidadas a demasiada profundidad. Use menos niveles.</translation>
    </message>
    <message>
        <source>“%1” was taught with a different TCP than the waypoints before it. Set the active TCP, or put the step in a TCP section.</source>
        <translation>«%1» se enseñó con un TCP distinto del de los puntos anteriores. Defina el TCP activo o ponga el paso en una sección TCP.</translation>
    </message>
    <message>
        <source>The blend radii of this move and the previous move (%1 and %2) exceed the distance of %3 between the two targets. Reduce a blend radius.</source>
        <translation>Los radios de fusión de este movimiento y del anterior (%1 y %2) superan la distancia de %3 entre los dos destinos. Reduzca un radio.</translation>
    </message>
    <message>
        <source>The expression is empty. Enter an expression.</source>
        <translation>La expresión está vacía. Introduzca una expresión.</translation>
    </message>
    <message>
        <source>An expression must be a single line.</source>
        <translation>Una expresión debe ocupar una sola línea.</translation>
    </message>
    <message>
        <source>“%1” is not a valid variable name. Use letters, digits and underscores, and do not start with a digit.</source>
        <translation>«%1» no es un nombre de variable válido. Use letras, dígitos y guiones bajos, y no empiece por un dígito.</translation>
    </message>
    <message>
        <source>The name “%1” is reserved. Use a different name.</source>
        <translation>El nombre «%1» está reservado. Use otro nombre.</translation>
    </message>
    <message>
        <source>The arm comes too close to itself.</source>
        <translation>El brazo se acerca demasiado a sí mismo.</translation>
    </message>
    <message>
        <source>The arm comes too close to “%1”.</source>
        <translation>El brazo se acerca demasiado a «%1».</translation>
    </message>
    <message>
        <source>The arm comes too close to the floor.</source>
        <translation>El brazo se acerca demasiado al suelo.</translation>
    </message>
    <message>
        <source>The step failed and ended the program.</source>
        <translation>El paso falló y terminó el programa.</translation>
    </message>
    <message>
        <source>The program did not end within %1 s.</source>
        <translation>El programa no terminó en %1 s.</translation>
    </message>
    <message>
        <source>The preview was cancelled.</source>
        <translation>La vista previa se canceló.</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Movimientos</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Entradas y salidas</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Espera</translation>
    </message>
    <message>
        <source>Tool and speed</source>
        <translation>Herramienta y velocidad</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Flujo</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operador</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Estructura</translation>
    </message>
    <message>
        <source>Set variable</source>
        <translation>Asignar variable</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>Número entero</translation>
    </message>
    <message>
        <source>True or false</source>
        <translation>Verdadero o falso</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Call program</source>
        <translation>Llamar programa</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Parameter values</source>
        <translation>Valores de parám.</translation>
    </message>
    <message>
        <source>The program “%1” requires %2 comma-separated values, but the step passes %3.</source>
        <translation>El programa «%1» requiere %2 valores separados por comas, pero el paso pasa %3.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Caso</translation>
    </message>
    <message>
        <source>“Default” must be the last branch of a Switch.</source>
        <translation>Predeterminado debe ser la última parte de una selección.</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Predeterminado</translation>
    </message>
    <message>
        <source>Else if</source>
        <translation>Si no, si</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condición</translation>
    </message>
    <message>
        <source>Else</source>
        <translation>Si no</translation>
    </message>
    <message>
        <source>End program</source>
        <translation>Terminar el programa</translation>
    </message>
    <message>
        <source>The program failed.</source>
        <translation>El programa falló.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>For each pattern cell</source>
        <translation>Para cada celda del patrón</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Patrón</translation>
    </message>
    <message>
        <source>For each waypoint</source>
        <translation>Para cada punto de paso</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Force section</source>
        <translation>Sección de fuerza</translation>
    </message>
    <message>
        <source>Reference frame</source>
        <translation>Sistema de ref.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Section frame</source>
        <translation>Sistema de la sección</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Límite de velocidad</translation>
    </message>
    <message>
        <source>Frame section</source>
        <translation>Sección de sistema</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Sistema</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Pinza</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation>Salida de cierre</translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation>Salida de apertura</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Input to check</source>
        <translation>Comprobar entrada</translation>
    </message>
    <message>
        <source>If the input is off</source>
        <translation>Si la entrada está desactivada</translation>
    </message>
    <message>
        <source>Select different outputs for opening and closing.</source>
        <translation>Seleccione salidas distintas para abrir y cerrar.</translation>
    </message>
    <message>
        <source>The gripper is not holding an object.</source>
        <translation>La pinza no sujeta ningún objeto.</translation>
    </message>
    <message>
        <source>If</source>
        <translation>Si</translation>
    </message>
    <message>
        <source>Exit loop</source>
        <translation>Salir del bucle</translation>
    </message>
    <message>
        <source>“Exit loop” must be inside a loop.</source>
        <translation>El paso para salir del bucle debe estar dentro de un bucle.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Bucle</translation>
    </message>
    <message>
        <source>Repetitions (0: endless)</source>
        <translation>Repeticiones (0: sin fin)</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>Contador</translation>
    </message>
    <message>
        <source>This loop may never end and contains no delay. Add a Wait step.</source>
        <translation>Este bucle puede no terminar nunca y no contiene ninguna espera. Añada un paso Esperar.</translation>
    </message>
    <message>
        <source>A loop can have 1 to %1 positions; this loop has %2.</source>
        <translation>Un bucle puede tener de 1 a %1 posiciones; este tiene %2.</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Mensaje</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Advertencia</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Wait for the operator</source>
        <translation>Esperar al operador</translation>
    </message>
    <message>
        <source>MoveC</source>
        <translation>MoveC</translation>
    </message>
    <message>
        <source>Via</source>
        <translation>Pasando por</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Fusión</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Fixed to arc</source>
        <translation>Fija al arco</translation>
    </message>
    <message>
        <source>Move through a group</source>
        <translation>Recorrer un grupo</translation>
    </message>
    <message>
        <source>Run waypoint actions</source>
        <translation>Ejecutar acciones de los puntos</translation>
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
        <translation>Movimiento relativo</translation>
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
        <translation>La distancia es cero. Introduzca un valor para X, Y o Z.</translation>
    </message>
    <message>
        <source>The waypoint “%1” moves the gripper. In a program, use the Gripper step and turn off “Run waypoint actions”.</source>
        <translation>El punto de paso «%1» mueve la pinza. En un programa, use el paso Pinza y desactive «Ejecutar acciones de los puntos».</translation>
    </message>
    <message>
        <source>Waypoint</source>
        <translation>Punto de paso</translation>
    </message>
    <message>
        <source>Approach distance</source>
        <translation>Distancia de aproximación</translation>
    </message>
    <message>
        <source>The arm cannot reach “%1”. Change the waypoint, or select a different waypoint.</source>
        <translation>El brazo no puede alcanzar «%1». Cambie el punto de paso o seleccione otro.</translation>
    </message>
    <message>
        <source>Set either a waypoint or a pose, not both.</source>
        <translation>Defina un punto de paso o una pose, no ambos.</translation>
    </message>
    <message>
        <source>Set a waypoint or a pose.</source>
        <translation>Defina un punto de paso o una pose.</translation>
    </message>
    <message>
        <source>Move until</source>
        <translation>Mover hasta</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contacto</translation>
    </message>
    <message>
        <source>Input is on</source>
        <translation>Entrada activada</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>If not reached</source>
        <translation>Si no se alcanza</translation>
    </message>
    <message>
        <source>Select an input.</source>
        <translation>Seleccione una entrada.</translation>
    </message>
    <message>
        <source>The input did not turn on within the maximum distance. Check the sensor and its wiring.</source>
        <translation>La entrada no se activó dentro de la distancia máxima. Compruebe el sensor y su cableado.</translation>
    </message>
    <message>
        <source>No contact was detected within the maximum distance.</source>
        <translation>No se detectó contacto dentro de la distancia máxima.</translation>
    </message>
    <message>
        <source>Write to the log</source>
        <translation>Escribir en el registro</translation>
    </message>
    <message>
        <source>On error</source>
        <translation>En caso de error</translation>
    </message>
    <message>
        <source>Set payload</source>
        <translation>Fijar carga útil</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Carga útil</translation>
    </message>
    <message>
        <source>Pulse output</source>
        <translation>Pulso en salida</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Salida</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Activada</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Pregunta</translation>
    </message>
    <message>
        <source>Questions require robot software 5.6 or newer.</source>
        <translation>Las preguntas necesitan el software del robot 5.6 o posterior.</translation>
    </message>
    <message>
        <source>URScript</source>
        <translation>URScript</translation>
    </message>
    <message>
        <source>Names that begin with “tiller_” are reserved.</source>
        <translation>Los nombres que empiezan por «tiller_» están reservados.</translation>
    </message>
    <message>
        <source>Each block in the script needs an “end”.</source>
        <translation>Cada bloque del script necesita su propio «end».</translation>
    </message>
    <message>
        <source>Set analog output</source>
        <translation>Fijar salida analógica</translation>
    </message>
    <message>
        <source>Set output</source>
        <translation>Fijar salida</translation>
    </message>
    <message>
        <source>Set register</source>
        <translation>Fijar registro</translation>
    </message>
    <message>
        <source>Integer</source>
        <translation>Entero</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Real</translation>
    </message>
    <message>
        <source>Boolean</source>
        <translation>Booleano</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Programs can set registers only up to %1.</source>
        <translation>Los programas pueden fijar registros hasta %1.</translation>
    </message>
    <message>
        <source>Speed section</source>
        <translation>Sección de velocidad</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Selección</translation>
    </message>
    <message>
        <source>A Switch must contain at least one Case.</source>
        <translation>Una selección debe contener al menos un caso.</translation>
    </message>
    <message>
        <source>Only Case and Default can be placed directly in a Switch.</source>
        <translation>Una selección solo puede contener directamente Caso y Predeterminado.</translation>
    </message>
    <message>
        <source>TCP section</source>
        <translation>Sección TCP</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Intentar</translation>
    </message>
    <message>
        <source>“Try” must be followed directly by “On error”.</source>
        <translation>«En caso de error» debe ir justo después de «Intentar».</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Esperar</translation>
    </message>
    <message>
        <source>Wait for condition</source>
        <translation>Esperar una condición</translation>
    </message>
    <message>
        <source>On timeout</source>
        <translation>Al agotarse el tiempo</translation>
    </message>
    <message>
        <source>The condition did not become true before the timeout.</source>
        <translation>La condición no se cumplió a tiempo.</translation>
    </message>
    <message>
        <source>Wait for input</source>
        <translation>Esperar una entrada</translation>
    </message>
    <message>
        <source>%1 did not change to the expected state before the timeout.</source>
        <translation>%1 no cambió al estado esperado antes de agotarse el tiempo.</translation>
    </message>
    <message>
        <source>Watch in parallel</source>
        <translation>Vigilar en paralelo</translation>
    </message>
    <message>
        <source>A parallel watch must be at the top level of the program.</source>
        <translation>Una vigilancia en paralelo debe estar en el nivel superior del programa.</translation>
    </message>
    <message>
        <source>While</source>
        <translation>Mientras</translation>
    </message>
    <message>
        <source>At %1 s: %2</source>
        <translation>A los %1 s: %2</translation>
    </message>
    <message>
        <source>Step %1 (%2) at %3 s: %4</source>
        <translation>Paso %1 (%2) a los %3 s: %4</translation>
    </message>
    <message>
        <source>“%1” must be between %2 and %3.</source>
        <translation>«%1» debe estar entre %2 y %3.</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>Paso %1: %2</translation>
    </message>
    <message>
        <source>The TCP of the robot differs from the TCP of the program&apos;s waypoints. Set the active TCP of the project, or use a TCP section.</source>
        <translation>El TCP del robot difiere del TCP de los puntos del programa. Defina el TCP activo del proyecto o use una sección TCP.</translation>
    </message>
    <message>
        <source>Preview the program first.</source>
        <translation>Obtenga primero una vista previa del programa.</translation>
    </message>
    <message>
        <source>The preview found problems. Fix them, then preview the program again.</source>
        <translation>La vista previa encontró problemas. Corríjalos y repita la vista previa.</translation>
    </message>
    <message>
        <source>Move the arm to the start position first.</source>
        <translation>Mueva primero el brazo a la posición inicial.</translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation>Se está ejecutando un programa. Pare primero el programa.</translation>
    </message>
    <message>
        <source>The program ended after %1 s.</source>
        <translation>El programa terminó tras %1 s.</translation>
    </message>
    <message>
        <source>Step %1 (%2) failed and ended the program.</source>
        <translation>El paso %1 (%2) falló y terminó el programa.</translation>
    </message>
    <message>
        <source>Stopped in step %1 (%2): %3</source>
        <translation>Parada en el paso %1 (%2): %3</translation>
    </message>
    <message>
        <source>Stopped before the first step: %1</source>
        <translation>Parada antes del primer paso: %1</translation>
    </message>
    <message>
        <source>Later steps use the variable “%1” from step %2 (%3). Start at that step or earlier.</source>
        <translation>Los pasos posteriores usan la variable «%1» del paso %2 (%3). Empiece en ese paso o antes.</translation>
    </message>
    <message>
        <source>Later steps depend on step %1 (%2). Start at that step or earlier.</source>
        <translation>Los pasos posteriores necesitan el paso %1 (%2). Empiece en ese paso o antes.</translation>
    </message>
    <message>
        <source>The preview does not reach this step. Select a different step.</source>
        <translation>La vista previa no llega a este paso. Seleccione otro paso.</translation>
    </message>
    <message>
        <source>The simulated program does not complete step %1 (%2).</source>
        <translation>El programa simulado no termina el paso %1 (%2).</translation>
    </message>
    <message>
        <source>The arm has left the start position of step %1 (%2).</source>
        <translation>El brazo ha abandonado la posición inicial del paso %1 (%2).</translation>
    </message>
    <message>
        <source>The gripper may hold a part and would close again (%1).</source>
        <translation>La pinza puede sujetar una pieza y volvería a cerrarse (%1).</translation>
    </message>
    <message>
        <source>The gripper may have lost a part (%1).</source>
        <translation>La pinza puede haber perdido una pieza (%1).</translation>
    </message>
    <message>
        <source>%1 would turn on again.</source>
        <translation>%1 se activaría de nuevo.</translation>
    </message>
    <message>
        <source>%1 would have a different value.</source>
        <translation>%1 tendría otro valor.</translation>
    </message>
    <message>
        <source>The program would wait in step %1 (%2).</source>
        <translation>El programa esperaría en el paso %1 (%2).</translation>
    </message>
    <message>
        <source>The program would fail in step %1 (%2).</source>
        <translation>El programa fallaría en el paso %1 (%2).</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>La comprobación se ha cancelado.</translation>
    </message>
    <message>
        <source>An analog output would have a different value.</source>
        <translation>Una salida analógica tendría otro valor.</translation>
    </message>
    <message>
        <source>A register would have a different value.</source>
        <translation>Un registro tendría otro valor.</translation>
    </message>
    <message>
        <source>The variable “%1” would have a different value.</source>
        <translation>La variable «%1» tendría otro valor.</translation>
    </message>
    <message>
        <source>The TCP or the payload would differ.</source>
        <translation>El TCP o la carga útil serían diferentes.</translation>
    </message>
    <message>
        <source>The program would run different steps.</source>
        <translation>El programa ejecutaría otros pasos.</translation>
    </message>
    <message>
        <source>The arm would end at a different position.</source>
        <translation>El brazo terminaría en otra posición.</translation>
    </message>
    <message>
        <source>✔ Continue</source>
        <translation>✔ Continuar</translation>
    </message>
    <message>
        <source>↩ Move back</source>
        <translation>↩ Retroceder</translation>
    </message>
    <message>
        <source>✖ Unsafe</source>
        <translation>✖ No seguro</translation>
    </message>
    <message>
        <source>Simulated, after a stop in this step:</source>
        <translation>Simulado, tras una parada en este paso:</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>no alcanzado</translation>
    </message>
    <message>
        <source>can continue</source>
        <translation>puede continuar</translation>
    </message>
    <message>
        <source>can continue after moving back</source>
        <translation>puede continuar tras retroceder</translation>
    </message>
    <message>
        <source>cannot continue safely</source>
        <translation>no puede continuar con seguridad</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>Parada de protección</translation>
    </message>
    <message>
        <source>Stop by the operator</source>
        <translation>Parada del operador</translation>
    </message>
    <message>
        <source>Connection loss</source>
        <translation>Pérdida de conexión</translation>
    </message>
    <message>
        <source>Power loss</source>
        <translation>Corte de alimentación</translation>
    </message>
    <message>
        <source>Simulated: the program cannot continue safely. %1</source>
        <translation>Simulado: el programa no puede continuar con seguridad. %1</translation>
    </message>
    <message>
        <source>Simulated: the program can continue from step %1 (%2).</source>
        <translation>Simulado: el programa puede continuar desde el paso %1 (%2).</translation>
    </message>
    <message>
        <source>The stop was inside a force section, so the contact cannot be restored.</source>
        <translation>La parada ocurrió dentro de una sección de fuerza, por lo que no se puede restablecer el contacto.</translation>
    </message>
    <message>
        <source>The relative move is only partly complete.</source>
        <translation>El movimiento relativo se ha ejecutado en parte.</translation>
    </message>
    <message>
        <source>The URScript text was only partly executed.</source>
        <translation>El texto URScript se ha ejecutado en parte.</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>Tiempo límite</translation>
    </message>
    <message>
        <source>A program cannot continue inside a section or a called program. The next run starts from the beginning.</source>
        <translation>Un programa no puede continuar dentro de una sección ni de un programa llamado. La próxima ejecución empieza desde el principio.</translation>
    </message>
    <message>
        <source>A program cannot continue in the middle of this step. The next run starts from the beginning.</source>
        <translation>Un programa no puede continuar en medio de este paso. La próxima ejecución empieza desde el principio.</translation>
    </message>
    <message>
        <source>paused on the robot</source>
        <translation>en pausa en el robot</translation>
    </message>
    <message>
        <source>the speed, acceleration or blend is not a number, or a time is set</source>
        <translation>la velocidad, la aceleración o el radio de fusión no es un número, o se indica un tiempo</translation>
    </message>
    <message>
        <source>not imported</source>
        <translation>no importado</translation>
    </message>
    <message>
        <source>%1, disabled</source>
        <translation>%1, desactivado</translation>
    </message>
    <message>
        <source>the program has no name</source>
        <translation>el programa no tiene nombre</translation>
    </message>
    <message>
        <source>the project already has a program &apos;%1&apos;; choose another name</source>
        <translation>el proyecto ya contiene un programa «%1»; elija otro nombre</translation>
    </message>
    <message>
        <source>the file is too large for a program</source>
        <translation>el archivo es demasiado grande para un programa</translation>
    </message>
    <message>
        <source>the file is not text in UTF-8</source>
        <translation>el archivo no es texto en UTF-8</translation>
    </message>
    <message>
        <source>this line ends a block that was not opened</source>
        <translation>esta línea cierra un bloque que no se ha abierto</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>línea %1: %2</translation>
    </message>
    <message>
        <source>the program contains a return</source>
        <translation>el programa contiene un «return»</translation>
    </message>
    <message>
        <source>the program has too many statements</source>
        <translation>el programa tiene demasiadas instrucciones</translation>
    </message>
    <message>
        <source>the script of the steps does not compile</source>
        <translation>el script de los pasos no se puede compilar</translation>
    </message>
    <message>
        <source>the program is too complex</source>
        <translation>el programa es demasiado complejo</translation>
    </message>
    <message>
        <source>the file contains no statements</source>
        <translation>el archivo no contiene instrucciones</translation>
    </message>
    <message>
        <source>the file contains %1 functions or parameters, but no statement that calls a function; add the call</source>
        <translation>el archivo contiene %1 funciones o parámetros, pero ninguna instrucción que llame a una función; añada la llamada</translation>
    </message>
    <message>
        <source>the program contains no statements</source>
        <translation>el programa no contiene instrucciones</translation>
    </message>
    <message>
        <source>Installation</source>
        <translation>Instalación</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>In this project, programs begin with the TCP of the tool &apos;%1&apos;.</source>
        <translation>En este proyecto, los programas empiezan con el TCP de la herramienta «%1».</translation>
    </message>
    <message>
        <source>The program does not set the TCP. Its waypoints require the TCP %1.</source>
        <translation>El programa no establece el TCP. Sus puntos de paso requieren el TCP %1.</translation>
    </message>
    <message>
        <source>the TCP applies until the end of the program</source>
        <translation>el TCP se aplica hasta el final del programa</translation>
    </message>
    <message>
        <source>the program does not call this function</source>
        <translation>el programa no llama a esta función</translation>
    </message>
    <message>
        <source>imported as a program</source>
        <translation>importado como programa</translation>
    </message>
    <message>
        <source>part of a waypoint</source>
        <translation>parte de un punto de paso</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a different model. Adapt the project to the robot first.</source>
        <translation>El proyecto se enseñó con un %1, pero el robot es de otro modelo. Adapte primero el proyecto al robot.</translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>Simulado: %1</translation>
    </message>
    <message>
        <source>Step %1 failed and ended the program.</source>
        <translation>El paso %1 ha fallado y ha terminado el programa.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>step numbers</comment>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>paso %1</translation>
    </message>
    <message>
        <source>steps %1</source>
        <translation>pasos %1</translation>
    </message>
    <message>
        <source>The position of the arm is unknown because no robot data arrive. Check the connection to the robot.</source>
        <translation>La posición del brazo es desconocida porque no llegan datos del robot. Compruebe la conexión con el robot.</translation>
    </message>
    <message>
        <source>It is unknown whether the program completed, because robot data were missing at its end. Check the workpiece.</source>
        <translation>No se sabe si el programa terminó por completo, porque faltaron datos del robot al final. Compruebe la pieza.</translation>
    </message>
    <message>
        <source>Last known step: %1 (%2). %3</source>
        <translation>Último paso conocido: %1 (%2). %3</translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation>No se ejecuta ningún programa.</translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation>El programa está en pausa en el robot. Reanúdelo en la consola portátil.</translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation>Pause primero el programa.</translation>
    </message>
    <message>
        <source>Wait until the robot has confirmed the new value of “%1”.</source>
        <translation>Espere hasta que el robot haya confirmado el nuevo valor de «%1».</translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation>«%1» no es un número. Introduzca un número.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number. Enter a number without decimals.</source>
        <translation>«%1» no es un número entero. Introduzca un número sin decimales.</translation>
    </message>
    <message>
        <source>“%1” is not True or False. Enter one of these values.</source>
        <translation>«%1» no es True ni False. Introduzca uno de estos valores.</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Lista</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matriz</translation>
    </message>
    <message>
        <source>A URScript step in this program could move the arm after a change.</source>
        <translation>Un paso URScript de este programa podría mover el brazo después de un cambio.</translation>
    </message>
    <message>
        <source>Only numbers and True or False values can be changed.</source>
        <translation>Solo se pueden cambiar números y los valores True o False.</translation>
    </message>
    <message>
        <source>The program has no variable “%1”.</source>
        <translation>El programa no tiene ninguna variable «%1».</translation>
    </message>
    <message>
        <source>Variable “%1”: %2 → %3</source>
        <translation>Variable «%1»: %2 → %3</translation>
    </message>
    <message>
        <source>The robot did not confirm the new value of “%1”. Check the value in the list.</source>
        <translation>El robot no confirmó el nuevo valor de «%1». Compruebe el valor en la lista.</translation>
    </message>
    <message>
        <source>The robot does not report its variables. Wait until the connection is restored.</source>
        <translation>El robot no comunica sus variables. Espere hasta que se restablezca la conexión.</translation>
    </message>
    <message>
        <source>The recoverability check did not reach step %1 (%2). Check again with the inputs of the run to find out whether the program can continue.</source>
        <translation>La comprobación de reanudación no llegó al paso %1 (%2). Compruebe de nuevo con las entradas de la ejecución si el programa puede continuar.</translation>
    </message>
    <message>
        <source>This variable is set by URScript text. Only variables of a “Set variable” step can be changed.</source>
        <translation>Esta variable la asigna un texto URScript. Solo se pueden cambiar las variables de un paso «Asignar variable».</translation>
    </message>
    <message>
        <source>“%1” is not set. Select or enter a value.</source>
        <translation>«%1» no está definido. Seleccione o introduzca un valor.</translation>
    </message>
    <message>
        <source>“%1” has an invalid value. Enter a different value.</source>
        <translation>«%1» tiene un valor no válido. Introduzca otro valor.</translation>
    </message>
    <message>
        <source>“%1” cannot contain steps. Move its steps to another section.</source>
        <translation>«%1» no puede contener pasos. Mueva los pasos a otra sección.</translation>
    </message>
    <message>
        <source>A program cannot call itself. Select a different program.</source>
        <translation>Un programa no puede llamarse a sí mismo. Seleccione otro programa.</translation>
    </message>
    <message>
        <source>Unexpected character “%1”. Remove this character.</source>
        <translation>Carácter inesperado «%1». Elimine este carácter.</translation>
    </message>
    <message>
        <source>“%1” cannot be part of an expression. Remove this word.</source>
        <translation>«%1» no puede formar parte de una expresión. Elimine esta palabra.</translation>
    </message>
    <message>
        <source>The brackets do not match. Add or remove a bracket.</source>
        <translation>Los paréntesis no coinciden. Añada o elimine un paréntesis.</translation>
    </message>
    <message>
        <source>a Message step cannot have this title</source>
        <translation>un paso «Mensaje» no puede tener este título</translation>
    </message>
    <message>
        <source>the payload is not given as numbers in the permitted range</source>
        <translation>la carga útil no está indicada con números dentro del rango permitido</translation>
    </message>
    <message>
        <source>the target cannot be stored as a waypoint or as the pose of a step</source>
        <translation>su destino no puede ser un punto de paso ni una pose de un paso</translation>
    </message>
    <message>
        <source>the External Control node runs a script from another computer, which cannot be imported. Remove this node from the program.</source>
        <translation>el nodo External Control ejecuta un script de otro ordenador, que no se puede importar. Elimine este nodo del programa.</translation>
    </message>
    <message>
        <source>the blocks are nested too deeply</source>
        <translation>los bloques están anidados a demasiada profundidad</translation>
    </message>
    <message>
        <source>a block extends beyond its node</source>
        <translation>un bloque continúa más allá de su nodo</translation>
    </message>
    <message>
        <source>the line contains several statements</source>
        <translation>varias instrucciones comparten una línea</translation>
    </message>
    <message>
        <source>the block that begins on line %1 has no end</source>
        <translation>el bloque que empieza en la línea %1 no tiene fin</translation>
    </message>
    <message>
        <source>no step corresponds to this statement</source>
        <translation>ningún paso genera esta instrucción</translation>
    </message>
    <message>
        <source>The program uses output integer register 46 or 47, to which Tiller writes the number of the running step. Use different registers.</source>
        <translation>El programa utiliza el registro de salida entero 46 o 47, en el que Tiller escribe el número del paso en ejecución. Utilice otros registros.</translation>
    </message>
    <message>
        <source>a disabled node in a section that is imported as URScript text</source>
        <translation>un nodo desactivado en una parte que es texto</translation>
    </message>
    <message>
        <source>the condition cannot be used in a step</source>
        <translation>su condición no puede ser la condición de un paso</translation>
    </message>
    <message>
        <source>no step corresponds to a thread, or to a function with parameters or a result</source>
        <translation>no hay ningún paso para funciones con parámetros o resultado ni para hilos</translation>
    </message>
    <message>
        <source>the type or the scope of the variable cannot be determined</source>
        <translation>el tipo o el ámbito de la variable no está claro</translation>
    </message>
    <message>
        <source>%1. Save the program on the teach pendant and copy its .script file to the same folder, or change the program.</source>
        <translation>%1. Guarde el programa en la consola portátil y copie su archivo .script en la misma carpeta, o modifique el programa.</translation>
    </message>
    <message>
        <source>The nodes cannot be imported: %1. The script saved by the teach pendant was imported instead.</source>
        <translation>Los nodos no se pueden traducir: %1. En su lugar se ha importado el script que guardó la consola portátil.</translation>
    </message>
    <message>
        <source>%1. Complete the program on the teach pendant first.</source>
        <translation>%1. Complete primero el programa en la consola portátil.</translation>
    </message>
    <message>
        <source>ended on the robot (teach pendant, another client or halt)</source>
        <translation>terminado en el robot (consola portátil, otro cliente o halt)</translation>
    </message>
    <message>
        <source>a program from another client has taken over</source>
        <translation>un programa de otro cliente se ha hecho con el robot</translation>
    </message>
    <message>
        <source>The values of a program from another client cannot be changed.</source>
        <translation>Los valores de un programa de otro cliente no se pueden cambiar.</translation>
    </message>
    <message>
        <source>the statement is nested too deeply</source>
        <translation>está anidada a demasiada profundidad</translation>
    </message>
    <message>
        <source>The program cannot pause before this step. Select a different step.</source>
        <translation>El programa no puede hacer una pausa antes de este paso. Seleccione otro paso.</translation>
    </message>
    <message>
        <source>The move is only partly complete.</source>
        <translation>El movimiento se ha ejecutado solo en parte.</translation>
    </message>
</context>
<context>
    <name>ProjectLock</name>
    <message>
        <source>%1 on %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>proceso %1</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>otro programa</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>No robot connected. Choose a robot at the top left.</source>
        <translation>Ningún robot conectado. Elija uno arriba a la izquierda.</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Conectando…</translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically.</source>
        <translation>Sin datos del robot. Se reconecta automáticamente.</translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation>Los datos del robot se retrasan. Esperando datos nuevos.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Tomando el control…</translation>
    </message>
    <message>
        <source>Not in control. Press “Take control” in the header.</source>
        <translation>Sin control. Pulse «Tomar el control» en la cabecera.</translation>
    </message>
    <message>
        <source>Robot data are out of date. Wait for new data.</source>
        <translation>Los datos del robot no están al día. Espere datos nuevos.</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>Ningún robot conectado. Conecte uno o pruebe el simulador.</translation>
    </message>
    <message>
        <source>The arm is moving. Stop the arm first, then store the position.</source>
        <translation>El brazo se está moviendo. Detenga primero el brazo y guarde después la posición.</translation>
    </message>
</context>
<context>
    <name>RecordingChoice</name>
    <message>
        <source>A file name must not be empty or begin with a period.</source>
        <translation>El nombre de un archivo no puede estar vacío ni empezar por un punto.</translation>
    </message>
    <message>
        <source>A file name cannot contain “%1”.</source>
        <translation>Un nombre de archivo no puede contener «%1».</translation>
    </message>
    <message>
        <source>This name is too long.</source>
        <translation>Este nombre es demasiado largo.</translation>
    </message>
    <message>
        <source>Not a condition: “%1”. Examples: actual_TCP_force_2 &gt; 20, robot_mode = 7, actual_digital_input_bits:3 = 1, runtime_state changes.</source>
        <translation>No es una condición: «%1». Ejemplos: actual_TCP_force_2 &gt; 20, robot_mode = 7, actual_digital_input_bits:3 = 1, runtime_state changes.</translation>
    </message>
    <message>
        <source>There is no signal “%1”. Vectors have one signal per number, such as actual_q_0.</source>
        <translation>No existe la señal «%1». Los vectores tienen una señal por número, por ejemplo actual_q_0.</translation>
    </message>
</context>
<context>
    <name>RecoveryGuide</name>
    <message>
        <source>Safety mode is Normal again</source>
        <translation>El modo de seguridad vuelve a ser «Normal»</translation>
    </message>
    <message>
        <source>The arm can be moved. Motions interrupted by the stop do not resume. Press the button again for each motion.</source>
        <translation>El brazo se puede mover. Los movimientos interrumpidos por la parada no se reanudan: cada movimiento necesita una nueva pulsación.</translation>
    </message>
    <message>
        <source>The arm is ready. Take control to move the arm, or continue on the teach pendant.</source>
        <translation>El brazo está listo. Tome el control para moverlo, o siga en la consola portátil.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Tomando el control…</translation>
    </message>
    <message>
        <source>No data from the robot</source>
        <translation>Sin datos del robot</translation>
    </message>
    <message>
        <source>Waiting for the connection…</source>
        <translation>Esperando la conexión…</translation>
    </message>
    <message>
        <source>I have inspected the arm. No one is touching it, and nothing is trapped.</source>
        <translation>He inspeccionado el brazo. Nadie lo toca y nada está atrapado.</translation>
    </message>
    <message>
        <source>The cause of the stop is known and has been removed.</source>
        <translation>La causa de la parada se conoce y se ha eliminado.</translation>
    </message>
    <message>
        <source>Payload and TCP match the mounted tool.</source>
        <translation>La carga útil y el TCP corresponden a la herramienta montada.</translation>
    </message>
    <message>
        <source>Unlocking is available in %1 s</source>
        <translation>Desbloqueo posible en %1 s</translation>
    </message>
    <message>
        <source>I have inspected the arm and the robot&apos;s log, and I know the cause.</source>
        <translation>He inspeccionado el brazo y el registro del robot, y conozco la causa.</translation>
    </message>
    <message>
        <source>The cause has been removed, and no one is within reach of the arm.</source>
        <translation>La causa se ha eliminado y no hay nadie al alcance del brazo.</translation>
    </message>
    <message>
        <source>No action is needed in Tiller. This state ends when the cause is removed.</source>
        <translation>No hay que hacer nada en Tiller. El estado termina cuando se elimina la causa.</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Desbloquear</translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation>Reiniciar seguridad</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Encender</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>Liberar frenos</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Tomar el control</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>Replay</name>
    <message>
        <source>REPLAY</source>
        <translation>REPRODUCCIÓN</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>sin datos</translation>
    </message>
    <message>
        <source>history at %1 s</source>
        <translation>historial en %1 s</translation>
    </message>
    <message>
        <source>at %1 s in %2</source>
        <translation>en %1 s en %2</translation>
    </message>
</context>
<context>
    <name>RetracePath</name>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation>No hay trayectoria que recorrer hacia atrás. Mueva antes el brazo.</translation>
    </message>
</context>
<context>
    <name>RobotActions</name>
    <message>
        <source>Connect to a robot first.</source>
        <translation>Conéctese primero a un robot.</translation>
    </message>
    <message>
        <source>Give control back first.</source>
        <translation>Devuelva primero el control.</translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation>No hay ningún programa en marcha en el robot.</translation>
    </message>
    <message>
        <source>A program is already running.</source>
        <translation>Ya hay un programa en ejecución.</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Conectar…</translation>
    </message>
    <message>
        <source>Select the simulator, a robot or a project.</source>
        <translation>Seleccione el simulador, un robot o un proyecto.</translation>
    </message>
    <message>
        <source>Simulated robot</source>
        <translation>Robot simulado</translation>
    </message>
    <message>
        <source>Starts the simulated robot and connects to it.</source>
        <translation>Inicia el robot simulado y se conecta a él.</translation>
    </message>
    <message>
        <source>Check the connection…</source>
        <translation>Comprobar la conexión…</translation>
    </message>
    <message>
        <source>Select a robot first.</source>
        <translation>Elija primero un robot.</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Desconectar</translation>
    </message>
    <message>
        <source>Stops Tiller&apos;s motion, then closes the connection.</source>
        <translation>Detiene el movimiento de Tiller y después cierra la conexión.</translation>
    </message>
    <message>
        <source>No robot is connected.</source>
        <translation>Ningún robot está conectado.</translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation>Enciende el brazo. Los frenos siguen puestos.</translation>
    </message>
    <message>
        <source>The arm is powered on or powering on.</source>
        <translation>El brazo está encendido o se está encendiendo.</translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation>El brazo puede ceder unos milímetros. Manténgase apartado.</translation>
    </message>
    <message>
        <source>Stops programs, engages the brakes and powers the arm off.</source>
        <translation>Detiene los programas, aplica los frenos y apaga el brazo.</translation>
    </message>
    <message>
        <source>The arm is powered off.</source>
        <translation>El brazo está apagado.</translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation>Recuperar…</translation>
    </message>
    <message>
        <source>Shows the cause of the stop and the recovery steps.</source>
        <translation>Muestra qué detuvo el brazo y los pasos de recuperación.</translation>
    </message>
    <message>
        <source>The safety system reports no stop.</source>
        <translation>El sistema de seguridad no comunica ninguna parada.</translation>
    </message>
    <message>
        <source>Resets the safety system after a violation or fault. The arm stays powered off.</source>
        <translation>Restablece el sistema de seguridad tras una infracción o un fallo. El brazo sigue apagado.</translation>
    </message>
    <message>
        <source>Available only after a safety violation or fault.</source>
        <translation>Solo disponible tras una infracción o un fallo de seguridad.</translation>
    </message>
    <message>
        <source>Closes the popups on the teach pendant.</source>
        <translation>Cierra los avisos de la consola portátil.</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Tomar el control</translation>
    </message>
    <message>
        <source>Already in control.</source>
        <translation>Ya tiene el control.</translation>
    </message>
    <message>
        <source>Give control back</source>
        <translation>Devolver el control</translation>
    </message>
    <message>
        <source>Ends the control program on the robot.</source>
        <translation>Termina el programa de control en el robot.</translation>
    </message>
    <message>
        <source>Not in control.</source>
        <translation>Sin control.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Software stop of all motion. Not an emergency stop.</source>
        <translation>Parada por software de todo movimiento. No es una parada de emergencia.</translation>
    </message>
    <message>
        <source>Load program…</source>
        <translation>Cargar programa…</translation>
    </message>
    <message>
        <source>Loads a program on the robot by name.</source>
        <translation>Carga un programa del robot por su nombre.</translation>
    </message>
    <message>
        <source>Starts the loaded program or resumes the paused program. The arm may move immediately.</source>
        <translation>Inicia el programa cargado o reanuda uno en pausa: el brazo puede moverse de inmediato.</translation>
    </message>
    <message>
        <source>Pauses the running program.</source>
        <translation>Pausa el programa en ejecución.</translation>
    </message>
    <message>
        <source>Stops the program on the robot.</source>
        <translation>Detiene el programa del robot.</translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation>Inicia el programa de control en el robot. Pregunta antes de detener otro programa.</translation>
    </message>
    <message>
        <source>Checks the connection between this PC and the robot and suggests fixes.</source>
        <translation>Comprueba la conexión entre este PC y el robot y propone soluciones.</translation>
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
        <translation>Salida %1: %2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activada</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivada</translation>
    </message>
    <message>
        <source>%1: on</source>
        <translation>%1: activada</translation>
    </message>
    <message>
        <source>%1: off</source>
        <translation>%1: desactivada</translation>
    </message>
    <message>
        <source>Analog output %1: %2 %3</source>
        <translation>Salida analógica %1: %2 %3</translation>
    </message>
    <message>
        <source>Input int register %1</source>
        <translation>Registro de entrada entero %1</translation>
    </message>
    <message>
        <source>Speed slider: %1 %</source>
        <translation>Deslizador de velocidad: %1 %</translation>
    </message>
    <message>
        <source>%1: on for %2 s</source>
        <translation>%1: activada %2 s</translation>
    </message>
    <message>
        <source>%1: off for %2 s</source>
        <translation>%1: desactivada %2 s</translation>
    </message>
    <message>
        <source>The robot times pulses only while Tiller is in control. Take control first, or switch the output on and off manually.</source>
        <translation>El robot temporiza los impulsos solo mientras Tiller tiene el control. Tome primero el control, o active y desactive la salida manualmente.</translation>
    </message>
    <message>
        <source>The robot did not end the pulse on %1 because the program on the robot was stopped or paused. Tiller switches the output off.</source>
        <translation>El robot no terminó el impulso de %1 porque su programa se detuvo o quedó en pausa. Tiller desactiva la salida.</translation>
    </message>
    <message>
        <source>Input float register %1</source>
        <translation>Registro de entrada real %1</translation>
    </message>
    <message>
        <source>Input bit register %1</source>
        <translation>Registro de entrada de bit %1</translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation>Deslizador de velocidad</translation>
    </message>
    <message>
        <source>The robot cannot time pulses while a program is running. Stop the program first, or switch the output on and off manually.</source>
        <translation>El robot no puede temporizar impulsos mientras se ejecuta un programa. Detenga primero el programa, o conmute la salida manualmente.</translation>
    </message>
</context>
<context>
    <name>RobotServices</name>
    <message>
        <source>%1 failed. %2</source>
        <translation>%1 falló. %2</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Encender</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>Liberar frenos</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>Apagar</translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation>Reiniciar seguridad</translation>
    </message>
    <message>
        <source>Close popups</source>
        <translation>Cerrar avisos</translation>
    </message>
    <message>
        <source>Play program</source>
        <translation>Reproducir programa</translation>
    </message>
    <message>
        <source>Pause program</source>
        <translation>Pausar programa</translation>
    </message>
    <message>
        <source>Stop program</source>
        <translation>Detener programa</translation>
    </message>
    <message>
        <source>Protective stop unlocked by the operator</source>
        <translation>Parada de protección desbloqueada por el operador</translation>
    </message>
    <message>
        <source>Load program %1</source>
        <translation>Cargar programa %1</translation>
    </message>
    <message>
        <source>The program on the robot was stopped.</source>
        <translation>Se detuvo el programa del robot.</translation>
    </message>
    <message>
        <source>The program on the robot could not be stopped. Stop the program on the teach pendant. %1</source>
        <translation>No se pudo detener el programa del robot: deténgalo en la consola portátil. %1</translation>
    </message>
    <message>
        <source>The robot was switched to Local control: the motion was stopped and control was given back. Switch the robot to Remote control on the teach pendant, then take control again.</source>
        <translation>El robot se cambió a control local: se detuvo el movimiento y se devolvió el control. Cámbielo a control remoto en la consola portátil y tome de nuevo el control.</translation>
    </message>
    <message>
        <source>Unlock protective stop</source>
        <translation>Desbloquear la parada de protección</translation>
    </message>
    <message>
        <source>The robot sends no data, so a stop may not reach the robot. Press the emergency stop if the arm must stop.</source>
        <translation>El robot no envía datos, por lo que puede que una parada no le llegue. Pulse la parada de emergencia si el brazo debe pararse.</translation>
    </message>
</context>
<context>
    <name>RobotTooling</name>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller no tiene el control. Tome primero el control.</translation>
    </message>
    <message>
        <source>TCP and payload can be set only at standstill. Wait until the arm has stopped.</source>
        <translation>El TCP y la carga útil solo se pueden fijar en reposo. Espere a que el brazo se detenga.</translation>
    </message>
    <message>
        <source>TCP set on the robot: %1</source>
        <translation>TCP fijado en el robot: %1</translation>
    </message>
    <message>
        <source>Payload set on the robot: %1</source>
        <translation>Carga útil fijada en el robot: %1</translation>
    </message>
</context>
<context>
    <name>SampleProjects</name>
    <message>
        <source>Pick and place</source>
        <translation>Tomar y colocar</translation>
    </message>
    <message>
        <source>Picks a part from a feeder and places it in one of six tray cells. The cells are defined in the frame of the tray and move with it.</source>
        <translation>Toma una pieza de un alimentador y la coloca en una de seis celdas de una bandeja. Las celdas están definidas en el sistema de coordenadas de la bandeja y se mueven con él.</translation>
    </message>
    <message>
        <source>Gluing along a path</source>
        <translation>Encolado a lo largo de una trayectoria</translation>
    </message>
    <message>
        <source>Applies a bead around a lid with rounded corners in slow, straight moves. Blends keep the nozzle moving through the corners.</source>
        <translation>Aplica un cordón alrededor de una tapa con esquinas redondeadas en movimientos lentos y rectos. La fusión mantiene la boquilla en movimiento en las esquinas.</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Medición</translation>
    </message>
    <message>
        <source>A probe touches a part from above and from four sides. Each touch starts at an approach waypoint with the tool tilted.</source>
        <translation>Un palpador toca una pieza desde arriba y por cuatro lados. Cada toque comienza en un punto de aproximación con la herramienta inclinada.</translation>
    </message>
</context>
<context>
    <name>SceneActions</name>
    <message>
        <source>Default view (perspective)</source>
        <translation>Vista predeterminada (en perspectiva)</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Mirar desde el frente</translation>
    </message>
    <message>
        <source>Base X to the right, Z up.</source>
        <translation>X de la base a la derecha, Z arriba.</translation>
    </message>
    <message>
        <source>Look from the side</source>
        <translation>Mirar desde el lado</translation>
    </message>
    <message>
        <source>Base Y to the right, Z up.</source>
        <translation>Y de la base a la derecha, Z arriba.</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>Mirar desde arriba</translation>
    </message>
    <message>
        <source>Base X to the right, Y up.</source>
        <translation>X de la base a la derecha, Y arriba.</translation>
    </message>
    <message>
        <source>Fit everything in the view</source>
        <translation>Ajustar todo a la vista</translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view without changing the viewing direction.</source>
        <translation>Ajusta el brazo, el objetivo y los puntos de paso a la vista sin cambiar la dirección de la mirada.</translation>
    </message>
    <message>
        <source>Shows the arm diagonally from the front, slightly from above, and fits everything in the view.</source>
        <translation>Muestra el brazo en diagonal desde el frente, un poco desde arriba, y ajusta todo a la vista.</translation>
    </message>
</context>
<context>
    <name>SessionRecording</name>
    <message>
        <source>Cannot record: connect to a robot first.</source>
        <translation>No se puede grabar: conéctese primero a un robot.</translation>
    </message>
    <message>
        <source>Recording to %1</source>
        <translation>Grabando en %1</translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n rows to %1</source>
        <translation>
            <numerusform>%n fila grabada en %1</numerusform>
            <numerusform>%n filas grabadas en %1</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording continues without notes. %1</source>
        <translation>La grabación continúa sin notas. %1</translation>
    </message>
    <message>
        <source>Not recorded, because the robot does not accept a second connection: %1</source>
        <translation>No se graban porque el robot rechaza una segunda conexión para ellas: %1</translation>
    </message>
    <message numerus="yes">
        <source>The recording has gaps: %n packets are missing.</source>
        <translation>
            <numerusform>La grabación tiene huecos: falta %n paquete.</numerusform>
            <numerusform>La grabación tiene huecos: faltan %n paquetes.</numerusform>
        </translation>
    </message>
    <message>
        <source>The current recording does not contain %1. Start a new recording to record displayed signals.</source>
        <translation>La grabación actual no contiene %1. Inicie una grabación nueva para grabar las señales mostradas.</translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. These signals are not recorded: %1</source>
        <translation>El robot no puede enviar tantas señales a la vez. Señales que no se graban: %1</translation>
    </message>
    <message>
        <source>Waiting for the trigger %1 to record to %2</source>
        <translation>Esperando el disparador %1 para grabar en %2</translation>
    </message>
    <message>
        <source>The trigger has not occurred. No file was written.</source>
        <translation>El disparador no se ha producido. No se ha escrito ningún archivo.</translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n files; the last one is %1</source>
        <translation>
            <numerusform>%n archivo grabado; el último es %1</numerusform>
            <numerusform>%n archivos grabados; el último es %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SettingsFile</name>
    <message>
        <source>Invalid value for the setting “%1”.</source>
        <translation>Valor no válido para el ajuste «%1».</translation>
    </message>
    <message>
        <source>The file is too large for a settings file.</source>
        <translation>El archivo es demasiado grande para ser un archivo de ajustes.</translation>
    </message>
    <message>
        <source>The file is damaged at byte %1: %2.</source>
        <translation>El archivo está dañado en el byte %1: %2.</translation>
    </message>
    <message>
        <source>The file contains no Tiller settings.</source>
        <translation>El archivo no contiene ajustes de Tiller.</translation>
    </message>
    <message>
        <source>The file was written by a newer version of Tiller. Update Tiller to import the file.</source>
        <translation>El archivo se escribió con una versión más nueva de Tiller. Actualice Tiller para importarlo.</translation>
    </message>
    <message>
        <source>The file contains no version number.</source>
        <translation>El archivo no contiene número de versión.</translation>
    </message>
    <message>
        <source>The list of settings is missing or too long.</source>
        <translation>Falta la lista de ajustes o es demasiado larga.</translation>
    </message>
    <message>
        <source>“%1” is not a valid setting name.</source>
        <translation>«%1» no es un nombre de ajuste válido.</translation>
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
        <translation>Articulaciones</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Entradas y salidas</translation>
    </message>
    <message>
        <source>Modes and states</source>
        <translation>Modos y estados</translation>
    </message>
    <message>
        <source>Power and temperature</source>
        <translation>Potencia y temperatura</translation>
    </message>
    <message>
        <source>Speed and program</source>
        <translation>Velocidad y programa</translation>
    </message>
    <message>
        <source>Payload and tool</source>
        <translation>Carga útil y herramienta</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Otros</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Registros</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Fuerza en el TCP</translation>
    </message>
    <message>
        <source>TCP torque</source>
        <translation>Par en el TCP</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>Posición del TCP</translation>
    </message>
    <message>
        <source>TCP rotation vector</source>
        <translation>Vector de rotación del TCP</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>Velocidad del TCP</translation>
    </message>
    <message>
        <source>TCP angular speed</source>
        <translation>Velocidad de rotación del TCP</translation>
    </message>
    <message>
        <source>TCP acceleration</source>
        <translation>Aceleración del TCP</translation>
    </message>
    <message>
        <source>Target TCP position</source>
        <translation>Posición objetivo del TCP</translation>
    </message>
    <message>
        <source>Target TCP rotation vector</source>
        <translation>Vector de rotación objetivo del TCP</translation>
    </message>
    <message>
        <source>Target TCP speed</source>
        <translation>Velocidad objetivo del TCP</translation>
    </message>
    <message>
        <source>Target TCP angular speed</source>
        <translation>Velocidad de rotación objetivo del TCP</translation>
    </message>
    <message>
        <source>Raw sensor force</source>
        <translation>Fuerza bruta del sensor</translation>
    </message>
    <message>
        <source>Raw sensor torque</source>
        <translation>Par bruto del sensor</translation>
    </message>
    <message>
        <source>TCP force, norm</source>
        <translation>Fuerza en el TCP, norma</translation>
    </message>
    <message>
        <source>Tool accelerometer</source>
        <translation>Acelerómetro en la brida</translation>
    </message>
    <message>
        <source>Elbow position</source>
        <translation>Posición del codo</translation>
    </message>
    <message>
        <source>Elbow speed</source>
        <translation>Velocidad del codo</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Momento lineal</translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation>Posiciones articulares</translation>
    </message>
    <message>
        <source>Joint speeds</source>
        <translation>Velocidades articulares</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>Corrientes articulares</translation>
    </message>
    <message>
        <source>Joint temperatures</source>
        <translation>Temperaturas articulares</translation>
    </message>
    <message>
        <source>Joint voltages</source>
        <translation>Tensiones articulares</translation>
    </message>
    <message>
        <source>Target joint positions</source>
        <translation>Posiciones articulares objetivo</translation>
    </message>
    <message>
        <source>Target joint speeds</source>
        <translation>Velocidades articulares objetivo</translation>
    </message>
    <message>
        <source>Target joint accelerations</source>
        <translation>Aceleraciones articulares objetivo</translation>
    </message>
    <message>
        <source>Target joint currents</source>
        <translation>Corrientes articulares objetivo</translation>
    </message>
    <message>
        <source>Target joint torques</source>
        <translation>Pares articulares objetivo</translation>
    </message>
    <message>
        <source>Joint control currents</source>
        <translation>Corrientes de control articulares</translation>
    </message>
    <message>
        <source>Allowed current deviation</source>
        <translation>Desviación permitida de las corrientes</translation>
    </message>
    <message>
        <source>Position deviation, ratio to limit</source>
        <translation>Desviación de posición, proporción del límite</translation>
    </message>
    <message>
        <source>Collision detection, ratio to limit</source>
        <translation>Detección de colisión, proporción del límite</translation>
    </message>
    <message>
        <source>Joint modes</source>
        <translation>Modos articulares</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>Entradas digitales</translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation>Salidas digitales</translation>
    </message>
    <message>
        <source>Analog input 0</source>
        <translation>Entrada analógica 0</translation>
    </message>
    <message>
        <source>Analog input 1</source>
        <translation>Entrada analógica 1</translation>
    </message>
    <message>
        <source>Analog output 0</source>
        <translation>Salida analógica 0</translation>
    </message>
    <message>
        <source>Analog output 1</source>
        <translation>Salida analógica 1</translation>
    </message>
    <message>
        <source>Tool analog input 0</source>
        <translation>Entrada analógica de herramienta 0</translation>
    </message>
    <message>
        <source>Tool analog input 1</source>
        <translation>Entrada analógica de herramienta 1</translation>
    </message>
    <message>
        <source>Robot mode</source>
        <translation>Modo de robot</translation>
    </message>
    <message>
        <source>Safety mode</source>
        <translation>Modo de seguridad</translation>
    </message>
    <message>
        <source>Safety status</source>
        <translation>Estado de seguridad</translation>
    </message>
    <message>
        <source>Program state</source>
        <translation>Estado del programa</translation>
    </message>
    <message>
        <source>Robot status</source>
        <translation>Estado del robot</translation>
    </message>
    <message>
        <source>Safety bits</source>
        <translation>Bits de seguridad</translation>
    </message>
    <message>
        <source>Tool mode</source>
        <translation>Modo de herramienta</translation>
    </message>
    <message>
        <source>Main voltage</source>
        <translation>Tensión principal</translation>
    </message>
    <message>
        <source>Arm voltage</source>
        <translation>Tensión del brazo</translation>
    </message>
    <message>
        <source>Arm current</source>
        <translation>Corriente del brazo</translation>
    </message>
    <message>
        <source>I/O current</source>
        <translation>Corriente de las E/S</translation>
    </message>
    <message>
        <source>Tool temperature</source>
        <translation>Temperatura de herramienta</translation>
    </message>
    <message>
        <source>Tool voltage</source>
        <translation>Tensión de herramienta</translation>
    </message>
    <message>
        <source>Tool current</source>
        <translation>Corriente de herramienta</translation>
    </message>
    <message>
        <source>Speed scaling</source>
        <translation>Escala de velocidad</translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation>Deslizador de velocidad</translation>
    </message>
    <message>
        <source>Control step time</source>
        <translation>Tiempo de un paso de control</translation>
    </message>
    <message>
        <source>Script line</source>
        <translation>Línea del script</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>Tiempo del controlador</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Carga útil</translation>
    </message>
    <message>
        <source>Payload centre of gravity</source>
        <translation>Centro de gravedad de la carga útil</translation>
    </message>
    <message>
        <source>TCP offset</source>
        <translation>Desplazamiento del TCP</translation>
    </message>
    <message>
        <source>TCP rotation</source>
        <translation>Rotación del TCP</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Encender</translation>
    </message>
    <message>
        <source>Program running</source>
        <translation>Programa en ejecución</translation>
    </message>
    <message>
        <source>Freedrive button</source>
        <translation>Botón de movimiento libre</translation>
    </message>
    <message>
        <source>Power button</source>
        <translation>Botón de encendido</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reducido</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>Parada de protección</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Recuperación</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>Parada de salvaguarda</translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation>Parada de emergencia del sistema</translation>
    </message>
    <message>
        <source>Robot emergency stop</source>
        <translation>Parada de emergencia del robot</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Parada de emergencia</translation>
    </message>
    <message>
        <source>Violation</source>
        <translation>Infracción</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fallo</translation>
    </message>
    <message>
        <source>Enabling device</source>
        <translation>Dispositivo de habilitación</translation>
    </message>
    <message>
        <source>Bit %1</source>
        <translation>Bit %1</translation>
    </message>
    <message>
        <source>Output registers, floats</source>
        <translation>Registros de salida, reales</translation>
    </message>
    <message>
        <source>Input registers, floats</source>
        <translation>Registros de entrada, reales</translation>
    </message>
    <message>
        <source>Output registers, integers</source>
        <translation>Registros de salida, enteros</translation>
    </message>
    <message>
        <source>Input registers, integers</source>
        <translation>Registros de entrada, enteros</translation>
    </message>
    <message>
        <source>Output registers, bits</source>
        <translation>Registros de salida, bits</translation>
    </message>
    <message>
        <source>Input registers, bits</source>
        <translation>Registros de entrada, bits</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activada</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivada</translation>
    </message>
    <message>
        <source>Stopped due to safety</source>
        <translation>Detenido por seguridad</translation>
    </message>
</context>
<context>
    <name>SpaceMouse</name>
    <message>
        <source>left button</source>
        <translation>botón izquierdo</translation>
    </message>
    <message>
        <source>The tool follows the motion of the cap.</source>
        <translation>La herramienta sigue el movimiento del mando.</translation>
    </message>
</context>
<context>
    <name>Spectrum</name>
    <message>
        <source>compute a spectrum</source>
        <translation>calcular un espectro</translation>
    </message>
    <message>
        <source>The range contains fewer than %1 samples. Select a longer range.</source>
        <translation>Hay menos de %1 muestras: elija un intervalo más largo.</translation>
    </message>
    <message>
        <source>Values are missing in this range. Select a range without gaps.</source>
        <translation>Faltan valores en este intervalo: seleccione un intervalo sin huecos.</translation>
    </message>
    <message>
        <source>Not enough memory. Select a shorter range.</source>
        <translation>Memoria insuficiente: seleccione un intervalo más corto.</translation>
    </message>
</context>
<context>
    <name>StartProject</name>
    <message>
        <source>The last project no longer exists: %1</source>
        <translation>El último proyecto ya no existe: %1</translation>
    </message>
</context>
<context>
    <name>StateLane</name>
    <message>
        <source>Protective stop</source>
        <translation>Parada de protección</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Recuperación</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>Parada de salvaguarda</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Parada de emergencia</translation>
    </message>
    <message>
        <source>Enabling device released</source>
        <translation>Dispositivo de habilitación suelto</translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation>Infracción de seguridad</translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation>Fallo de seguridad</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Detenido</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>Apagado</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Arrancando</translation>
    </message>
    <message>
        <source>Brakes on</source>
        <translation>Frenos puestos</translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation>Backdrive</translation>
    </message>
    <message>
        <source>Not running</source>
        <translation>No está en marcha</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Sin datos</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>Movimiento libre</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>En movimiento</translation>
    </message>
    <message>
        <source>At standstill</source>
        <translation>En reposo</translation>
    </message>
    <message>
        <source>Late data</source>
        <translation>Datos con retraso</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Enter an IP address, such as 192.168.0.10, or a host name.</source>
        <translation>Introduzca una dirección IP, p. ej. 192.168.0.10, o un nombre de host.</translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and this PC is on the same network.</source>
        <translation>Compruebe que el robot está encendido, que el cable está conectado y que este PC está en la misma red.</translation>
    </message>
    <message>
        <source>Enable the interface on the robot under Settings &gt; Security &gt; Services. A robot that has just started may need another minute.</source>
        <translation>Active la interfaz en el robot en Ajustes &gt; Seguridad &gt; Servicios. Un robot recién arrancado puede necesitar un minuto más.</translation>
    </message>
    <message>
        <source>The robot may be restarting or switching between Local and Remote control. Wait a minute, then connect again.</source>
        <translation>Puede estar reiniciándose o cambiando entre Local y Remoto. Espere un minuto y conecte de nuevo.</translation>
    </message>
    <message>
        <source>The robot does not respond. Check the cable and the address.</source>
        <translation>El robot no responde. Compruebe el cable y la dirección.</translation>
    </message>
    <message>
        <source>No more data received. Check the cable. Tiller reconnects automatically; motion does not resume.</source>
        <translation>No se reciben más datos. Compruebe el cable. Tiller se reconecta automáticamente; el movimiento no se reanuda.</translation>
    </message>
    <message>
        <source>The response is not valid for this protocol. Check the address and the port.</source>
        <translation>La respuesta no cumple el protocolo. Compruebe la dirección y el puerto.</translation>
    </message>
    <message>
        <source>If newer software is available for this robot, update the robot.</source>
        <translation>Si hay un software más reciente para este robot, actualice el robot.</translation>
    </message>
    <message>
        <source>The robot&apos;s software does not provide this value.</source>
        <translation>El software del robot no ofrece este valor.</translation>
    </message>
    <message>
        <source>Another program or a fieldbus on the robot uses these registers. Close the other program, or disable the fieldbus in the installation.</source>
        <translation>Otro programa o un bus de campo del robot usa estos registros: cierre el otro programa o desactive el bus de campo en la instalación.</translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation>Conéctese primero a un robot.</translation>
    </message>
    <message>
        <source>Take control first.</source>
        <translation>Tome primero el control.</translation>
    </message>
    <message>
        <source>Power on the arm, release the brakes and clear any safety stop first.</source>
        <translation>Encienda primero el brazo, libere los frenos y anule cualquier parada de seguridad.</translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant.</source>
        <translation>Cambie el robot a control remoto en la consola portátil, arriba a la derecha.</translation>
    </message>
    <message>
        <source>Choose a target within the reach of the arm and a speed below the speed cap.</source>
        <translation>Elija un objetivo dentro del alcance del brazo y una velocidad dentro del límite.</translation>
    </message>
    <message>
        <source>The arm cannot reach this pose. Move the target closer or rotate the tool.</source>
        <translation>El brazo no puede alcanzar esta pose: acerque el punto o gire la herramienta.</translation>
    </message>
    <message>
        <source>The robot could not run the program. See the log for the controller&apos;s message.</source>
        <translation>El robot no pudo ejecutar el programa. El mensaje del controlador está en el registro.</translation>
    </message>
    <message>
        <source>Check that the file exists and that you have permission to read it.</source>
        <translation>Compruebe que el archivo existe y que tiene permiso para leerlo.</translation>
    </message>
    <message>
        <source>Choose a folder that you have permission to write to.</source>
        <translation>Elija una carpeta en la que tenga permiso para escribir.</translation>
    </message>
    <message>
        <source>The file was not changed. Open a backup, or repair the file at the reported position.</source>
        <translation>El archivo no se modificó. Abra una copia de seguridad o repare la posición indicada.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Hecho</translation>
    </message>
    <message>
        <source>Address not found</source>
        <translation>Dirección no encontrada</translation>
    </message>
    <message>
        <source>Robot not reachable</source>
        <translation>Robot inaccesible</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>Conexión rechazada</translation>
    </message>
    <message>
        <source>Connection closed by the robot</source>
        <translation>Conexión terminada por el robot</translation>
    </message>
    <message>
        <source>Timed out</source>
        <translation>Tiempo agotado</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Cancelado</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>Enlace perdido</translation>
    </message>
    <message>
        <source>Protocol error</source>
        <translation>Error de protocolo</translation>
    </message>
    <message>
        <source>Not supported by this robot</source>
        <translation>No admitido por este robot</translation>
    </message>
    <message>
        <source>Value not available</source>
        <translation>Valor no disponible</translation>
    </message>
    <message>
        <source>Registers in use</source>
        <translation>Registros ocupados</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Sin conexión</translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation>Sin control</translation>
    </message>
    <message>
        <source>Robot not ready</source>
        <translation>Robot no preparado</translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation>El robot está en control local</translation>
    </message>
    <message>
        <source>Outside the limits</source>
        <translation>Fuera de los límites</translation>
    </message>
    <message>
        <source>Invalid value</source>
        <translation>Valor no válido</translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation>Fuera de alcance</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Detenido</translation>
    </message>
    <message>
        <source>Refused by the robot</source>
        <translation>Rechazado por el robot</translation>
    </message>
    <message>
        <source>Program error on the robot</source>
        <translation>Error de programa en el robot</translation>
    </message>
    <message>
        <source>Cannot read the file</source>
        <translation>No se puede leer el archivo</translation>
    </message>
    <message>
        <source>Cannot write the file</source>
        <translation>No se puede escribir el archivo</translation>
    </message>
    <message>
        <source>File is damaged</source>
        <translation>El archivo está dañado</translation>
    </message>
    <message>
        <source>Disk full</source>
        <translation>Disco lleno</translation>
    </message>
    <message>
        <source>Internal error</source>
        <translation>Error interno</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>terminado</translation>
    </message>
    <message>
        <source>button or key released</source>
        <translation>se soltó el botón o la tecla</translation>
    </message>
    <message>
        <source>pointer left the button</source>
        <translation>el puntero salió del botón</translation>
    </message>
    <message>
        <source>focus lost</source>
        <translation>foco perdido</translation>
    </message>
    <message>
        <source>another window became active</source>
        <translation>otra ventana se activó</translation>
    </message>
    <message>
        <source>window closed</source>
        <translation>ventana cerrada</translation>
    </message>
    <message>
        <source>a dialog or menu opened</source>
        <translation>se abrió un diálogo o menú</translation>
    </message>
    <message>
        <source>another button or key pressed</source>
        <translation>otro botón o tecla pulsado</translation>
    </message>
    <message>
        <source>Esc pressed</source>
        <translation>Esc pulsada</translation>
    </message>
    <message>
        <source>Space pressed</source>
        <translation>Espacio pulsado</translation>
    </message>
    <message>
        <source>STOP pressed</source>
        <translation>STOP pulsado</translation>
    </message>
    <message>
        <source>input device lost</source>
        <translation>dispositivo de entrada perdido</translation>
    </message>
    <message>
        <source>robot data arrived too late</source>
        <translation>datos del robot demasiado viejos</translation>
    </message>
    <message>
        <source>robot or safety mode changed</source>
        <translation>cambió el modo del robot o de seguridad</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>enlace perdido</translation>
    </message>
    <message>
        <source>limit reached</source>
        <translation>límite alcanzado</translation>
    </message>
    <message>
        <source>control lost</source>
        <translation>control perdido</translation>
    </message>
    <message>
        <source>target reached</source>
        <translation>objetivo alcanzado</translation>
    </message>
    <message>
        <source>stopped by a program</source>
        <translation>detenido por un programa</translation>
    </message>
    <message>
        <source>contact detected</source>
        <translation>contacto detectado</translation>
    </message>
    <message>
        <source>target cannot be reached</source>
        <translation>objetivo inalcanzable</translation>
    </message>
    <message>
        <source>could not verify that the button or key is still pressed</source>
        <translation>no se pudo comprobar que el botón o la tecla sigue pulsado</translation>
    </message>
    <message>
        <source>maximum hold time reached; press again</source>
        <translation>tiempo máximo de pulsación alcanzado; pulse de nuevo</translation>
    </message>
    <message>
        <source>PolyScope X before 10.11 does not accept these commands over the network. Use the teach pendant.</source>
        <translation>PolyScope X anterior a 10.11 no acepta estas órdenes por la red: use la consola portátil.</translation>
    </message>
    <message>
        <source>PolyScope X cannot close popups over the network. Use the teach pendant.</source>
        <translation>PolyScope X no puede cerrar ventanas emergentes por la red: use la consola portátil.</translation>
    </message>
    <message>
        <source>Monitoring. Take control to move the arm.</source>
        <translation>Observando. Tome el control para mover el brazo.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Tomando el control…</translation>
    </message>
    <message>
        <source>Control was given back. Take control to move the arm.</source>
        <translation>El control se devolvió. Tome el control para mover el brazo.</translation>
    </message>
    <message>
        <source>The control program on the robot was stopped. Take control again.</source>
        <translation>El programa de control se detuvo en el robot. Tome de nuevo el control.</translation>
    </message>
    <message>
        <source>The control program was replaced or does not respond. Take control again.</source>
        <translation>El programa de control fue sustituido o no responde. Tome de nuevo el control.</translation>
    </message>
    <message>
        <source>The connection was lost. Take control again.</source>
        <translation>Se perdió la conexión. Tome de nuevo el control.</translation>
    </message>
    <message>
        <source>Your script is running. Tiller regains control when the script ends.</source>
        <translation>Su script está en ejecución. Tiller recupera el control cuando termine.</translation>
    </message>
    <message>
        <source>Free some space on the disk, then save or record again.</source>
        <translation>Libere espacio en el disco y vuelva a guardar o grabar.</translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. Turn off “Monitor only” in Settings, or start Tiller without --monitor-only.</source>
        <translation>Solo supervisión: esta ventana no cambia nada en el robot. Desactive «Solo supervisión» en los ajustes o inicie Tiller sin --monitor-only.</translation>
    </message>
    <message>
        <source>No current data from the robot. Check the network connection to the robot.</source>
        <translation>No llegan datos actuales del robot. Compruebe la conexión de red con el robot.</translation>
    </message>
    <message>
        <source>selection or modifier key changed</source>
        <translation>cambió la selección o una tecla modificadora</translation>
    </message>
    <message>
        <source>the window did not respond</source>
        <translation>la ventana no respondía</translation>
    </message>
    <message>
        <source>not measured: no data during the stop</source>
        <translation>no medido: sin datos durante la parada</translation>
    </message>
    <message>
        <source>not measured: another program is moving the arm</source>
        <translation>no medido: otro programa mueve el brazo</translation>
    </message>
    <message>
        <source>the PC is going to sleep</source>
        <translation>el PC entra en suspensión</translation>
    </message>
    <message>
        <source>the robot did not receive the stop command</source>
        <translation>el robot no ha recibido la orden de parada</translation>
    </message>
    <message>
        <source>servo target too far from the previous target</source>
        <translation>objetivo servo demasiado lejos del anterior</translation>
    </message>
</context>
<context>
    <name>WaypointClipboard</name>
    <message>
        <source>the value is missing</source>
        <translation>falta el valor</translation>
    </message>
    <message>
        <source>“%1” is not a number</source>
        <translation>«%1» no es un número</translation>
    </message>
    <message>
        <source>%1 is outside the range %2 to %3</source>
        <translation>%1 está fuera de %2 a %3</translation>
    </message>
    <message>
        <source>Line %1, column “%2”: %3.</source>
        <translation>Línea %1, columna «%2»: %3.</translation>
    </message>
    <message>
        <source>“%1” must be “J” or “L”</source>
        <translation>«%1» debe ser «J» o «L»</translation>
    </message>
    <message>
        <source>“%1” must be “joints” or “pose”</source>
        <translation>«%1» debe ser «joints» o «pose»</translation>
    </message>
    <message>
        <source>the project has no frame named “%1”</source>
        <translation>en este proyecto no hay sistema «%1»</translation>
    </message>
    <message>
        <source>The text is not a table of waypoints. Copy a waypoint from the list to see the columns, or use the six values of a pose.</source>
        <translation>Esto no es una tabla de puntos de paso. Copie un punto de la lista para ver las columnas, o pegue los seis valores de una pose.</translation>
    </message>
    <message>
        <source>“%1” is not a waypoint colour (none, blue, orange, green, pink, yellow or sky)</source>
        <translation>«%1» no es un color de punto de paso (none, blue, orange, green, pink, yellow o sky)</translation>
    </message>
</context>
<context>
    <name>WaypointExchange</name>
    <message>
        <source>Line %1: the closing quotation mark is missing.</source>
        <translation>Línea %1: falta la comilla de cierre.</translation>
    </message>
</context>
<context>
    <name>tiller::ActionsDialog</name>
    <message>
        <source>Actions at “%1”</source>
        <translation>Acciones en «%1»</translation>
    </message>
    <message numerus="yes">
        <source>Actions at %n waypoints</source>
        <translation>
            <numerusform>Acciones en %n punto de paso</numerusform>
            <numerusform>Acciones en %n puntos de paso</numerusform>
        </translation>
    </message>
    <message>
        <source>“Run route (hold)” runs these actions in order at the waypoint while the button is held.</source>
        <translation>Las acciones se ejecutan en este orden cuando «Ruta» llega al punto de paso y se mantiene el botón.</translation>
    </message>
    <message>
        <source>These waypoints have different actions. “Apply” replaces them all with the actions below.</source>
        <translation>Estos puntos de paso tienen acciones diferentes. «Aplicar» las sustituye todas por las acciones de abajo.</translation>
    </message>
    <message>
        <source>Actions in order</source>
        <translation>Acciones en orden</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove the selected action</source>
        <translation>Quitar la acción seleccionada</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Subir</translation>
    </message>
    <message>
        <source>Move the selected action up</source>
        <translation>Subir la acción seleccionada</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Bajar</translation>
    </message>
    <message>
        <source>Move the selected action down</source>
        <translation>Bajar la acción seleccionada</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Terminal</source>
        <translation>Borne</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivada</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activada</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>Tiempo límite</translation>
    </message>
    <message>
        <source>After this time, the action fails with a message. With 0, the action waits while the button is held, up to one hour.</source>
        <translation>Después de este tiempo, la espera falla con un mensaje. 0: espera mientras se mantiene el botón, una hora como máximo.</translation>
    </message>
    <message>
        <source>Add an action after the selected action</source>
        <translation>Añadir una acción después de la seleccionada</translation>
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
        <translation>%1 rango</translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation>%1 valor</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>Fijar %1</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renombrar…</translation>
    </message>
    <message>
        <source>Scale…</source>
        <translation>Escalar…</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Nombre de %1</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Escala de %1</translation>
    </message>
    <message>
        <source>e.g. bar; empty: no scaling</source>
        <translation>p. ej. bar; vacío: sin escala</translation>
    </message>
    <message>
        <source>At 4 mA or 0 V</source>
        <translation>Con 4 mA o 0 V</translation>
    </message>
    <message>
        <source>At 20 mA or 10 V</source>
        <translation>Con 20 mA o 10 V</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>%1: %2
To rename or scale the signal, right-click it, or press F2 or Shift+F2.</source>
        <translation>%1: %2
F2 para renombrar, Mayús+F2 para escalar, o clic derecho.</translation>
    </message>
</context>
<context>
    <name>tiller::ArmKey</name>
    <message>
        <source>Keyboard armed</source>
        <translation>Teclado armado</translation>
    </message>
    <message>
        <source>Arm keyboard</source>
        <translation>Armar teclado</translation>
    </message>
    <message>
        <source>While the keyboard is armed, holding an arrow key moves the arm. A border around the window shows that the keyboard is armed.</source>
        <translation>Con el teclado armado, las flechas mueven el brazo mientras se mantienen pulsadas. Un marco alrededor de la ventana indica que el teclado está armado.</translation>
    </message>
    <message>
        <source>Arrow keys move along X and Y, PgUp and PgDn along Z; with Alt, they rotate the tool. Hold 1 to 6 and press + or − to move a joint. Space and Esc stop the arm. To disarm the keyboard, click this button or wait 30 s.</source>
        <translation>Las flechas mueven X e Y, RePág y AvPág mueven Z; con Alt giran. 1 a 6 con + y − mueven una articulación. Espacio y Esc detienen. Para desarmar, haga clic o espere 30 s.</translation>
    </message>
</context>
<context>
    <name>tiller::CellPage</name>
    <message>
        <source>Size %1</source>
        <translation>Tamaño %1</translation>
    </message>
    <message>
        <source>Shown and checked for collisions</source>
        <translation>Se muestra y se comprueba si hay colisiones</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>Enter a name for the box or plane.</source>
        <translation>Introduzca un nombre para la caja o el plano.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renombrar «%1» a «%2»</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Celda</translation>
    </message>
    <message>
        <source>No boxes or planes yet.
Move the TCP to a corner of an obstacle and press “Teach corner”.</source>
        <translation>Aún no hay cajas ni planos.
Mueva el TCP a una esquina de un obstáculo y pulse «Esquina aquí».</translation>
    </message>
    <message>
        <source>Check for collisions</source>
        <translation>Comprobar colisiones</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centro</translation>
    </message>
    <message>
        <source>Centre of the box. Press Return to apply the values. Only the box changes; the robot does not move.</source>
        <translation>Centro de la caja. Pulse Intro para aplicar. Solo cambia la caja; el robot no se mueve.</translation>
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
        <translation>caja</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>Añadir «%1»</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>plano</translation>
    </message>
    <message>
        <source>First corner recorded</source>
        <translation>Primera esquina tomada</translation>
    </message>
    <message>
        <source>Move the TCP to the opposite corner and press “Teach corner 2”.</source>
        <translation>Mueva el TCP a la esquina opuesta y pulse «Otra esquina».</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>The corners must differ by at least 1 mm along X, Y and Z. Move the TCP to the opposite corner of the box.</source>
        <translation>Las esquinas deben diferir al menos 1 mm en X, Y y Z. Mueva el TCP a la esquina opuesta de la caja.</translation>
    </message>
    <message>
        <source>Move “%1”</source>
        <translation>Mover «%1»</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Duplicar «%1»</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>Eliminar «%1»</translation>
    </message>
    <message>
        <source>Set the floor</source>
        <translation>Definir el suelo</translation>
    </message>
    <message>
        <source>Remove the floor</source>
        <translation>Quitar el suelo</translation>
    </message>
    <message>
        <source>Change the safety distance</source>
        <translation>Cambiar la distancia de seguridad</translation>
    </message>
    <message>
        <source>Teach corner 2</source>
        <translation>Otra esquina</translation>
    </message>
    <message>
        <source>Teach corner</source>
        <translation>Esquina aquí</translation>
    </message>
    <message>
        <source>%1 · %2 in %3</source>
        <translation>%1 · %2 en %3</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Length along X</source>
        <translation>Longitud según X</translation>
    </message>
    <message>
        <source>Length along Y</source>
        <translation>Longitud según Y</translation>
    </message>
    <message>
        <source>Length along Z</source>
        <translation>Longitud según Z</translation>
    </message>
    <message>
        <source>Point on the plane, X</source>
        <translation>Punto del plano, X</translation>
    </message>
    <message>
        <source>Point on the plane, Y</source>
        <translation>Punto del plano, Y</translation>
    </message>
    <message>
        <source>Point on the plane, Z</source>
        <translation>Punto del plano, Z</translation>
    </message>
    <message>
        <source>Normal X, towards the arm</source>
        <translation>Normal X, hacia el brazo</translation>
    </message>
    <message>
        <source>Normal Y, towards the arm</source>
        <translation>Normal Y, hacia el brazo</translation>
    </message>
    <message>
        <source>Normal Z, towards the arm</source>
        <translation>Normal Z, hacia el brazo</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>When off, the box or plane is neither shown nor checked for collisions.</source>
        <translation>Desactivado, la caja o el plano no se muestra ni se comprueba si hay colisiones.</translation>
    </message>
    <message>
        <source>Horizontal plane in the base frame that the arm must stay above.</source>
        <translation>Plano horizontal en el sistema de la base, por encima del cual debe quedar el brazo.</translation>
    </message>
    <message>
        <source>Floor height</source>
        <translation>Altura del suelo</translation>
    </message>
    <message>
        <source>Safety distance</source>
        <translation>Distancia de seguridad</translation>
    </message>
    <message>
        <source>Jogging stops at this distance from objects in the cell and between parts of the arm. Moves that would bring the arm closer are refused.</source>
        <translation>El movimiento manual se detiene a esta distancia de los objetos de la celda y entre partes del brazo. Los movimientos que se acercan más se rechazan.</translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation>En el TCP</translation>
    </message>
    <message>
        <source>Set the floor to the TCP height</source>
        <translation>Poner el suelo a la altura del TCP</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Teach a box corner at the TCP</source>
        <translation>Poner una esquina de una caja en el TCP</translation>
    </message>
    <message>
        <source>Teach plane</source>
        <translation>Plano aquí</translation>
    </message>
    <message>
        <source>Add a plane through the TCP, perpendicular to the tool</source>
        <translation>Añadir un plano por el TCP, perpendicular a la herramienta</translation>
    </message>
    <message>
        <source>New box</source>
        <translation>Nueva caja</translation>
    </message>
    <message>
        <source>Add a box numerically</source>
        <translation>Añadir una caja con valores</translation>
    </message>
    <message>
        <source>Add a plane through the TCP</source>
        <translation>Añadir un plano por el TCP</translation>
    </message>
    <message>
        <source>Add a plane numerically</source>
        <translation>Añadir un plano con valores</translation>
    </message>
    <message>
        <source>Move the box or plane to the TCP</source>
        <translation>Mover la caja o el plano al TCP</translation>
    </message>
    <message>
        <source>Rename box or plane</source>
        <translation>Renombrar la caja o el plano</translation>
    </message>
    <message>
        <source>Duplicate box or plane</source>
        <translation>Duplicar la caja o el plano</translation>
    </message>
    <message>
        <source>Delete box or plane</source>
        <translation>Eliminar la caja o el plano</translation>
    </message>
    <message>
        <source>Resize “%1”</source>
        <translation>Cambiar el tamaño de «%1»</translation>
    </message>
    <message>
        <source>The normal must not be zero. Enter at least one nonzero component.</source>
        <translation>La normal no puede ser cero. Introduzca primero una componente.</translation>
    </message>
    <message>
        <source>Rotate “%1”</source>
        <translation>Girar «%1»</translation>
    </message>
    <message>
        <source>missing frame</source>
        <translation>falta el sistema de coordenadas</translation>
    </message>
    <message>
        <source>Turn on the collision check of “%1”</source>
        <translation>Activar la comprobación de colisiones de «%1»</translation>
    </message>
    <message>
        <source>Turn off the collision check of “%1”</source>
        <translation>Desactivar la comprobación de colisiones de «%1»</translation>
    </message>
    <message>
        <source>Turn collision check on or off</source>
        <translation>Activar o desactivar la comprobación de colisiones</translation>
    </message>
    <message>
        <source>The cell already contains “%1”. Choose a different name.</source>
        <translation>La celda ya contiene «%1». Elija otro nombre.</translation>
    </message>
</context>
<context>
    <name>tiller::ChecklistItem</name>
    <message>
        <source>done</source>
        <translation>hecho</translation>
    </message>
    <message>
        <source>not done yet</source>
        <translation>aún no hecho</translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonBand</name>
    <message>
        <source>Comparison with the arm model</source>
        <translation>Comparación con el modelo del brazo</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Comparar…</translation>
    </message>
    <message>
        <source>Compare this recording with the arm model using different limits</source>
        <translation>Comparar esta grabación con el modelo del brazo usando otros límites</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Go to time</source>
        <translation>Ir allí</translation>
    </message>
    <message>
        <source>Cancel the comparison</source>
        <translation>Cancelar la comparación</translation>
    </message>
    <message>
        <source>Place cursor A where the arm and the model diverge</source>
        <translation>Colocar el cursor A donde difieren brazo y modelo</translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonDialog</name>
    <message>
        <source>Compare with the arm model</source>
        <translation>Comparar con el modelo del brazo</translation>
    </message>
    <message>
        <source>The simulated arm follows the recorded joint targets, and its motion is compared with the recorded motion. The model includes neither contact nor friction.</source>
        <translation>El brazo simulado sigue las consignas articulares grabadas y su movimiento se compara con el grabado. El modelo no incluye ni contacto ni fricción.</translation>
    </message>
    <message>
        <source>Arm model</source>
        <translation>Modelo del brazo</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Brazo</translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation>Posiciones de las articulaciones</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>Posición del TCP</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>Corrientes de las articulaciones</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Fuerza en el TCP</translation>
    </message>
    <message>
        <source>Signals with a limit of 0 are not compared.</source>
        <translation>Las señales con límite 0 no se comparan.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Minimum duration</source>
        <translation>Duración mínima</translation>
    </message>
</context>
<context>
    <name>tiller::CurveDialog</name>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Desplazamiento</translation>
    </message>
    <message>
        <source>Displayed value = value × scale + offset</source>
        <translation>Valor mostrado = valor × escala + desplazamiento</translation>
    </message>
    <message>
        <source>Choose the colour</source>
        <translation>Elegir el color</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Automatic colour</source>
        <translation>Color automático</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Continua</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Discontinua</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Punteada</translation>
    </message>
    <message>
        <source>Value axis</source>
        <translation>Eje de valores</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Introduzca un nombre.</translation>
    </message>
    <message>
        <source>Name and unit cannot contain = [ ].</source>
        <translation>El nombre y la unidad no pueden contener = [ ].</translation>
    </message>
    <message>
        <source>Enter a number other than 0 as the scale.</source>
        <translation>Introduzca como escala un número distinto de 0.</translation>
    </message>
    <message>
        <source>Enter a number as the offset.</source>
        <translation>Introduzca un número como desplazamiento.</translation>
    </message>
</context>
<context>
    <name>tiller::DecimalSpinBox</name>
    <message>
        <source>“%1” is out of range (%2 to %3). The value is still %4.</source>
        <translation>«%1» está fuera del rango (%2 a %3). El valor sigue siendo %4.</translation>
    </message>
</context>
<context>
    <name>tiller::DeviceTrainer</name>
    <message>
        <source>Enable motion (until Tiller is closed)</source>
        <translation>Permitir movimiento (hasta cerrar Tiller)</translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation>Solo el eje dominante</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation>Gamepad y SpaceMouse</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Dispositivo</translation>
    </message>
    <message>
        <source>Direction in which the arm would move</source>
        <translation>Dirección en la que se movería el brazo</translation>
    </message>
    <message>
        <source>Hold-to-run</source>
        <translation>Habilitación</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation>No se encontró ningún mando ni SpaceMouse. Conecte uno; se detecta automáticamente.</translation>
    </message>
    <message>
        <source>● held (%1)</source>
        <translation>● mantenido (%1)</translation>
    </message>
    <message>
        <source>○ not held: hold the %1</source>
        <translation>○ no mantenido: mantenga %1</translation>
    </message>
    <message>
        <source>none (neutral)</source>
        <translation>ninguno (neutro)</translation>
    </message>
    <message>
        <source>With the keyboard armed (Ctrl+J): arrow keys for X and Y; PgUp and PgDn for Z; Alt with these keys for rotation; 1 to 6 with + and − for joints; Home for the home position; End to align; Backspace to move back; F for Freedrive; Ctrl for slower; Shift for faster. Space and Esc stop the arm.</source>
        <translation>Teclado armado (Ctrl+J): flechas: X e Y; RePág, AvPág: Z; con Alt: giro; 1 a 6 con + y −: articulaciones; Inicio: a inicio; Fin: alinear; Retroceso: atrás; F: movimiento libre; Ctrl: más lento; Mayús: más rápido. Espacio y Esc detienen.</translation>
    </message>
</context>
<context>
    <name>tiller::EmptyState</name>
    <message>
        <source>Nothing found</source>
        <translation>Nada encontrado</translation>
    </message>
    <message>
        <source>Nothing found with these filters.</source>
        <translation>Nada encontrado con estos filtros.</translation>
    </message>
    <message>
        <source>Nothing found for “%1”.
Clear the search to see everything.</source>
        <translation>Nada encontrado para «%1».
Vacíe la búsqueda para verlo todo.</translation>
    </message>
</context>
<context>
    <name>tiller::FirstSteps</name>
    <message>
        <source>Power on (header)</source>
        <translation>Encender (cabecera)</translation>
    </message>
    <message>
        <source>Release brakes (header)</source>
        <translation>Liberar frenos (cabecera)</translation>
    </message>
    <message>
        <source>Take control and hold a jog button</source>
        <translation>Tomar el control, mantener un botón</translation>
    </message>
    <message>
        <source>Teach here (T)</source>
        <translation>Enseñar aquí (T)</translation>
    </message>
    <message>
        <source>Jog away and hold “Go to” (G)</source>
        <translation>Alejarse, mantener Ir a (G)</translation>
    </message>
    <message>
        <source>Record (above the plots)</source>
        <translation>Grabar (sobre los gráficos)</translation>
    </message>
</context>
<context>
    <name>tiller::FirstStepsCard</name>
    <message>
        <source>First steps</source>
        <translation>Primeros pasos</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>Ejercicios</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>The list will not appear again. Use the command “First steps” to reopen it.</source>
        <translation>La lista no volverá a aparecer. Use la orden «Primeros pasos» para abrirla de nuevo.</translation>
    </message>
    <message>
        <source>First steps · %1 of %2</source>
        <translation>Primeros pasos · %1 de %2</translation>
    </message>
</context>
<context>
    <name>tiller::FrameDetails</name>
    <message>
        <source>Selected frame</source>
        <translation>Sistema seleccionado</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>In the base frame. Press Return to apply the values. Only the frame changes; the robot does not move.</source>
        <translation>En el sistema de la base. Pulse Intro para aplicar. Solo cambia el sistema de coordenadas; el robot no se mueve.</translation>
    </message>
    <message>
        <source>not used by any waypoint</source>
        <translation>ningún punto de paso lo usa</translation>
    </message>
    <message numerus="yes">
        <source>used by %n waypoints</source>
        <translation>
            <numerusform>usado por %n punto de paso</numerusform>
            <numerusform>usado por %n puntos de paso</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the TCP</source>
        <translation>a %1 del TCP</translation>
    </message>
</context>
<context>
    <name>tiller::FrameEditing</name>
    <message>
        <source>No waypoints moved with the frame.</source>
        <translation>Ningún punto de paso se movió con él.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints moved with the frame.</source>
        <translation>
            <numerusform>%n punto de paso se movió con él.</numerusform>
            <numerusform>%n puntos de paso se movieron con él.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Waypoints out of reach: %n.</source>
        <translation>
            <numerusform>Puntos de paso fuera de alcance: %n.</numerusform>
            <numerusform>Puntos de paso fuera de alcance: %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>frame</source>
        <translation>sistema</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>Enseñar «%1»</translation>
    </message>
    <message>
        <source>The frame moves by %1 (%2, base frame).</source>
        <translation>El sistema de coordenadas se mueve %1 (%2, base).</translation>
    </message>
    <message>
        <source>No waypoint uses this frame.</source>
        <translation>Ningún punto de paso usa este sistema de coordenadas.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints move with the frame.</source>
        <translation>
            <numerusform>%n punto de paso se mueve con él.</numerusform>
            <numerusform>%n puntos de paso se mueven con él.</numerusform>
        </translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>¿Retocar «%1»?</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Retocar</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>Retocar «%1»</translation>
    </message>
    <message>
        <source>Touched up “%1”</source>
        <translation>«%1» retocado</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Duplicar «%1»</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>¿Eliminar «%1»?</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints use this frame. They keep their positions and are converted to Base.</source>
        <translation>
            <numerusform>%n punto de paso usa este sistema. Conserva su posición y se convierte a Base.</numerusform>
            <numerusform>%n puntos de paso usan este sistema. Conservan su posición y se convierten a Base.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation>Eliminar sistema</translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation>Cambiar la pose de «%1»</translation>
    </message>
    <message>
        <source>The pose of “%1” was changed. %2</source>
        <translation>Se cambió la pose de «%1». %2</translation>
    </message>
</context>
<context>
    <name>tiller::FrameModel</name>
    <message>
        <source>Enter a name for the frame.</source>
        <translation>Introduzca un nombre para el sistema.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renombrar «%1» a «%2»</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>Origen %1</translation>
    </message>
    <message>
        <source>Origin in Base, X Y Z, %1</source>
        <translation>Origen en Base, X Y Z, %1</translation>
    </message>
    <message>
        <source>Rotation, rad</source>
        <translation>Rotación, rad</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotación</translation>
    </message>
    <message>
        <source>Rotation vector in Base, radians</source>
        <translation>Vector de rotación en Base, radianes</translation>
    </message>
    <message>
        <source>Roll, pitch and yaw in Base</source>
        <translation>Alabeo, cabeceo y guiñada en Base</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Waypoints that move with the frame</source>
        <translation>Puntos de paso que se mueven con el sistema</translation>
    </message>
    <message>
        <source>TCP %1</source>
        <translation>TCP %1</translation>
    </message>
    <message>
        <source>Distance from the TCP, %1</source>
        <translation>Distancia del TCP, %1</translation>
    </message>
    <message>
        <source>“%1” is a built-in frame. Choose a different name.</source>
        <translation>«%1» es un sistema de coordenadas predefinido. Elija otro nombre.</translation>
    </message>
    <message>
        <source>A frame named “%1” already exists. Choose a different name.</source>
        <translation>Ya existe un sistema de coordenadas con el nombre «%1». Elija otro nombre.</translation>
    </message>
</context>
<context>
    <name>tiller::FrameTable</name>
    <message>
        <source>Frames</source>
        <translation>Sistemas de coordenadas</translation>
    </message>
</context>
<context>
    <name>tiller::FrameTeacher</name>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Frame from three points</source>
        <translation>Sistema con tres puntos</translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation>Cancelar el sistema</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>On +X</source>
        <translation>En +X</translation>
    </message>
    <message>
        <source>Towards +Y</source>
        <translation>Hacia +Y</translation>
    </message>
    <message>
        <source>Record the origin at the TCP</source>
        <translation>Tomar aquí el origen</translation>
    </message>
    <message>
        <source>Record the point on +X at the TCP</source>
        <translation>Tomar aquí el punto en +X</translation>
    </message>
    <message>
        <source>Record the point towards +Y at the TCP</source>
        <translation>Tomar aquí el punto hacia +Y</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Tomar</translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation>Crear sistema</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the point again.</source>
        <translation>El robot envió una posición no válida. Tome el punto de nuevo.</translation>
    </message>
    <message>
        <source>The point on +X is only %1 from the origin. Record it again at least %2 away. A larger distance gives more accurate axes.</source>
        <translation>El punto en +X está a solo %1 del origen. Tómelo de nuevo a %2 como mínimo. Una distancia mayor da ejes más precisos.</translation>
    </message>
    <message>
        <source>The third point is only %1 from the origin. Record the point again at least %2 away.</source>
        <translation>El tercer punto está a solo %1 del origen. Tómelo de nuevo al menos a %2.</translation>
    </message>
    <message>
        <source>The three points are collinear: the third point is only %1 from the X axis. Record the point again at least %2 towards +Y.</source>
        <translation>Los tres puntos están alineados: el tercero está a solo %1 del eje X. Tómelo de nuevo a %2 como mínimo hacia +Y.</translation>
    </message>
    <message>
        <source>Ready: the point on +X is %1 from the origin, and the third point is %2 from the X axis.</source>
        <translation>Listo: el punto en +X está a %1 del origen y el tercero a %2 del eje X.</translation>
    </message>
    <message>
        <source>Jog the tip to the origin of the frame and record the point (P).</source>
        <translation>Mueva la punta al origen del sistema de coordenadas y tome el punto (P).</translation>
    </message>
    <message>
        <source>Now jog to a point on +X: %1 from the origin (minimum %2).</source>
        <translation>Ahora vaya a un punto en +X: a %1 del origen, mínimo %2.</translation>
    </message>
    <message>
        <source>Now jog towards +Y: %1 from the X axis (minimum %2).</source>
        <translation>Ahora vaya hacia +Y: a %1 del eje X, mínimo %2.</translation>
    </message>
    <message>
        <source>Record  P</source>
        <translation>Tomar  P</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Repetir</translation>
    </message>
</context>
<context>
    <name>tiller::FramesTab</name>
    <message>
        <source>Frames</source>
        <translation>Sistemas de coordenadas</translation>
    </message>
    <message>
        <source>From TCP</source>
        <translation>Del TCP</translation>
    </message>
    <message>
        <source>Teach a frame from the TCP</source>
        <translation>Enseñar un sistema desde el TCP</translation>
    </message>
    <message>
        <source>3 points</source>
        <translation>3 puntos</translation>
    </message>
    <message>
        <source>Teach a frame from three points</source>
        <translation>Enseñar un sistema con tres puntos</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Retocar</translation>
    </message>
    <message>
        <source>Touch up the frame</source>
        <translation>Retocar el sistema</translation>
    </message>
    <message>
        <source>More frame commands</source>
        <translation>Más órdenes de sistemas</translation>
    </message>
    <message>
        <source>No frames yet.
Jog the tip to a corner of the tray or table. Press “From TCP”, or press “3 points” to record the origin, +X and +Y.</source>
        <translation>Aún no hay sistemas de coordenadas.
Mueva la punta a una esquina de la bandeja o la mesa. Pulse «Del TCP», o «3 puntos» para tomar el origen, +X y +Y.</translation>
    </message>
    <message>
        <source>new frame</source>
        <translation>sistema nuevo</translation>
    </message>
    <message>
        <source>Create a frame at the TCP with the axes of the tool (Shift+T)</source>
        <translation>Crear un sistema de coordenadas en el TCP con los ejes de la herramienta (Mayús+T)</translation>
    </message>
    <message>
        <source>Create a frame from its origin, a point on +X and a point towards +Y (Ctrl+Shift+T)</source>
        <translation>Crear un sistema de coordenadas con origen, un punto en +X y un punto hacia +Y (Ctrl+Mayús+T)</translation>
    </message>
    <message>
        <source>Move the selected frame to the TCP (Shift+U)</source>
        <translation>Mover el sistema seleccionado al TCP (Mayús+U)</translation>
    </message>
    <message>
        <source>Select a frame to touch up.</source>
        <translation>Seleccione un sistema para retocar.</translation>
    </message>
    <message>
        <source>Teach frame from the TCP</source>
        <translation>Enseñar sistema desde el TCP</translation>
    </message>
    <message>
        <source>Teach frame from three points</source>
        <translation>Enseñar sistema con tres puntos</translation>
    </message>
    <message>
        <source>Record the next point of the frame</source>
        <translation>Tomar el siguiente punto del sistema</translation>
    </message>
    <message>
        <source>Create frame from points</source>
        <translation>Crear sistema a partir de puntos</translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation>Cancelar la enseñanza del sistema</translation>
    </message>
    <message>
        <source>Touch up frame from the TCP</source>
        <translation>Retocar sistema desde el TCP</translation>
    </message>
    <message>
        <source>Touch up frame from three points</source>
        <translation>Retocar sistema con tres puntos</translation>
    </message>
    <message>
        <source>Jog in this frame</source>
        <translation>Mover en este sistema</translation>
    </message>
    <message>
        <source>Rename frame</source>
        <translation>Renombrar sistema</translation>
    </message>
    <message>
        <source>Duplicate frame</source>
        <translation>Duplicar sistema</translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation>Eliminar sistema</translation>
    </message>
    <message>
        <source>Touch up “%1” from three points</source>
        <translation>Retocar «%1» con tres puntos</translation>
    </message>
    <message>
        <source>New frame from three points</source>
        <translation>Sistema nuevo con tres puntos</translation>
    </message>
    <message>
        <source>Touch up…</source>
        <translation>Retocar…</translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation>Crear sistema</translation>
    </message>
    <message>
        <source>Edit frame values</source>
        <translation>Editar los valores del sistema</translation>
    </message>
</context>
<context>
    <name>tiller::GoThroughBar</name>
    <message>
        <source>Loop</source>
        <translation>Bucle</translation>
    </message>
    <message>
        <source>Run the route</source>
        <translation>Recorrer la ruta</translation>
    </message>
    <message>
        <source>Run route (hold)</source>
        <translation>Ruta (mantener)</translation>
    </message>
    <message>
        <source>Run route, hold</source>
        <translation>Recorrer la ruta, mantener</translation>
    </message>
    <message>
        <source>Previous waypoint, hold</source>
        <translation>Punto anterior, mantener</translation>
    </message>
    <message>
        <source>Moves to the previous waypoint while the button is held</source>
        <translation>Va al punto de paso anterior mientras se mantiene el botón</translation>
    </message>
    <message>
        <source>Next waypoint, hold</source>
        <translation>Punto siguiente, mantener</translation>
    </message>
    <message>
        <source>Moves to the next waypoint while the button is held, then stops</source>
        <translation>Va al punto de paso siguiente mientras se mantiene el botón y se detiene allí</translation>
    </message>
    <message>
        <source>Route waypoints</source>
        <translation>Puntos de paso de la ruta</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Qué puntos</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>Desde aquí</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Selección</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todo</translation>
    </message>
    <message>
        <source>After the last waypoint, continues with the first waypoint while the button is held</source>
        <translation>Vuelve a empezar por el primer punto después del último, mientras se mantiene el botón</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller no tiene el control. Tome primero el control.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Next: %1 of %2, %3</source>
        <translation>Siguiente: %1 de %2, %3</translation>
    </message>
    <message>
        <source>done</source>
        <translation>hecho</translation>
    </message>
    <message>
        <source>Done. The next press starts at the first waypoint.</source>
        <translation>Terminado. La próxima pulsación empieza en el primer punto.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n punto de paso</numerusform>
            <numerusform>%n puntos de paso</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Moves from waypoint to waypoint while the button is held, no faster than the jog speed, and runs the actions of each waypoint. Release to pause; the next press continues to the next waypoint.</source>
        <translation>Va de punto en punto mientras se mantiene el botón, no más rápido que la velocidad de movimiento manual, y ejecuta las acciones de cada punto. Suelte para pausar; la siguiente pulsación continúa hacia el punto siguiente.</translation>
    </message>
    <message>
        <source>At %1: %2</source>
        <translation>En %1: %2</translation>
    </message>
    <message>
        <source>Selects the waypoints to run, in list order</source>
        <translation>Selecciona los puntos de paso de la ruta, en el orden de la lista</translation>
    </message>
</context>
<context>
    <name>tiller::GoToButton</name>
    <message>
        <source>Go to (hold)  G</source>
        <translation>Ir a (mantener)  G</translation>
    </message>
    <message>
        <source>Go to, hold</source>
        <translation>Ir a, mantener</translation>
    </message>
    <message>
        <source>Moves the arm to the selected waypoint while the button or G is held, no faster than the jog speed</source>
        <translation>Mueve el brazo al punto seleccionado mientras se mantiene el botón o G, no más rápido que la velocidad manual</translation>
    </message>
</context>
<context>
    <name>tiller::GripperPanel</name>
    <message>
        <source>Gripper state</source>
        <translation>Estado de la pinza</translation>
    </message>
    <message>
        <source>Gripper opening</source>
        <translation>Apertura de la pinza</translation>
    </message>
    <message>
        <source>Gripped object</source>
        <translation>Objeto agarrado</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>Activar</translation>
    </message>
    <message>
        <source>Activate the gripper</source>
        <translation>Activar la pinza</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation>Abrir la pinza</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation>Cerrar la pinza</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Pinza</translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation>Pinza: abrir</translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation>Pinza: cerrar</translation>
    </message>
    <message>
        <source>Gripper: move to %1</source>
        <translation>Pinza: mover a %1</translation>
    </message>
    <message>
        <source>Gripper type</source>
        <translation>Tipo de pinza</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Robotiq %1</source>
        <translation>Robotiq %1</translation>
    </message>
    <message>
        <source>One output: on = closed</source>
        <translation>Una salida: activa = cerrada</translation>
    </message>
    <message>
        <source>Two outputs: open, close</source>
        <translation>Dos salidas: abrir, cerrar</translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation>Salida de cierre</translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation>Salida de apertura</translation>
    </message>
    <message>
        <source>Target opening</source>
        <translation>Apertura de destino</translation>
    </message>
    <message>
        <source>Finger speed</source>
        <translation>Velocidad de los dedos</translation>
    </message>
    <message>
        <source>Finger force</source>
        <translation>Fuerza de los dedos</translation>
    </message>
    <message>
        <source>Suggested action</source>
        <translation>Acción sugerida</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Apertura</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>Target opening of the fingers, 0 to %1. “Move” starts the motion.</source>
        <translation>Apertura de destino de los dedos, 0 a %1. «Mover» inicia el movimiento.</translation>
    </message>
    <message>
        <source>Speed of the next motion. 0 % is about %1, 100 % about %2.</source>
        <translation>Velocidad del próximo movimiento. 0 % son unos %1, 100 % unos %2.</translation>
    </message>
    <message>
        <source>Force of the next grip. 0 % is about %1, 100 % about %2.</source>
        <translation>Fuerza del próximo agarre. 0 % son unos %1, 100 % unos %2.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Gripper set to %1</source>
        <translation>Pinza ajustada: %1</translation>
    </message>
    <message>
        <source>%1 (speed %2, force %3)</source>
        <translation>%1 (velocidad %2, fuerza %3)</translation>
    </message>
    <message>
        <source>Please wait…</source>
        <translation>Espere…</translation>
    </message>
    <message>
        <source>Select the mounted gripper. The choice is stored for this robot.</source>
        <translation>Seleccione la pinza montada. La elección se guarda para este robot.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>activating…</source>
        <translation>activándose…</translation>
    </message>
    <message>
        <source>not active</source>
        <translation>no activa</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>pendiente…</translation>
    </message>
    <message>
        <source>active</source>
        <translation>activa</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>en movimiento</translation>
    </message>
    <message>
        <source>active, at standstill</source>
        <translation>activa, en reposo</translation>
    </message>
    <message>
        <source>unknown while moving</source>
        <translation>desconocido durante el movimiento</translation>
    </message>
    <message>
        <source>The gripper is not available with this port offset. Use a smaller port offset.</source>
        <translation>La pinza no está disponible con este desplazamiento de puerto. Use un desplazamiento menor.</translation>
    </message>
    <message>
        <source>Activating: the fingers open and close once.</source>
        <translation>Activándose: los dedos abren y cierran una vez.</translation>
    </message>
    <message>
        <source>Activate the gripper first.</source>
        <translation>Active primero la pinza.</translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation>La pinza está activa.</translation>
    </message>
    <message>
        <source>The fingers open and close once and drop any gripped object. Keep your fingers clear of the gripper.</source>
        <translation>Los dedos se abren y se cierran una vez y sueltan el objeto agarrado. Mantenga los dedos lejos de la pinza.</translation>
    </message>
    <message>
        <source>Opens the gripper and releases the object.</source>
        <translation>Abre la pinza y suelta el objeto.</translation>
    </message>
    <message>
        <source>Closes the gripper. Keep your fingers clear of the gripper.</source>
        <translation>Cierra la pinza. Mantenga los dedos lejos de ella.</translation>
    </message>
    <message>
        <source>The gripper did not execute the command. Check that no other program controls the gripper, then try again.</source>
        <translation>La pinza no ejecutó la orden. Compruebe que ningún otro programa controla la pinza e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Gripper: stop</source>
        <translation>Pinza: parar</translation>
    </message>
    <message>
        <source>Move the fingers to the target opening</source>
        <translation>Mover los dedos a la apertura de destino</translation>
    </message>
    <message>
        <source>Closed by</source>
        <translation>Cierra</translation>
    </message>
    <message>
        <source>Opened by</source>
        <translation>Abre</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Destino</translation>
    </message>
    <message>
        <source>Connect to a robot first. Tiller stores the gripper selection for each robot.</source>
        <translation>Conéctese primero a un robot. Tiller guarda la selección de la pinza para cada robot.</translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation>El robot no envía datos. Espere los datos o vuelva a conectarse.</translation>
    </message>
    <message>
        <source>external grip</source>
        <translation>agarre exterior</translation>
    </message>
    <message>
        <source>internal grip</source>
        <translation>agarre interior</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Stopping the arm does not open the gripper.</source>
        <translation>Detener el brazo no abre la pinza.</translation>
    </message>
    <message>
        <source>Moves the fingers to the target opening.</source>
        <translation>Mueve los dedos a la apertura de destino.</translation>
    </message>
    <message>
        <source>Speed or force is out of range. Enter a value from 0 to 100 %.</source>
        <translation>La velocidad o la fuerza está fuera del intervalo. Introduzca de 0 a 100 %.</translation>
    </message>
</context>
<context>
    <name>tiller::HeaderBar</name>
    <message>
        <source>ROBOT</source>
        <translation>ROBOT</translation>
    </message>
    <message>
        <source>ROBOT MODE</source>
        <translation>MODO DE ROBOT</translation>
    </message>
    <message>
        <source>SAFETY</source>
        <translation>SEGURIDAD</translation>
    </message>
    <message>
        <source>CONTROL</source>
        <translation>CONTROL</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>ENLACE</translation>
    </message>
    <message>
        <source>LAST STOP</source>
        <translation>ÚLTIMA PARADA</translation>
    </message>
    <message>
        <source>Robot state</source>
        <translation>Estado del robot</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Siguiente paso</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>SIN DATOS</translation>
    </message>
    <message>
        <source>LAST STOP · no key check</source>
        <translation>ÚLTIMA PARADA · sin comprobación</translation>
    </message>
    <message>
        <source>%1 ms · %2</source>
        <translation>%1 ms · %2</translation>
    </message>
    <message>
        <source>Measured from the stop command to standstill. Cause: %1</source>
        <translation>Medida desde la orden de parada hasta el reposo. Causa: %1</translation>
    </message>
    <message>
        <source>No stop measured yet</source>
        <translation>Aún sin parada medida</translation>
    </message>
    <message>
        <source>▲ Speed cap raised to %1</source>
        <translation>▲ Límite de velocidad elevado a %1</translation>
    </message>
    <message>
        <source>The arm may move faster than %1. Lower the speed cap in Settings. The cap is reset when Tiller is closed.</source>
        <translation>El brazo puede moverse más rápido que %1. Reduzca el límite de velocidad en Ajustes. El límite se restablece al cerrar Tiller.</translation>
    </message>
    <message>
        <source>MONITOR ONLY</source>
        <translation>SOLO SUPERVISIÓN</translation>
    </message>
    <message>
        <source>Cause: %1 (%2)</source>
        <translation>Causa: %1 (%2)</translation>
    </message>
    <message>
        <source>The program was stopped on the robot, so the stop could not be measured.</source>
        <translation>El programa se paró en el robot, por lo que no se pudo medir la parada.</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>No medida</translation>
    </message>
    <message>
        <source>The robot stopped sending data while the arm was moving, so the stop could not be measured.</source>
        <translation>El robot dejó de enviar datos mientras el brazo se movía: no se pudo medir la parada.</translation>
    </message>
    <message>
        <source>Not stopped</source>
        <translation>No detenido</translation>
    </message>
</context>
<context>
    <name>tiller::HoldRules</name>
    <message>
        <source>The window was not active. Press again.</source>
        <translation>La ventana no estaba activa. Pulse de nuevo.</translation>
    </message>
    <message>
        <source>Click in the window first.</source>
        <translation>Haga clic primero en la ventana.</translation>
    </message>
    <message>
        <source>A dialog or a menu is open. Close it first.</source>
        <translation>Hay un diálogo o menú abierto. Ciérrelo primero.</translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation>Ya se mantiene otro botón o tecla. Suéltelo primero.</translation>
    </message>
    <message>
        <source>The display server does not respond, so Tiller cannot detect the release of a button or key. Release the button or key, then try again.</source>
        <translation>El servidor gráfico no responde: no se puede detectar cuándo se suelta un botón o una tecla. Suéltelo e inténtelo de nuevo.</translation>
    </message>
</context>
<context>
    <name>tiller::HoldToRunButton</name>
    <message>
        <source>hold</source>
        <translation>mantener</translation>
    </message>
    <message>
        <source>Hold this button. The arm moves only while the button is held.</source>
        <translation>Mantenga este botón: el brazo solo se mueve mientras se mantiene.</translation>
    </message>
</context>
<context>
    <name>tiller::ImportReport</name>
    <message>
        <source>Steps: %1. Kept as URScript text: %2. Not imported: %3. New waypoints: %4.</source>
        <translation>Pasos: %1. Conservados como texto URScript: %2. No importados: %3. Puntos de paso nuevos: %4.</translation>
    </message>
    <message>
        <source>Imported program</source>
        <translation>Programa importado</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Node or statement</source>
        <translation>Nodo o instrucción</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Import report for “%1”</source>
        <translation>Informe de importación de «%1»</translation>
    </message>
</context>
<context>
    <name>tiller::IncidentWatch</name>
    <message>
        <source>protective stop</source>
        <translation>parada de protección</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>parada de emergencia</translation>
    </message>
    <message>
        <source>safety violation</source>
        <translation>infracción de seguridad</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>fallo</translation>
    </message>
    <message>
        <source>The incident (%1) could not be recorded.</source>
        <translation>El incidente (%1) no se pudo grabar.</translation>
    </message>
    <message>
        <source>Incident recorded: %1</source>
        <translation>Incidente grabado: %1</translation>
    </message>
    <message>
        <source>The recording %2 starts %1 s before the stop. Double-click this entry to open the recording.</source>
        <translation>La grabación %2 empieza %1 s antes de la parada. Haga doble clic en esta entrada para abrirla.</translation>
    </message>
</context>
<context>
    <name>tiller::IoChannel</name>
    <message>
        <source>no data</source>
        <translation>sin datos</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivada</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activada</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>pendiente…</translation>
    </message>
    <message>
        <source>%1, outdated</source>
        <translation>%1, sin actualizar</translation>
    </message>
    <message>
        <source>Pulse</source>
        <translation>Pulso</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renombrar…</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Nombre de %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>
The output cannot be switched while the robot is not sending data.</source>
        <translation>
La salida no se puede conmutar mientras el robot no envía datos.</translation>
    </message>
    <message>
        <source>
Click to switch the output %1. Press P to pulse it. Right-click to pulse or rename it.</source>
        <translation>
Clic para conmutar: %1. Pulse P para un impulso. Clic derecho para un impulso o renombrar.</translation>
    </message>
    <message>
        <source>
Right-click or press F2 to rename the input.</source>
        <translation>
Para renombrar, haga clic derecho o pulse F2.</translation>
    </message>
</context>
<context>
    <name>tiller::IoPages</name>
    <message>
        <source>Signals</source>
        <translation>Señales</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Pinza</translation>
    </message>
    <message>
        <source>I/O page</source>
        <translation>Página de E/S</translation>
    </message>
</context>
<context>
    <name>tiller::IoTab</name>
    <message>
        <source>Inputs and outputs</source>
        <translation>Entradas y salidas</translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation>Buscar entradas y salidas</translation>
    </message>
    <message>
        <source>Search by terminal or name</source>
        <translation>Buscar por borne o nombre</translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation>Salidas digitales</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>Entradas digitales</translation>
    </message>
    <message>
        <source>Configurable outputs</source>
        <translation>Salidas configurables</translation>
    </message>
    <message>
        <source>Configurable inputs</source>
        <translation>Entradas configurables</translation>
    </message>
    <message>
        <source>Tool outputs</source>
        <translation>Salidas de herramienta</translation>
    </message>
    <message>
        <source>Tool inputs</source>
        <translation>Entradas de herramienta</translation>
    </message>
    <message>
        <source>Press the Tab key to select a row on the I/O tab first.</source>
        <translation>Seleccione primero una fila de la pestaña E/S con la tecla Tab.</translation>
    </message>
    <message>
        <source>The robot did not confirm %1</source>
        <translation>El robot no confirmó %1</translation>
    </message>
    <message>
        <source>Analog</source>
        <translation>Analógicas</translation>
    </message>
    <message>
        <source>General purpose registers</source>
        <translation>Registros de uso general</translation>
    </message>
    <message>
        <source>Replay is active. Press “Back to live” first.</source>
        <translation>La reproducción está activa. Pulse primero «Volver a lo actual».</translation>
    </message>
    <message>
        <source>%1 cannot be pulsed now</source>
        <translation>Ahora no se puede dar un impulso en %1</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueado</translation>
    </message>
    <message>
        <source>controlled by another program</source>
        <translation>controlado por otro programa</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivada</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activada</translation>
    </message>
    <message>
        <source>Another program or the installation may control the output. Check both, then switch the output again.</source>
        <translation>Puede que la controle otro programa o la instalación. Compruebe ambos y vuelva a conmutar la salida.</translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation>El robot no envía datos. Espere los datos o vuelva a conectarse.</translation>
    </message>
</context>
<context>
    <name>tiller::JogColumn</name>
    <message>
        <source>Jog</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>Hold to move</source>
        <translation>Mantener para mover</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulaciones</translation>
    </message>
    <message>
        <source>Pose or joints</source>
        <translation>Pose o articulaciones</translation>
    </message>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation>No hay trayectoria que recorrer hacia atrás. Mueva antes el brazo.</translation>
    </message>
    <message>
        <source>release and press again</source>
        <translation>suelte y pulse de nuevo</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>Mov. libre</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Moves all joints to the home position while the button is held</source>
        <translation>Mueve todas las articulaciones a la posición inicial mientras se mantiene</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Alinear</translation>
    </message>
    <message>
        <source>Aligns the tool with the nearest axis of the selected frame while the button is held</source>
        <translation>Alinea la herramienta con el eje más cercano del sistema elegido mientras se mantiene</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Retraces the last motion while the button is held</source>
        <translation>Recorre hacia atrás el último movimiento mientras se mantiene</translation>
    </message>
    <message>
        <source>home</source>
        <translation>en inicio</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>alineado</translation>
    </message>
    <message>
        <source>Ends in %1 s</source>
        <translation>Termina en %1 s</translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation>Ya se mantiene otro botón o tecla. Suéltelo primero.</translation>
    </message>
    <message>
        <source>Last stop: %1, standstill after %2 ms, %3</source>
        <translation>Última parada: %1, reposo tras %2 ms, %3</translation>
    </message>
    <message>
        <source>Move the arm by hand while this button is held: %1. Right-click to select axes.</source>
        <translation>Mueva el brazo a mano mientras mantiene este botón: %1. Clic derecho para elegir ejes.</translation>
    </message>
    <message>
        <source>Freedrive, %1</source>
        <translation>Movimiento libre, %1</translation>
    </message>
    <message>
        <source>Freedrive…</source>
        <translation>Mov. libre…</translation>
    </message>
    <message>
        <source>Check payload before Freedrive (resets on reconnect)</source>
        <translation>Comprobar la carga útil antes de mover a mano (se restablece al reconectar)</translation>
    </message>
    <message>
        <source>Last stop: not measured (data lost)</source>
        <translation>Última parada: no medida (sin datos)</translation>
    </message>
    <message>
        <source>Press for one step</source>
        <translation>Pulsar: un paso</translation>
    </message>
    <message>
        <source>Last stop: %1 (%2)</source>
        <translation>Última parada: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>tiller::JogKey</name>
    <message>
        <source>%1 left in this direction</source>
        <translation>quedan %1 en esta dirección</translation>
    </message>
</context>
<context>
    <name>tiller::JogPad</name>
    <message>
        <source>Jog buttons</source>
        <translation>Botones de movimiento</translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation>Mover %1</translation>
    </message>
</context>
<context>
    <name>tiller::JogSelectors</name>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herram.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Sistema</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Mantener</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Moves while the button is held</source>
        <translation>Mueve mientras se mantiene el botón</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Rotates while the button is held</source>
        <translation>Gira mientras se mantiene el botón</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>View axes: X right, Y away from you, Z up</source>
        <translation>Ejes de la vista: X a la derecha, Y alejándose de usted, Z hacia arriba</translation>
    </message>
    <message>
        <source>Requires the 3D view</source>
        <translation>Necesita la vista 3D</translation>
    </message>
    <message>
        <source>No frame taught yet. Teach a frame on the Frames tab.</source>
        <translation>Aún no hay ningún sistema enseñado. Enseñe uno en la pestaña Sistemas de coordenadas.</translation>
    </message>
    <message>
        <source>Moves by %1 per press.</source>
        <translation>Mueve %1 por pulsación.</translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press.</source>
        <translation>Gira la herramienta o la articulación %1 por pulsación.</translation>
    </message>
    <message>
        <source>≤ %1</source>
        <translation>≤ %1</translation>
    </message>
    <message>
        <source>Moves slowly while the button is held, until the contact force reaches %1 N. Click again to select a different step.</source>
        <translation>Mueve despacio mientras se mantiene, hasta que la fuerza de contacto llega a %1 N. Haga clic de nuevo para elegir otro paso.</translation>
    </message>
    <message>
        <source>Moves by %1 per press. Click again to select a different step.</source>
        <translation>Mueve %1 por pulsación. Haga clic de nuevo para elegir otro paso.</translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press. Click again to select a different angle.</source>
        <translation>Gira la herramienta o la articulación %1 por pulsación. Haga clic de nuevo para elegir otro ángulo.</translation>
    </message>
    <message>
        <source>%1 · rotation %2 · joints %3 · Ctrl × 0.1, Shift × 3</source>
        <translation>%1 · giros %2 · articulaciones %3 · Ctrl × 0,1, Mayús × 3</translation>
    </message>
    <message>
        <source>Other angle…</source>
        <translation>Otro ángulo…</translation>
    </message>
    <message>
        <source>Other step…</source>
        <translation>Otro paso…</translation>
    </message>
    <message>
        <source>Until contact, %1 N</source>
        <translation>Hasta contacto, %1 N</translation>
    </message>
    <message>
        <source>Other contact force…</source>
        <translation>Otra fuerza de contacto…</translation>
    </message>
    <message>
        <source>Other speed…</source>
        <translation>Otra velocidad…</translation>
    </message>
    <message>
        <source>Step in %1</source>
        <translation>Paso en %1</translation>
    </message>
    <message>
        <source>Angle in degrees</source>
        <translation>Ángulo en grados</translation>
    </message>
    <message>
        <source>TCP speed in %1</source>
        <translation>Velocidad del TCP en %1</translation>
    </message>
    <message>
        <source>Contact force that ends the motion, in N</source>
        <translation>Fuerza de contacto en N que termina el movimiento</translation>
    </message>
    <message>
        <source>The step continues after the button is released. Space, Esc and STOP end the step.</source>
        <translation>El paso continúa al soltar. Espacio, Esc y STOP lo terminan.</translation>
    </message>
    <message>
        <source>Hold the button until the step is complete.</source>
        <translation>Mantenga pulsado el botón hasta completar el paso.</translation>
    </message>
</context>
<context>
    <name>tiller::JointRow</name>
    <message>
        <source>%1 minus</source>
        <translation>%1 menos</translation>
    </message>
    <message>
        <source>%1 plus</source>
        <translation>%1 más</translation>
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
        <translation>Articulaciones</translation>
    </message>
</context>
<context>
    <name>tiller::KeyboardJog</name>
    <message>
        <source>Keyboard jogging is armed</source>
        <translation>El movimiento por teclado está armado</translation>
    </message>
</context>
<context>
    <name>tiller::LimiterLine</name>
    <message>
        <source>Limiter</source>
        <translation>Limitador</translation>
    </message>
</context>
<context>
    <name>tiller::LimitsDialog</name>
    <message>
        <source>Limits of the value axis</source>
        <translation>Límites del eje de valores</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Mínimo</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>%1, minimum</source>
        <translation>%1, mínimo</translation>
    </message>
    <message>
        <source>%1, maximum</source>
        <translation>%1, máximo</translation>
    </message>
    <message>
        <source>%1: enter two numbers. The minimum must be less than the maximum.</source>
        <translation>%1: introduzca dos números. El mínimo debe ser menor que el máximo.</translation>
    </message>
</context>
<context>
    <name>tiller::LogModel</name>
    <message>
        <source>Info</source>
        <translation>Información</translation>
    </message>
    <message>
        <source>▲ Warning</source>
        <translation>▲ Aviso</translation>
    </message>
    <message>
        <source>⬣ Error</source>
        <translation>⬣ Error</translation>
    </message>
    <message>
        <source>Tiller</source>
        <translation>Tiller</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Evento</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open the recording of this incident at the time of the stop</source>
        <translation>Abrir la grabación de este incidente en el momento de la parada</translation>
    </message>
    <message>
        <source>Open the recording at this time</source>
        <translation>Abrir la grabación en este momento</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operador</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>%1 · Origin: %2</source>
        <translation>%1 · Origen: %2</translation>
    </message>
    <message>
        <source>%1 times between %2 and %3 · Origin: %4</source>
        <translation>%1 veces de %2 a %3 · Origen: %4</translation>
    </message>
    <message>
        <source>(×%1, last at %2) %3</source>
        <translation>(×%1, última vez %2) %3</translation>
    </message>
</context>
<context>
    <name>tiller::LogTab</name>
    <message>
        <source>All</source>
        <translation>Todo</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Errores</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Minimum severity</source>
        <translation>Gravedad mínima</translation>
    </message>
    <message>
        <source>Filter the log by text</source>
        <translation>Filtrar el registro por texto</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the selected entries, or all visible entries (Ctrl+C)</source>
        <translation>Copiar las entradas seleccionadas, o todas las visibles (Ctrl+C)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Write the visible entries to a file</source>
        <translation>Escribir las entradas visibles en un archivo</translation>
    </message>
    <message>
        <source>Details of the selected entry</source>
        <translation>Detalles de la entrada seleccionada</translation>
    </message>
    <message>
        <source>Export the log</source>
        <translation>Exportar el registro</translation>
    </message>
    <message>
        <source>Text file (*.txt)</source>
        <translation>Archivo de texto (*.txt)</translation>
    </message>
    <message>
        <source>Log written to %1</source>
        <translation>Registro escrito en %1</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Abrir grabación</translation>
    </message>
    <message>
        <source>Open the recording of the selected entry</source>
        <translation>Abrir la grabación de la entrada seleccionada</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Nota: %1</translation>
    </message>
</context>
<context>
    <name>tiller::MetadataDialog</name>
    <message>
        <source>Ask before each recording</source>
        <translation>Preguntar cada vez</translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation>Metadatos de las grabaciones</translation>
    </message>
    <message>
        <source>Tiller stores the fields with a value in each recording. The names and values are kept for the next recording.</source>
        <translation>Tiller guarda en cada grabación los campos que tienen un valor. Los nombres y los valores se conservan para la próxima grabación.</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>Metadatos</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Add field</source>
        <translation>Añadir campo</translation>
    </message>
    <message>
        <source>Remove field</source>
        <translation>Quitar campo</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>The value “%1” has no name. Enter a name.</source>
        <translation>El valor «%1» no tiene nombre. Introduzca un nombre.</translation>
    </message>
    <message>
        <source>The name “%1” is not valid. Use letters, digits, spaces and _ - . (at most 60).</source>
        <translation>El nombre «%1» no es válido. Utilice letras, cifras, espacios y _ - . (60 como máximo).</translation>
    </message>
    <message>
        <source>Tiller stores “%1” itself. Choose another name.</source>
        <translation>Tiller guarda «%1» automáticamente. Elija otro nombre.</translation>
    </message>
    <message>
        <source>The name “%1” occurs twice. Choose another name.</source>
        <translation>El nombre «%1» aparece dos veces. Elija otro nombre.</translation>
    </message>
    <message>
        <source>The value of “%1” must be one line of at most %2 characters.</source>
        <translation>El valor de «%1» debe ser una línea de %2 caracteres como máximo.</translation>
    </message>
    <message>
        <source>Remove fields: at most %1 fields are possible.</source>
        <translation>Quite campos: se permiten %1 como máximo.</translation>
    </message>
</context>
<context>
    <name>tiller::MoveWords</name>
    <message>
        <source>%1 collides with %2 after %3 of the path</source>
        <translation>%1 choca con %2 tras el %3 de la trayectoria</translation>
    </message>
    <message>
        <source>The move enters the wrist singularity after %1 of the path</source>
        <translation>La trayectoria entra en la singularidad de muñeca tras el %1 de su longitud</translation>
    </message>
    <message>
        <source>The move slows down near the wrist singularity at %1 of the path</source>
        <translation>Lento cerca de la singularidad de muñeca al %1 de la trayectoria</translation>
    </message>
    <message>
        <source>The move enters the elbow singularity after %1 of the path</source>
        <translation>La trayectoria entra en la singularidad de codo tras el %1 de su longitud</translation>
    </message>
    <message>
        <source>The move slows down near the elbow singularity at %1 of the path</source>
        <translation>Lento cerca de la singularidad de codo al %1 de la trayectoria</translation>
    </message>
    <message>
        <source>The move enters the shoulder singularity after %1 of the path</source>
        <translation>La trayectoria entra en la singularidad de hombro tras el %1 de su longitud</translation>
    </message>
    <message>
        <source>The move slows down near the shoulder singularity at %1 of the path</source>
        <translation>Lento cerca de la singularidad de hombro al %1 de la trayectoria</translation>
    </message>
    <message>
        <source>A joint would have to jump after %1 of the path</source>
        <translation>Una articulación tendría que saltar tras el %1 de la trayectoria</translation>
    </message>
    <message>
        <source>%1 exceeds its limit after %2 of the path</source>
        <translation>%1 supera su recorrido tras el %2 de la trayectoria</translation>
    </message>
    <message>
        <source>The move leaves the reach of the arm after %1 of the path</source>
        <translation>La trayectoria sale del alcance del brazo tras el %1 de su longitud</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Hombro</translation>
    </message>
    <message>
        <source>Upper arm</source>
        <translation>Brazo superior</translation>
    </message>
    <message>
        <source>Forearm</source>
        <translation>Antebrazo</translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation>Muñeca 1</translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation>Muñeca 2</translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation>Muñeca 3</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>%1 is in contact with %2, and the move reduces the distance</source>
        <translation>%1 está en contacto con %2, y el movimiento reduce la distancia</translation>
    </message>
    <message>
        <source>%1 is only %2 from %3, and the move reduces the distance</source>
        <translation>%1 está a solo %2 de %3, y el movimiento reduce la distancia</translation>
    </message>
    <message>
        <source>%1 comes within %2 of %3 after %4 of the path</source>
        <translation>%1 se acerca a menos de %2 de %3 tras %4 del recorrido</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>el suelo</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«%1»</translation>
    </message>
    <message>
        <source>The position of “%1” is unknown because its frame is not in the project. Enter its position, turn off its collision check, or delete it on the Cell page</source>
        <translation>La posición de «%1» es desconocida porque su sistema de coordenadas no está en el proyecto. Introduzca la posición, desactive la comprobación de colisiones del objeto o elimínelo en la página Celda</translation>
    </message>
</context>
<context>
    <name>tiller::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Notice action</source>
        <translation>Acción del aviso</translation>
    </message>
    <message>
        <source>Second notice action</source>
        <translation>Segunda acción del aviso</translation>
    </message>
</context>
<context>
    <name>tiller::OpenTableDialog</name>
    <message>
        <source>Open table</source>
        <translation>Abrir tabla</translation>
    </message>
    <message>
        <source>Tiller cannot determine the times of the rows in %1. Select how to read the table.</source>
        <translation>Tiller no puede determinar los tiempos de las filas de %1. Seleccione cómo leer la tabla.</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>Primeras líneas del archivo</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>Columna de tiempo</translation>
    </message>
    <message>
        <source>No time column</source>
        <translation>Sin columna de tiempo</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>Unidad de tiempo</translation>
    </message>
    <message>
        <source>Rows per second</source>
        <translation>Filas por segundo</translation>
    </message>
    <message>
        <source>Column separator</source>
        <translation>Separador de columnas</translation>
    </message>
    <message>
        <source>Comma</source>
        <translation>Coma</translation>
    </message>
    <message>
        <source>Semicolon</source>
        <translation>Punto y coma</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tabulador</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
    <message>
        <source>Decimal separator</source>
        <translation>Separador decimal</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>First row</source>
        <translation>Primera fila</translation>
    </message>
    <message>
        <source>Column names</source>
        <translation>Nombres de columnas</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Datos</translation>
    </message>
    <message>
        <source>Reason: %1</source>
        <translation>Motivo: %1</translation>
    </message>
    <message>
        <source>Detect automatically</source>
        <translation>Detectar automáticamente</translation>
    </message>
</context>
<context>
    <name>tiller::PartModel</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
</context>
<context>
    <name>tiller::PartPage</name>
    <message>
        <source>More</source>
        <translation>Más</translation>
    </message>
</context>
<context>
    <name>tiller::PathControls</name>
    <message>
        <source>Path tolerance</source>
        <translation>Tolerancia de trayectoria</translation>
    </message>
    <message>
        <source>Record path</source>
        <translation>Grabar trayectoria</translation>
    </message>
    <message>
        <source>Export path as CSV…</source>
        <translation>Exportar trayectoria como CSV…</translation>
    </message>
    <message>
        <source>Import path from CSV…</source>
        <translation>Importar trayectoria desde CSV…</translation>
    </message>
    <message>
        <source>The path recorded so far is kept.</source>
        <translation>La trayectoria grabada hasta ahora se conserva.</translation>
    </message>
    <message>
        <source>Stop recording path</source>
        <translation>Detener la grabación de la trayectoria</translation>
    </message>
    <message>
        <source>Simplifying the path…</source>
        <translation>Simplificando la trayectoria…</translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation>No se puede grabar una trayectoria porque el robot no envía datos. Espere los datos o conecte un robot.</translation>
    </message>
    <message>
        <source>Stops recording and stores the path as waypoints</source>
        <translation>Detiene la grabación y guarda la trayectoria como puntos de paso</translation>
    </message>
    <message>
        <source>Records the path of the arm during Freedrive or jogging and stores it as waypoints. Press again to stop. Recording does not move the robot.</source>
        <translation>Graba la trayectoria del brazo en movimiento libre o manual y la guarda como puntos de paso. Pulse de nuevo para detener. El robot no se mueve.</translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation>Seleccione al menos dos puntos de paso de la trayectoria.</translation>
    </message>
    <message>
        <source>Export path</source>
        <translation>Exportar trayectoria</translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation>Archivo CSV (*.csv)</translation>
    </message>
    <message>
        <source>The path was not exported.</source>
        <translation>La trayectoria no se exportó.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints exported as a path to %1</source>
        <translation>
            <numerusform>%n punto escrito como trayectoria en %1</numerusform>
            <numerusform>%n puntos escritos como trayectoria en %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Import path</source>
        <translation>Importar trayectoria</translation>
    </message>
    <message>
        <source>○ Path</source>
        <translation>○ Ruta</translation>
    </message>
    <message>
        <source>The path of the arm is being recorded. To stop recording, press “● REC” or select “Stop recording path” in the menu.</source>
        <translation>Se está grabando la trayectoria del brazo. Para terminar, pulse «● REC» o seleccione el mismo comando en el menú.</translation>
    </message>
    <message>
        <source>Path recording stopped because the maximum duration of ten minutes was reached.</source>
        <translation>Grabación de la trayectoria detenida: se alcanzó la duración máxima de diez minutos.</translation>
    </message>
    <message>
        <source>Path recording stopped because the robot stopped sending data or was restarted.</source>
        <translation>Grabación de la trayectoria detenida: el robot dejó de enviar datos o se reinició.</translation>
    </message>
</context>
<context>
    <name>tiller::PathRecorder</name>
    <message>
        <source>%1 has no column “%2”. The columns “timestamp” and “actual_q_0” to “actual_q_5” are required.</source>
        <translation>%1 no tiene la columna «%2». Se requieren las columnas timestamp y actual_q_0 a actual_q_5.</translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation>No se puede grabar una trayectoria porque el robot no envía datos. Espere los datos o conecte un robot.</translation>
    </message>
    <message>
        <source>Import refused because another path is being recorded or processed. Stop the recording, or wait, and try again.</source>
        <translation>Importación rechazada porque se está grabando o procesando otra trayectoria. Detenga la grabación o espere, e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>The path could not be imported.</source>
        <translation>No se pudo importar la trayectoria.</translation>
    </message>
    <message>
        <source>path %1</source>
        <translation>trayectoria %1</translation>
    </message>
    <message>
        <source>The arm did not move. No path was stored.</source>
        <translation>El brazo no se movió: no se guardó ninguna trayectoria.</translation>
    </message>
    <message>
        <source>Record “%1”</source>
        <translation>Grabar «%1»</translation>
    </message>
    <message>
        <source>“%1”: %2 s, %3 waypoints. Maximum deviation from the recording: %4 and %5.</source>
        <translation>«%1»: %2 s, %3 puntos de paso. Desviación máxima de la grabación: %4 y %5.</translation>
    </message>
    <message numerus="yes">
        <source>%n packets were lost.</source>
        <translation>
            <numerusform>Se perdió %n paquete.</numerusform>
            <numerusform>Se perdieron %n paquetes.</numerusform>
        </translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation>Seleccione al menos dos puntos de paso de la trayectoria.</translation>
    </message>
    <message>
        <source>“%1” is out of reach. Touch up or delete the waypoint.</source>
        <translation>«%1» está fuera de alcance. Retóquelo o quítelo.</translation>
    </message>
</context>
<context>
    <name>tiller::PatternDialog</name>
    <message>
        <source>pattern</source>
        <translation>patrón</translation>
    </message>
    <message>
        <source>Pattern from three corners</source>
        <translation>Patrón con tres esquinas</translation>
    </message>
    <message>
        <source>Pattern “%1”</source>
        <translation>Patrón «%1»</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>First cell</source>
        <translation>Primera celda</translation>
    </message>
    <message>
        <source>End of the first row</source>
        <translation>Fin de la primera fila</translation>
    </message>
    <message>
        <source>Start of the last row</source>
        <translation>Comienzo de la última fila</translation>
    </message>
    <message>
        <source>Select a waypoint</source>
        <translation>elija un punto de paso</translation>
    </message>
    <message>
        <source>As taught</source>
        <translation>como se enseñó</translation>
    </message>
    <message>
        <source>Cells per row</source>
        <translation>Celdas por fila</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Filas</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Layer height</source>
        <translation>Altura de capa</translation>
    </message>
    <message>
        <source>Distance from one layer to the next, measured opposite to the tool direction.</source>
        <translation>Distancia entre capas, opuesta a la dirección de la herramienta.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Row by row</source>
        <translation>Fila por fila</translation>
    </message>
    <message>
        <source>Zigzag</source>
        <translation>Meandro</translation>
    </message>
    <message>
        <source>Create pattern</source>
        <translation>Crear patrón</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Enter a name for the pattern.</source>
        <translation>Introduzca un nombre para el patrón.</translation>
    </message>
    <message>
        <source>Teach the corners first, then select a waypoint for each corner.</source>
        <translation>Enseñe primero las esquinas del patrón y seleccione después un punto de paso para cada una.</translation>
    </message>
    <message>
        <source>The layer height must not be 0. Enter a layer height.</source>
        <translation>La altura de capa no puede ser 0. Introduzca una altura de capa.</translation>
    </message>
    <message>
        <source>The pattern has %1 cells; the maximum is %2. Enter fewer cells per row, rows or layers.</source>
        <translation>El patrón tiene %1 celdas; el máximo es %2. Introduzca menos celdas por fila, filas o capas.</translation>
    </message>
    <message>
        <source>All cells are excluded. Click a cell to include it.</source>
        <translation>Todas las celdas están excluidas. Haga clic en una celda para incluirla.</translation>
    </message>
    <message>
        <source>The three corners are on a straight line. Select a different waypoint for one of them.</source>
        <translation>Las tres esquinas están en una recta. Seleccione otro punto de paso para una de ellas.</translation>
    </message>
    <message>
        <source>Two corners are at the same position. Select a different waypoint for one of them.</source>
        <translation>Dos esquinas están en la misma posición. Seleccione otro punto de paso para una de ellas.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n punto de paso</numerusform>
            <numerusform>%n puntos de paso</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, all within reach.</source>
        <translation>%1, todos al alcance.</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n out of reach and marked.</source>
        <translation>
            <numerusform>%1, %n fuera de alcance y marcado.</numerusform>
            <numerusform>%1, %n fuera de alcance y marcados.</numerusform>
        </translation>
    </message>
    <message>
        <source>A pattern with this name already exists. Choose a different name.</source>
        <translation>Ya existe un patrón con este nombre. Elija otro nombre.</translation>
    </message>
    <message>
        <source>The layer height is not a number or is out of range. Enter a different layer height.</source>
        <translation>La altura de capa no es un número o está fuera del rango. Introduzca otra altura de capa.</translation>
    </message>
</context>
<context>
    <name>tiller::PatternGrid</name>
    <message>
        <source>Pattern cells</source>
        <translation>Celdas del patrón</translation>
    </message>
    <message>
        <source>Click a cell to exclude or include it. The first cell is at the lower left.</source>
        <translation>Haga clic en una celda para excluirla o incluirla. La primera celda está abajo a la izquierda.</translation>
    </message>
    <message>
        <source>Row %1, column %2</source>
        <translation>Fila %1, columna %2</translation>
    </message>
</context>
<context>
    <name>tiller::PayloadEstimator</name>
    <message>
        <source>Next pose (hold)</source>
        <translation>Pose siguiente (mantener)</translation>
    </message>
    <message>
        <source>Keep payload</source>
        <translation>Conservar carga útil</translation>
    </message>
    <message>
        <source>Measure payload</source>
        <translation>Medir la carga útil</translation>
    </message>
    <message>
        <source>Measure the payload in several poses</source>
        <translation>Medir la carga útil en varias poses</translation>
    </message>
    <message>
        <source>Next pose, hold</source>
        <translation>Pose siguiente, mantener</translation>
    </message>
    <message>
        <source>Rotates the wrist to the next pose while the button is held, no faster than the jog speed. Make sure that the tool has space to rotate.</source>
        <translation>Gira la muñeca a la siguiente pose mientras se mantiene el botón, no más rápido que la velocidad de movimiento manual. Asegúrese de que la herramienta tiene espacio para girar.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cancel payload measurement</source>
        <translation>Cancelar la medición de la carga útil</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller no tiene el control. Tome primero el control.</translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and record the pose again.</source>
        <translation>El brazo se movió. Espere el reposo, mantenga la herramienta sin contacto y tome la pose de nuevo.</translation>
    </message>
    <message>
        <source>The robot is not sending force data. Enter the mass and the centre of gravity instead.</source>
        <translation>El robot no envía datos de fuerza. Introduzca la masa y el centro de gravedad.</translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation>Midiendo la carga útil… Mantenga la herramienta sin contacto.</translation>
    </message>
    <message>
        <source>%1 kg, centre of gravity at %2 from the flange. The poses agree within %3 and %4.</source>
        <translation>%1 kg, centro de gravedad a %2 de la brida. Las poses coinciden dentro de %3 y %4.</translation>
    </message>
    <message>
        <source>%1 The accuracy is low: pose %2 deviates most. Remove this pose and record another pose.</source>
        <translation>%1 La precisión es baja: la pose %2 es la que más se desvía. Quítela y tome otra.</translation>
    </message>
    <message>
        <source>The load of %1 kg is too light to measure the centre of gravity. Enter the payload manually.</source>
        <translation>La carga de %1 kg es demasiado ligera para medir el centro de gravedad. Introduzca la carga útil manualmente.</translation>
    </message>
    <message>
        <source>Wait for standstill, keep the tool free of contact, and record the pose. Then rotate the wrist by jogging or with “Next pose (hold)”, and record three more poses.</source>
        <translation>Espere el reposo, mantenga la herramienta sin contacto y tome la pose. Después gire la muñeca, con movimiento manual o con «Pose siguiente», y tome tres poses más.</translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation>Tomar pose %1</translation>
    </message>
    <message>
        <source>Remove least accurate pose</source>
        <translation>Quitar la pose menos precisa</translation>
    </message>
    <message>
        <source>Remove last pose</source>
        <translation>Quitar la última pose</translation>
    </message>
    <message>
        <source>Pose %1  %2</source>
        <translation>Pose %1  %2</translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation>  ◀ menos precisa</translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool rotated in a different direction.</source>
        <translation>Las orientaciones de la herramienta son demasiado parecidas. Tome una pose más con la herramienta girada en otra dirección.</translation>
    </message>
    <message numerus="yes">
        <source>Rotate the wrist in a different direction and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>Gire la muñeca en otra dirección y tome la pose. Poses que faltan: %n.</numerusform>
            <numerusform>Gire la muñeca en otra dirección y tome la pose. Poses que faltan: %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::PayloadPage</name>
    <message>
        <source>Mass kg</source>
        <translation>Masa kg</translation>
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
        <translation>En uso</translation>
    </message>
    <message>
        <source>Enter a name for the payload.</source>
        <translation>Introduzca un nombre para la carga útil.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renombrar «%1» a «%2»</translation>
    </message>
    <message>
        <source>Nothing mounted</source>
        <translation>Nada montado</translation>
    </message>
    <message>
        <source>Robotiq 2F-85, empty</source>
        <translation>Robotiq 2F-85, vacía</translation>
    </message>
    <message>
        <source>Robotiq 2F-140, empty</source>
        <translation>Robotiq 2F-140, vacía</translation>
    </message>
    <message>
        <source>Payloads</source>
        <translation>Cargas útiles</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
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
        <translation>Masa de la carga útil</translation>
    </message>
    <message>
        <source>Centre of gravity X</source>
        <translation>Centro de gravedad X</translation>
    </message>
    <message>
        <source>Centre of gravity Y</source>
        <translation>Centro de gravedad Y</translation>
    </message>
    <message>
        <source>Centre of gravity Z</source>
        <translation>Centro de gravedad Z</translation>
    </message>
    <message>
        <source>Press Return to apply the value to the project. The robot&apos;s payload does not change.</source>
        <translation>Pulse Intro para aplicar al proyecto. La carga útil del robot no cambia.</translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation>Fijar en el robot</translation>
    </message>
    <message>
        <source>Use this payload and set it on the robot</source>
        <translation>Usar esta carga útil y fijarla en el robot</translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation>Medir…</translation>
    </message>
    <message>
        <source>Measure the payload with the arm</source>
        <translation>Medir la carga útil con el brazo</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Comprobar</translation>
    </message>
    <message>
        <source>Verify the payload</source>
        <translation>Comprobar la carga útil</translation>
    </message>
    <message>
        <source>Store the active payload of the robot</source>
        <translation>Guardar la carga útil activa del robot</translation>
    </message>
    <message>
        <source>Enter new payload</source>
        <translation>Introducir carga útil nueva</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>carga útil</translation>
    </message>
    <message>
        <source>Add preset: %1</source>
        <translation>Añadir predefinida: %1</translation>
    </message>
    <message>
        <source>Rename payload</source>
        <translation>Renombrar carga útil</translation>
    </message>
    <message>
        <source>Duplicate payload</source>
        <translation>Duplicar carga útil</translation>
    </message>
    <message>
        <source>Delete payload</source>
        <translation>Eliminar carga útil</translation>
    </message>
    <message>
        <source>Add the payload “%1”</source>
        <translation>Añadir la carga útil «%1»</translation>
    </message>
    <message>
        <source>Change the payload “%1”</source>
        <translation>Cambiar la carga útil «%1»</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>Ningún robot conectado. Conecte uno o pruebe el simulador.</translation>
    </message>
    <message>
        <source>Select the payload to set.</source>
        <translation>Seleccione la carga útil que se va a fijar.</translation>
    </message>
    <message>
        <source>Use the payload “%1”</source>
        <translation>Usar la carga útil «%1»</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller no tiene el control. Tome primero el control.</translation>
    </message>
    <message>
        <source>Delete the payload “%1”</source>
        <translation>Eliminar la carga útil «%1»</translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation>Midiendo la carga útil… Mantenga la herramienta sin contacto.</translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and press “Verify” again.</source>
        <translation>El brazo se movió. Espere el reposo, mantenga la herramienta sin contacto y compruebe de nuevo.</translation>
    </message>
    <message>
        <source>The payload cannot be verified because the robot is not sending force data. Wait for data, or reconnect.</source>
        <translation>No se puede comprobar la carga útil porque el robot no envía datos de fuerza. Espere los datos o vuelva a conectarse.</translation>
    </message>
    <message>
        <source>With a payload of %1 kg, the arm measures a force of %2 and a torque of %3.</source>
        <translation>Con una carga útil de %1 kg, el brazo mide una fuerza de %2 y un par de %3.</translation>
    </message>
    <message>
        <source>The payload is correct. %1</source>
        <translation>La carga útil es correcta. %1</translation>
    </message>
    <message>
        <source>The payload is correct</source>
        <translation>La carga útil es correcta</translation>
    </message>
    <message>
        <source>The load is about %1 kg heavier than the configured payload.</source>
        <translation>La carga pesa unos %1 kg más que la carga útil configurada.</translation>
    </message>
    <message>
        <source>The load is about %1 kg lighter than the configured payload.</source>
        <translation>La carga pesa unos %1 kg menos que la carga útil configurada.</translation>
    </message>
    <message>
        <source>The centre of gravity differs, or something is touching the tool.</source>
        <translation>El centro de gravedad difiere, o algo toca la herramienta.</translation>
    </message>
    <message>
        <source>%1 %2 Measure the payload, or select a different payload. Zeroing the force sensor hides a wrong payload until the tool rotates.</source>
        <translation>%1 %2 Mida la carga útil o seleccione otra. Poner a cero el sensor de fuerza oculta una carga útil incorrecta hasta que la herramienta gira.</translation>
    </message>
    <message>
        <source>The payload is wrong. %1 %2</source>
        <translation>La carga útil es incorrecta. %1 %2</translation>
    </message>
    <message>
        <source>The payload is wrong</source>
        <translation>La carga útil es incorrecta</translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation>%1, activo en el robot</translation>
    </message>
    <message>
        <source>%1; the robot uses %2 kg, centre of gravity %3</source>
        <translation>%1; el robot usa %2 kg, centro de gravedad %3</translation>
    </message>
    <message>
        <source>The robot&apos;s payload differs from “%1”</source>
        <translation>La carga útil del robot difiere de «%1»</translation>
    </message>
    <message>
        <source>On the robot: %1 kg, centre of gravity %2. In the project: %3 kg, centre of gravity %4. Nothing was changed.</source>
        <translation>En el robot: %1 kg, centro %2. En el proyecto: %3 kg, centro %4. No se cambió nada.</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>Fijar «%1» en el robot</translation>
    </message>
    <message>
        <source>No payloads yet.
Press “Measure…” to measure the payload with the arm.</source>
        <translation>Aún no hay cargas.
Pulse Medir… para medir la carga con el brazo.</translation>
    </message>
    <message>
        <source>A payload named “%1” already exists. Choose a different name.</source>
        <translation>Ya existe una carga útil con el nombre «%1». Elija otro nombre.</translation>
    </message>
</context>
<context>
    <name>tiller::PlotAnalysis</name>
    <message>
        <source>Spectrum</source>
        <translation>Espectro</translation>
    </message>
    <message>
        <source>XY</source>
        <translation>XY</translation>
    </message>
    <message>
        <source>vs.</source>
        <translation>respecto a</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>Espectro y XY</translation>
    </message>
    <message>
        <source>Analysis type</source>
        <translation>Tipo de análisis</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Señal</translation>
    </message>
    <message>
        <source>X-axis signal</source>
        <translation>Señal del eje X</translation>
    </message>
    <message>
        <source>Add a signal to the plots first.</source>
        <translation>Añada primero una señal a los gráficos.</translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range.</source>
        <translation>Este rango no contiene muestras. Seleccione otro rango.</translation>
    </message>
    <message>
        <source>Samples are missing in this range. Place cursors A and B around a range without gaps.</source>
        <translation>Faltan muestras en este intervalo: coloque los cursores A y B sin huecos entre ellos.</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>Frecuencia [Hz]</translation>
    </message>
    <message>
        <source>Amplitude of %1</source>
        <translation>Amplitud de %1</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n muestra</numerusform>
            <numerusform>%n muestras</numerusform>
        </translation>
    </message>
    <message>
        <source>This range is too long to combine signals from different recordings. Place cursors A and B around a shorter range.</source>
        <translation>Este intervalo es demasiado largo para combinar señales de distintas grabaciones. Coloque los cursores A y B alrededor de un intervalo más corto.</translation>
    </message>
    <message>
        <source>Reading the recording: %1</source>
        <translation>Leyendo la grabación: %1</translation>
    </message>
    <message numerus="yes">
        <source>Hann window of %1 samples · resolution %2 Hz · mean of %n segment(s) · %3 to %4 s</source>
        <translation>
            <numerusform>Ventana de Hann de %1 muestras · resolución %2 Hz · media de %n segmento · %3 a %4 s</numerusform>
            <numerusform>Ventana de Hann de %1 muestras · resolución %2 Hz · media de %n segmentos · %3 a %4 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) shown, 1 of every %1</source>
        <translation>
            <numerusform>%n muestra mostrada, 1 de cada %1</numerusform>
            <numerusform>%n muestras mostradas, 1 de cada %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 to %3 s</source>
        <translation>%1 · %2 a %3 s</translation>
    </message>
    <message>
        <source>This range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation>Este intervalo contiene muestras de robots distintos. Coloque los cursores A y B alrededor de los datos de un solo robot.</translation>
    </message>
</context>
<context>
    <name>tiller::PlotComparison</name>
    <message>
        <source>Arm and model diverge: %1</source>
        <translation>El brazo y el modelo difieren: %1</translation>
    </message>
    <message>
        <source>Comparing the arm with its model: %1</source>
        <translation>Comparando el brazo con su modelo: %1</translation>
    </message>
    <message>
        <source>Not compared with the arm model: the recording does not specify the robot model. Press “Compare…” and select the model.</source>
        <translation>No comparada con el modelo del brazo: la grabación no indica el modelo de robot. Pulse «Comparar…» y seleccione el modelo.</translation>
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
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Time range of the plots. The mouse wheel zooms the time axis; over the value axis, or with Ctrl, it zooms the values. Double-click the value axis to scale automatically.</source>
        <translation>Intervalo de tiempo de los gráficos. La rueda del ratón amplía el eje de tiempo; sobre el eje de valores o con Ctrl, amplía los valores. Doble clic en el eje de valores ajusta la escala automáticamente.</translation>
    </message>
    <message>
        <source>Pause the plots</source>
        <translation>Pausar los gráficos</translation>
    </message>
    <message>
        <source>Zero the displayed force</source>
        <translation>Poner a cero la fuerza mostrada</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Cero</translation>
    </message>
    <message>
        <source>Export the visible range</source>
        <translation>Exportar el intervalo visible</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Save the visible range as an image (e.g. PNG) or as values (e.g. CSV)</source>
        <translation>Guardar el intervalo visible como imagen (p. ej., PNG) o como valores (p. ej., CSV)</translation>
    </message>
    <message>
        <source>Cannot zero the force: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation>No se puede poner a cero la fuerza: los gráficos no muestran muestras. Conéctese a un robot o vaya a un momento con muestras.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
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
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reanudar</translation>
    </message>
    <message>
        <source>Freeze the plots. Reception and recording of data continue.</source>
        <translation>Congelar los gráficos; los datos y la grabación continúan</translation>
    </message>
    <message>
        <source>Show the force as measured by the robot. %1</source>
        <translation>Mostrar la fuerza medida por el robot. %1</translation>
    </message>
    <message>
        <source>Subtract the current force in the plots. The robot, recordings and exported values are not changed.</source>
        <translation>Restar la fuerza actual en los gráficos. El robot, las grabaciones y los valores exportados no cambian.</translation>
    </message>
    <message>
        <source>● REC %1</source>
        <translation>● REC %1</translation>
    </message>
    <message>
        <source>● Record</source>
        <translation>● Grabar</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Detener grabación</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulado</translation>
    </message>
    <message>
        <source>Cannot export: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation>No se puede exportar: los gráficos no muestran muestras. Conéctese a un robot o vaya a un momento con muestras.</translation>
    </message>
    <message>
        <source>Exported the visible range to %1</source>
        <translation>Intervalo visible exportado a %1</translation>
    </message>
    <message>
        <source>PNG image (*.png)</source>
        <translation>Imagen PNG (*.png)</translation>
    </message>
    <message>
        <source>SVG image (*.svg)</source>
        <translation>Imagen SVG (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Documento PDF (*.pdf)</translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation>Archivo CSV (*.csv)</translation>
    </message>
    <message>
        <source>Recording options</source>
        <translation>Opciones de grabación</translation>
    </message>
    <message>
        <source>Rows, signals, folder and file name of the next recording</source>
        <translation>Filas, señales, carpeta y nombre de archivo de la próxima grabación</translation>
    </message>
    <message>
        <source>One row per packet</source>
        <translation>Una fila por paquete</translation>
    </message>
    <message numerus="yes">
        <source>One row every %n packet(s)</source>
        <translation>
            <numerusform>Una fila cada %n paquete</numerusform>
            <numerusform>Una fila cada %n paquetes</numerusform>
        </translation>
    </message>
    <message>
        <source>All signals…</source>
        <translation>Todas las señales…</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s)…</source>
        <translation>
            <numerusform>%n señal…</numerusform>
            <numerusform>%n señales…</numerusform>
        </translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Abrir la carpeta</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>Carpeta de grabaciones</translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range, then export again.</source>
        <translation>No hay muestras en este intervalo. Seleccione otro intervalo y exporte de nuevo.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>What happened at this time?</source>
        <translation>¿Qué ocurrió en este momento?</translation>
    </message>
    <message>
        <source>The plots were copied to the clipboard as an image.</source>
        <translation>Los gráficos se copiaron al portapapeles como imagen.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>History %1 · %2</source>
        <translation>Historial %1 · %2</translation>
    </message>
    <message>
        <source>New page</source>
        <translation>Página nueva</translation>
    </message>
    <message>
        <source>Remove this page</source>
        <translation>Quitar esta página</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Abrir grabación…</translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation>Cerrar las grabaciones</translation>
    </message>
    <message>
        <source>Copy plots as image</source>
        <translation>Copiar los gráficos como imagen</translation>
    </message>
    <message>
        <source>Save layout…</source>
        <translation>Guardar disposición…</translation>
    </message>
    <message>
        <source>Open layout…</source>
        <translation>Abrir disposición…</translation>
    </message>
    <message>
        <source>History memory</source>
        <translation>Memoria para el historial</translation>
    </message>
    <message>
        <source>Opened the recording %1</source>
        <translation>Grabación %1 abierta</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Abrir grabación</translation>
    </message>
    <message>
        <source>Save plot layout</source>
        <translation>Guardar la disposición de los gráficos</translation>
    </message>
    <message>
        <source>Plot layouts (*.json)</source>
        <translation>Disposiciones de gráficos (*.json)</translation>
    </message>
    <message>
        <source>Open plot layout</source>
        <translation>Abrir una disposición de gráficos</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 y más</translation>
    </message>
    <message>
        <source>Signal list</source>
        <translation>Lista de señales</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Señales</translation>
    </message>
    <message>
        <source>Robot signals. Drag a signal to a plot, or to the edge of a plot to create a new plot. Double-click a signal to add it to a plot.</source>
        <translation>Señales del robot. Arrastre una señal a un gráfico, o al borde de un gráfico para crear uno nuevo. Haga doble clic en una señal para añadirla a un gráfico.</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>Valores en los cursores</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Values at cursors A and B, and statistics of the range between the cursors: minimum, maximum, mean, RMS, standard deviation, slope</source>
        <translation>Valores en los cursores A y B y estadísticas entre ellos: mínimo, máximo, media, RMS, desviación típica, pendiente</translation>
    </message>
    <message>
        <source>Plot pages and layout</source>
        <translation>Páginas y disposición de los gráficos</translation>
    </message>
    <message>
        <source>Layout ▾</source>
        <translation>Disposición ▾</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>Espectro y XY</translation>
    </message>
    <message>
        <source>Export the visible range…</source>
        <translation>Exportar el intervalo visible…</translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation>Eje de tiempo</translation>
    </message>
    <message>
        <source>Relative to the newest sample</source>
        <translation>Respecto a la muestra más reciente</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>Tiempo del controlador</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Hora del día</translation>
    </message>
    <message>
        <source>The maximum number of plot pages has been reached. Remove a page first.</source>
        <translation>Se alcanzó el número máximo de páginas de gráficos: quite primero una.</translation>
    </message>
    <message>
        <source>CSV: text, for pandas and spreadsheets</source>
        <translation>CSV: texto, para pandas y hojas de cálculo</translation>
    </message>
    <message>
        <source>MCAP: every field, the log and the project, for ROS tools</source>
        <translation>MCAP: todos los campos, el registro y el proyecto, para herramientas de ROS</translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation>Comparar con el modelo del brazo…</translation>
    </message>
    <message>
        <source>Exported the range between cursors A and B to %1</source>
        <translation>El intervalo entre los cursores A y B se exportó a %1</translation>
    </message>
    <message>
        <source>Cursor A to cursor B (*%1)</source>
        <translation>Del cursor A al cursor B (*%1)</translation>
    </message>
    <message>
        <source>The page shows several recordings, or a recording and live signals. Show only one of them on the page, then export again.</source>
        <translation>La página muestra varias grabaciones, o una grabación y señales en vivo. Muestre solo una de ellas en la página y exporte de nuevo.</translation>
    </message>
    <message>
        <source>Live signals can be exported only as .csv. For other formats, record the signals first.</source>
        <translation>Las señales en vivo solo se pueden exportar como .csv. Para otros formatos, grábelas primero.</translation>
    </message>
    <message>
        <source>The range contains too many values to export from this window. Export a shorter range, or run “tiller-cli export”.</source>
        <translation>El intervalo tiene demasiados valores para exportarlo desde esta ventana. Exporte un intervalo más corto o ejecute «tiller-cli export».</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>Robot: %1</translation>
    </message>
    <message>
        <source>Recordings (%1);;All files (*)</source>
        <translation>Grabaciones (%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Record to a file (%1)</source>
        <translation>Grabar en un archivo (%1)</translation>
    </message>
    <message>
        <source>Record robot data to a file (%1). Use the arrow button to select the signals and the folder.</source>
        <translation>Grabar los datos del robot en un archivo (%1). Use la flecha para elegir señales y carpeta.</translation>
    </message>
    <message>
        <source>All %1 pages show recordings. Remove a page or close the recordings first.</source>
        <translation>Las %1 páginas muestran registros. Elimine antes una página o cierre los registros.</translation>
    </message>
    <message>
        <source>Cursor readout</source>
        <translation>Lectura del cursor</translation>
    </message>
    <message>
        <source>Click in the plots to place cursors A and B; drag them, or use the A, B and arrow keys. Click a legend entry to hide its curve; Ctrl+click the entry to show its values at the cursors.</source>
        <translation>Haga clic en los gráficos para colocar los cursores A y B; arrástrelos o use las teclas A, B y las flechas. Haga clic en una entrada de la leyenda para ocultar su curva; Ctrl+clic lee esa señal en los cursores.</translation>
    </message>
    <message>
        <source>Time range</source>
        <translation>Intervalo de tiempo</translation>
    </message>
    <message>
        <source>Paused · %1 s behind</source>
        <translation>En pausa · %1 s de retraso</translation>
    </message>
    <message>
        <source>Return to the newest samples</source>
        <translation>Volver a las muestras más nuevas</translation>
    </message>
    <message>
        <source>controller time %1 to %2 s</source>
        <translation>tiempo del controlador %1 a %2 s</translation>
    </message>
    <message>
        <source>%1 to %2 s</source>
        <translation>%1 a %2 s</translation>
    </message>
    <message>
        <source>Folder: %1…</source>
        <translation>Carpeta: %1…</translation>
    </message>
    <message>
        <source>The file type is not supported. Use the suffix .png, .svg or .pdf for an image, or .csv for values.</source>
        <translation>El tipo de archivo no se admite. Use la extensión .png, .svg o .pdf para una imagen, o .csv para valores.</translation>
    </message>
    <message>
        <source>%1 at controller time %2 s.</source>
        <translation>%1 (tiempo del controlador: %2 s).</translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation>Mostrar gráficos estándar</translation>
    </message>
    <message>
        <source>the file does not contain a plot layout</source>
        <translation>el archivo no contiene una disposición de gráficos</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %2/s · %3 free · %n packet(s) lost</source>
        <translation>
            <numerusform>%1 · %2/s · %3 libres · %n paquete perdido</numerusform>
            <numerusform>%1 · %2/s · %3 libres · %n paquetes perdidos</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened the recording %1, but part of it could not be read. %2</source>
        <translation>Grabación %1 abierta, pero no se pudo leer una parte. %2</translation>
    </message>
    <message>
        <source>Part of the recording %1 could not be read. %2</source>
        <translation>No se pudo leer una parte de la grabación %1. %2</translation>
    </message>
    <message>
        <source>The range contains samples from different robots. Use cursors A and B to select a range with data from one robot, then export again.</source>
        <translation>El rango contiene valores de distintos robots. Seleccione con los cursores A y B un rango de un solo robot y exporte de nuevo.</translation>
    </message>
    <message>
        <source>The image %1 could not be created. Choose a different image format.</source>
        <translation>No se pudo crear la imagen %1. Elija otro formato de imagen.</translation>
    </message>
    <message>
        <source>Recordings…</source>
        <translation>Grabaciones…</translation>
    </message>
    <message>
        <source>The plots do not contain data from %1.</source>
        <translation>Las gráficas no contienen datos de %1.</translation>
    </message>
    <message>
        <source>● Waiting</source>
        <translation>● Espera</translation>
    </message>
    <message>
        <source>Waiting for the trigger. Files so far: %1</source>
        <translation>Esperando el disparador. Archivos hasta ahora: %1</translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation>Metadatos…</translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>Metadatos (%n campo)…</numerusform>
            <numerusform>Metadatos (%n campos)…</numerusform>
        </translation>
    </message>
    <message>
        <source>Trigger…</source>
        <translation>Disparador…</translation>
    </message>
    <message>
        <source>Trigger %1…</source>
        <translation>Disparador %1…</translation>
    </message>
    <message>
        <source>File name: %1…</source>
        <translation>Nombre de archivo: %1…</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation>%1 × tiempo real</translation>
    </message>
    <message>
        <source>Stop playback</source>
        <translation>Detener la reproducción</translation>
    </message>
    <message>
        <source>Cannot play: the page has no samples. Connect to a robot or open a recording first.</source>
        <translation>No se puede reproducir: la página no contiene muestras. Conecte primero un robot o abra una grabación.</translation>
    </message>
</context>
<context>
    <name>tiller::PlotMarks</name>
    <message>
        <source>%1 is above %2</source>
        <translation>%1 está por encima de %2</translation>
    </message>
    <message>
        <source>%1 is below %2</source>
        <translation>%1 está por debajo de %2</translation>
    </message>
</context>
<context>
    <name>tiller::PlotPages</name>
    <message>
        <source>Plot pages</source>
        <translation>Páginas de gráficos</translation>
    </message>
    <message>
        <source>Page name</source>
        <translation>Nombre de la página</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Página %1</translation>
    </message>
    <message>
        <source>Double-click to rename</source>
        <translation>Doble clic para renombrar</translation>
    </message>
</context>
<context>
    <name>tiller::PlotValues</name>
    <message>
        <source>Values at the cursors</source>
        <translation>Valores en los cursores</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Señal</translation>
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
        <translation>Mín</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Máx</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Std</source>
        <translation>Desv.</translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation>Pico a pico</translation>
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
        <translation>Haga clic en los gráficos para colocar el cursor A y luego el cursor B. La tabla muestra entonces estadísticas del rango entre los cursores.</translation>
    </message>
    <message>
        <source>%1 · calculating: %2</source>
        <translation>%1 · calculando: %2</translation>
    </message>
    <message>
        <source>Statistics are incomplete: %1</source>
        <translation>Las estadísticas están incompletas: %1</translation>
    </message>
    <message>
        <source>Slope per second</source>
        <translation>Pendiente por s</translation>
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
        <translation>%1 (a cero)</translation>
    </message>
    <message>
        <source>%1 %2 s · %3 %4</source>
        <translation>%1 %2 s · %3 %4</translation>
    </message>
    <message>
        <source>Fixed scale · double-click the axis to scale automatically</source>
        <translation>Escala fija · doble clic en el eje para ajustarla automáticamente</translation>
    </message>
    <message>
        <source>Zeroed (offset %1 %2)</source>
        <translation>Puesta a cero (desplazamiento %1 %2)</translation>
    </message>
    <message>
        <source>Plots over time</source>
        <translation>Gráficos en el tiempo</translation>
    </message>
    <message>
        <source>A and B place the cursors. Left and Right move the active cursor. Up and Down select the signal at the cursors. H hides the curve of this signal; Ctrl+Delete removes it. Plus and Minus change the time range, or the value scale with Ctrl; Ctrl+0 scales automatically. N adds a note, F shows all data, and End returns to the newest samples.</source>
        <translation>A y B colocan los cursores. Izquierda y Derecha mueven el cursor activo. Arriba y Abajo eligen la señal que leen. H oculta la curva de esta señal; Ctrl+Supr la quita. Más y Menos cambian el intervalo de tiempo, con Ctrl la escala de valores; Ctrl+0 la ajusta automáticamente. N añade una nota, F muestra todos los datos y Fin vuelve a las muestras más recientes.</translation>
    </message>
    <message>
        <source>A–B Δt %1 s</source>
        <translation>A–B Δt %1 s</translation>
    </message>
    <message>
        <source>Drop signals here</source>
        <translation>Suelte aquí las señales</translation>
    </message>
    <message>
        <source>No samples yet. Connect to a robot.</source>
        <translation>Aún sin muestras. Conéctese a un robot.</translation>
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
        <translation>Rotación sobre X (RX)</translation>
    </message>
    <message>
        <source>Rotation about Y (RY)</source>
        <translation>Rotación sobre Y (RY)</translation>
    </message>
    <message>
        <source>Rotation about Z (RZ)</source>
        <translation>Rotación sobre Z (RZ)</translation>
    </message>
</context>
<context>
    <name>tiller::PoseView</name>
    <message>
        <source>TCP at the flange</source>
        <translation>TCP en la brida</translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation>TCP a %1 de la brida</translation>
    </message>
    <message>
        <source>in %1 · %2</source>
        <translation>en %1 · %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>TCP pose in %1</source>
        <translation>Pose del TCP en %1</translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ₀: displacement from the zero position. Click to show the displacement since the start of the last motion.</source>
        <translation>orientación como en Ajustes. Δ₀: desplazamiento desde cero. Clic para mostrar el desplazamiento desde el inicio del último movimiento.</translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ: displacement since the start of the last motion. Click to set the displacement to zero.</source>
        <translation>orientación como en Ajustes. Δ: desplazamiento desde el inicio del último movimiento. Clic para poner aquí el cero.</translation>
    </message>
    <message>
        <source>TCP in the flange frame: %1</source>
        <translation>TCP en el sistema de la brida: %1</translation>
    </message>
</context>
<context>
    <name>tiller::PositionsPage</name>
    <message>
        <source>Joints °</source>
        <translation>Articulaciones °</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Enter a name for the position.</source>
        <translation>Introduzca un nombre para la posición.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renombrar «%1» a «%2»</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Posiciones</translation>
    </message>
    <message>
        <source>No positions yet.
Jog the arm to a position and press “Set home here” or “Add position”.</source>
        <translation>Aún no hay posiciones.
Mueva el brazo a una posición y pulse «Fijar inicio aquí» o «Añadir posición».</translation>
    </message>
    <message>
        <source>Safe height</source>
        <translation>Altura segura</translation>
    </message>
    <message>
        <source>%1. Press Return to apply the values. Only the stored position changes; the robot does not move.</source>
        <translation>%1. Pulse Intro para aplicar. Solo cambia la posición guardada; el robot no se mueve.</translation>
    </message>
    <message>
        <source>Height in the base frame. Above this height, the cell is free of obstacles, and the TCP may move sideways.</source>
        <translation>Altura en el sistema de la base por encima de la cual no hay obstáculos: ahí el TCP puede moverse lateralmente.</translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation>En el TCP</translation>
    </message>
    <message>
        <source>Set the safe height to the current TCP height</source>
        <translation>Fijar la altura segura a la altura actual del TCP</translation>
    </message>
    <message>
        <source>Set home here</source>
        <translation>Fijar inicio aquí</translation>
    </message>
    <message>
        <source>Add position</source>
        <translation>Añadir posición</translation>
    </message>
    <message>
        <source>Store the current position of the arm</source>
        <translation>Guardar la posición actual del brazo</translation>
    </message>
    <message>
        <source>Use as home</source>
        <translation>Usar como inicio</translation>
    </message>
    <message>
        <source>Use the selected position as home</source>
        <translation>Usar la posición seleccionada como inicio</translation>
    </message>
    <message>
        <source>Touch up position</source>
        <translation>Retocar la posición</translation>
    </message>
    <message>
        <source>Reset to default home</source>
        <translation>Restablecer el inicio predeterminado</translation>
    </message>
    <message>
        <source>Rename position</source>
        <translation>Renombrar posición</translation>
    </message>
    <message>
        <source>Delete position</source>
        <translation>Eliminar posición</translation>
    </message>
    <message>
        <source>Set “%1” to the current position of the arm?</source>
        <translation>¿Fijar «%1» en la posición actual del brazo?</translation>
    </message>
    <message>
        <source>The Home button will then move the arm to this position.</source>
        <translation>El botón Inicio moverá el brazo hasta allí.</translation>
    </message>
    <message>
        <source>Set home</source>
        <translation>Fijar inicio</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>Add the position “%1”</source>
        <translation>Añadir la posición «%1»</translation>
    </message>
    <message>
        <source>Select a position to touch up.</source>
        <translation>Seleccione una posición para retocar.</translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>¿Retocar «%1»?</translation>
    </message>
    <message>
        <source>Largest joint change: %1 %2.</source>
        <translation>Mayor cambio articular: %1 %2.</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Retocar</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>Retocar «%1»</translation>
    </message>
    <message>
        <source>Use “%1” as home</source>
        <translation>Usar «%1» como inicio</translation>
    </message>
    <message>
        <source>Select a position to use as home.</source>
        <translation>Seleccione una posición como inicio.</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>Eliminar «%1»</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>Cambiar «%1»</translation>
    </message>
    <message>
        <source>Set the safe height</source>
        <translation>Fijar la altura segura</translation>
    </message>
    <message>
        <source>Remove the safe height</source>
        <translation>Quitar la altura segura</translation>
    </message>
    <message>
        <source>The Home button moves the arm to the default home position: upright, without self-collision.</source>
        <translation>El botón Inicio lleva el brazo a la posición predeterminada: vertical, sin colisión consigo mismo.</translation>
    </message>
    <message>
        <source>%1: target of the Home button</source>
        <translation>%1: destino del botón Inicio</translation>
    </message>
    <message>
        <source>%1 · %2 %3 from the current position</source>
        <translation>%1 · %2 %3 desde aquí</translation>
    </message>
    <message>
        <source>A position named “%1” already exists. Choose a different name.</source>
        <translation>Ya existe una posición con el nombre «%1». Elija otro nombre.</translation>
    </message>
</context>
<context>
    <name>tiller::Practice</name>
    <message>
        <source>Start the simulated robot in the Robot menu first.</source>
        <translation>Inicie primero el robot simulado (menú Robot).</translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes first.</source>
        <translation>Encienda primero el brazo y libere los frenos.</translation>
    </message>
    <message>
        <source>The safety system has stopped the arm. Use “Recover…” first.</source>
        <translation>El sistema de seguridad detuvo el brazo. Use primero «Recuperar…».</translation>
    </message>
    <message>
        <source>Done. Press “Start” to repeat the task.</source>
        <translation>Hecho. Pulse Iniciar para repetir la tarea.</translation>
    </message>
    <message>
        <source>Press “Start”.</source>
        <translation>Pulse Iniciar.</translation>
    </message>
</context>
<context>
    <name>tiller::PracticeCard</name>
    <message>
        <source>Practice</source>
        <translation>Ejercicios</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Hecho</translation>
    </message>
    <message>
        <source>Force Fz in newtons</source>
        <translation>Fuerza Fz en newtons</translation>
    </message>
    <message>
        <source>Enter a value and press Return</source>
        <translation>Introduzca el valor, pulse Intro</translation>
    </message>
    <message>
        <source>Fz [N]</source>
        <translation>Fz [N]</translation>
    </message>
    <message>
        <source>Previous task</source>
        <translation>El ejercicio anterior</translation>
    </message>
    <message>
        <source>Next task</source>
        <translation>El ejercicio siguiente</translation>
    </message>
    <message>
        <source>Practice · %1 of %2</source>
        <translation>Ejercicios · %1 de %2</translation>
    </message>
    <message>
        <source>Starts or restarts the task</source>
        <translation>Inicia o reinicia la tarea</translation>
    </message>
    <message>
        <source>Continues with the next task</source>
        <translation>Continúa con la tarea siguiente</translation>
    </message>
    <message>
        <source>Available after the check above has passed</source>
        <translation>Disponible cuando se supere la comprobación de arriba</translation>
    </message>
</context>
<context>
    <name>tiller::PreflightPage</name>
    <message>
        <source>Good</source>
        <translation>Bien</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>No comprobado</translation>
    </message>
    <message>
        <source>Before you connect to %1</source>
        <translation>Antes de conectarse a %1</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Comprobaciones</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Mirar de nuevo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Conectar</translation>
    </message>
    <message>
        <source>Keep everyone out of reach of the arm.
Keep the emergency stop within reach: STOP in this window is a software stop.
Start slowly: the initial speed is %1.
Watch the arm, not the screen, while you hold a button.
Release the button to stop the arm.</source>
        <translation>Mantenga a todos fuera del alcance del brazo.
Tenga la parada de emergencia a su alcance: STOP en esta ventana es una parada por software.
Empiece despacio: la velocidad inicial es %1.
Mire el brazo, no la pantalla, mientras mantiene un botón.
Suelte el botón para detener el brazo.</translation>
    </message>
    <message>
        <source>Checking %1…</source>
        <translation>Comprobando %1…</translation>
    </message>
    <message>
        <source>Problems found</source>
        <translation>Se encontraron problemas</translation>
    </message>
    <message>
        <source>Ready, with warnings</source>
        <translation>Listo, con avisos</translation>
    </message>
    <message>
        <source>Everything is ready</source>
        <translation>Todo está listo</translation>
    </message>
    <message>
        <source>Connect anyway</source>
        <translation>Conectar de todos modos</translation>
    </message>
    <message>
        <source>If you connect anyway, the window shows the available data. The red items above may prevent Tiller from taking control or may stop a running motion.</source>
        <translation>Si se conecta de todos modos, la ventana muestra los datos disponibles. Los puntos en rojo de arriba pueden impedir tomar el control o detener un movimiento en curso.</translation>
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
        <translation>%1, desactivado</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>%1, running</source>
        <translation>%1, en ejecución</translation>
    </message>
    <message>
        <source>%1, breakpoint</source>
        <translation>%1, punto de parada</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, modificado</translation>
    </message>
</context>
<context>
    <name>tiller::ProgramTab</name>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>Show step</source>
        <translation>Mostrar paso</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Move steps</source>
        <translation>Mover pasos</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>Cambiar «%1»</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Más</translation>
    </message>
    <message>
        <source>Add steps, or edit the selected step</source>
        <translation>Añadir pasos o editar el paso seleccionado</translation>
    </message>
    <message>
        <source>Step fields</source>
        <translation>Campos del paso</translation>
    </message>
    <message>
        <source>New program</source>
        <translation>Programa nuevo</translation>
    </message>
    <message>
        <source>Rename program…</source>
        <translation>Cambiar el nombre del programa…</translation>
    </message>
    <message>
        <source>Delete program</source>
        <translation>Eliminar programa</translation>
    </message>
    <message>
        <source>Export script…</source>
        <translation>Exportar script…</translation>
    </message>
    <message>
        <source>Paste steps</source>
        <translation>Pegar pasos</translation>
    </message>
    <message>
        <source>Cut steps</source>
        <translation>Cortar pasos</translation>
    </message>
    <message>
        <source>Copy steps</source>
        <translation>Copiar pasos</translation>
    </message>
    <message>
        <source>Duplicate steps</source>
        <translation>Duplicar pasos</translation>
    </message>
    <message>
        <source>Delete steps</source>
        <translation>Eliminar pasos</translation>
    </message>
    <message>
        <source>Disable or enable steps</source>
        <translation>Desactivar o activar pasos</translation>
    </message>
    <message>
        <source>Move steps up</source>
        <translation>Subir pasos</translation>
    </message>
    <message>
        <source>Move steps down</source>
        <translation>Bajar pasos</translation>
    </message>
    <message>
        <source>Move steps into the section above</source>
        <translation>Mover pasos a la sección de arriba</translation>
    </message>
    <message>
        <source>Move steps out of the section</source>
        <translation>Sacar pasos de la sección</translation>
    </message>
    <message>
        <source>Drag steps into the program, or double-click them.</source>
        <translation>Arrastre pasos al programa o haga doble clic en ellos.</translation>
    </message>
    <message>
        <source>⚠ Step %1: %2</source>
        <translation>⚠ Paso %1: %2</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>The program can run. Press “Preview” to simulate it.</source>
        <translation>El programa se puede ejecutar. Pulse «Vista previa» para simularlo.</translation>
    </message>
    <message>
        <source>Add steps</source>
        <translation>Añadir pasos</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>Añadir «%1»</translation>
    </message>
    <message>
        <source>Rename program</source>
        <translation>Cambiar el nombre del programa</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Cambiar el nombre de «%1» a «%2»</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>Eliminar «%1»</translation>
    </message>
    <message>
        <source>Disable steps</source>
        <translation>Desactivar pasos</translation>
    </message>
    <message>
        <source>Enable steps</source>
        <translation>Activar pasos</translation>
    </message>
    <message>
        <source>Simulating…</source>
        <translation>Simulando…</translation>
    </message>
    <message>
        <source>Simulated: the program takes %1 s. No problems found.</source>
        <translation>Simulado: el programa tarda %1 s. No se encontraron problemas.</translation>
    </message>
    <message numerus="yes">
        <source>⚠ Simulated: %n problem(s) found. %1</source>
        <translation>
            <numerusform>⚠ Simulado: se encontró %n problema. %1</numerusform>
            <numerusform>⚠ Simulado: se encontraron %n problemas. %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Export script</source>
        <translation>Exportar script</translation>
    </message>
    <message>
        <source>URScript (*.script)</source>
        <translation>URScript (*.script)</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportado a %1</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Iniciando…</translation>
    </message>
    <message>
        <source>Running step %1 (%2)</source>
        <translation>Ejecutando el paso %1 (%2)</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En ejecución</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Parando…</translation>
    </message>
    <message>
        <source>Paused before step %1 (%2)</source>
        <translation>En pausa antes del paso %1 (%2)</translation>
    </message>
    <message>
        <source>Pausing after step %1 (%2)</source>
        <translation>Se pausará tras el paso %1 (%2)</translation>
    </message>
    <message>
        <source>Simulated: two cycles of the endless program take %1 s. No problems found.</source>
        <translation>Simulado: dos ciclos del programa sin fin duran %1 s. No se han encontrado problemas.</translation>
    </message>
    <message>
        <source>Check recoverability</source>
        <translation>Comprobar reanudación</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>La comprobación se ha cancelado.</translation>
    </message>
    <message>
        <source>Cancel check</source>
        <translation>Cancelar comprobación</translation>
    </message>
    <message>
        <source>In simulation, the program can continue after a stop in %1 of %2 steps.</source>
        <translation>En la simulación, el programa puede continuar tras una parada en %1 de %2 pasos.</translation>
    </message>
    <message>
        <source>Add or remove breakpoints</source>
        <translation>Poner o quitar puntos de parada</translation>
    </message>
    <message>
        <source>⚠ The program cannot pause before this step.</source>
        <translation>⚠ El programa no puede hacer una pausa antes de este paso.</translation>
    </message>
    <message>
        <source>New breakpoints take effect at the next start.</source>
        <translation>Los puntos de parada nuevos se aplican en el próximo inicio.</translation>
    </message>
    <message>
        <source>The program is running, so it cannot be deleted. Stop the program first.</source>
        <translation>El programa se está ejecutando y no se puede eliminar. Pare primero el programa.</translation>
    </message>
    <message>
        <source>Paused on the robot in step %1 (%2)</source>
        <translation>En pausa en el robot en el paso %1 (%2)</translation>
    </message>
    <message>
        <source>Program “%1” deleted. Ctrl+Z restores it.</source>
        <translation>Programa «%1» eliminado. Ctrl+Z lo restaura.</translation>
    </message>
    <message>
        <source>Import program…</source>
        <translation>Importar programa…</translation>
    </message>
    <message>
        <source>Import program</source>
        <translation>Importar programa</translation>
    </message>
    <message>
        <source>Robot programs (*.script *.urp *.urpx);;All files (*)</source>
        <translation>Programas de robot (*.script *.urp *.urpx);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <translation>Importando %1…</translation>
    </message>
    <message>
        <source>Import “%1”</source>
        <translation>Importar «%1»</translation>
    </message>
    <message>
        <source>Imported “%1”.</source>
        <translation>«%1» importado.</translation>
    </message>
    <message>
        <source>⚠ The import failed. The project is unchanged.</source>
        <translation>⚠ La importación ha fallado. El proyecto no ha cambiado.</translation>
    </message>
    <message>
        <source>Step %1 (%2)</source>
        <translation>Paso %1 (%2)</translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation>Sin comprobar: %1.</translation>
    </message>
    <message>
        <source>Checking recoverability…</source>
        <translation>Comprobando la reanudación…</translation>
    </message>
    <message>
        <source>⚠ Correct the problems in the program first.</source>
        <translation>⚠ Corrija primero el programa.</translation>
    </message>
    <message>
        <source>Outputs were changed after the stop, so the program cannot continue. Run the program from the beginning.</source>
        <translation>Las salidas se cambiaron después de la parada, así que el programa no puede continuar. Ejecútelo desde el principio.</translation>
    </message>
    <message>
        <source>The program was changed after the stop, so it cannot continue. Run the program from the beginning.</source>
        <translation>El programa se cambió después de la parada, así que no puede continuar. Ejecútelo desde el principio.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) changed because the project changed. Press “Preview” to simulate the program.</source>
        <translation>
            <numerusform>%n paso ha cambiado con el proyecto. Pulse «Vista previa» para simular el programa.</numerusform>
            <numerusform>%n pasos han cambiado con el proyecto. Pulse «Vista previa» para simular el programa.</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused before step %1 (%2) because of the maximum hold time. Hold “Continue (hold)” to continue.</source>
        <translation>En pausa antes del paso %1 (%2) por el tiempo máximo de pulsación. Mantenga pulsado «Continuar (mantener)» para continuar.</translation>
    </message>
    <message>
        <source>Running step %1 (%2). Joint moves are slow because the preview did not run the whole program from this position.</source>
        <translation>Ejecutando el paso %1 (%2). Los movimientos articulares son lentos porque la vista previa no ejecutó todo el programa desde esta posición.</translation>
    </message>
    <message>
        <source>Not run: %1.</source>
        <translation>No ejecutado: %1.</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectDocument</name>
    <message>
        <source>Delete “%1”</source>
        <translation>Eliminar «%1»</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n waypoints</source>
        <translation>
            <numerusform>Eliminar %n punto de paso</numerusform>
            <numerusform>Eliminar %n puntos de paso</numerusform>
        </translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>Cambiar el orden</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFiles</name>
    <message>
        <source>The damaged project file was kept as %1.</source>
        <translation>El archivo de proyecto dañado se guardó como %1</translation>
    </message>
    <message>
        <source>The project could not be saved</source>
        <translation>No se pudo guardar el proyecto</translation>
    </message>
    <message>
        <source>%1. Update Tiller to open the file. The file was not changed.</source>
        <translation>%1. Actualice Tiller para abrirlo. El archivo no se modificó.</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Abrir proyecto</translation>
    </message>
    <message>
        <source>Tiller projects (*.tiller)</source>
        <translation>Proyectos de Tiller (*.tiller)</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Guardar proyecto</translation>
    </message>
    <message>
        <source>The project could not be opened</source>
        <translation>No se pudo abrir el proyecto</translation>
    </message>
    <message>
        <source>Opened a copy of “%1”. Save the copy to a file to keep changes.</source>
        <translation>Se abrió una copia de «%1». Guárdela en un archivo para conservar los cambios.</translation>
    </message>
    <message>
        <source>“%1” is a copy with unsaved changes.</source>
        <translation>«%1» es una copia con cambios sin guardar.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Descartar los cambios</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation>%1 está dañado</translation>
    </message>
    <message>
        <source>%1. Readable waypoints: %2, unreadable: %3. The damaged file is kept.</source>
        <translation>%1. Puntos de paso legibles: %2, no legibles: %3. El archivo dañado se conserva.</translation>
    </message>
    <message numerus="yes">
        <source>Open %n waypoints</source>
        <translation>
            <numerusform>Abrir %n punto de paso</numerusform>
            <numerusform>Abrir %n puntos de paso</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes are saved to %1 again.</source>
        <translation>Se reanudó el guardado de %1</translation>
    </message>
    <message>
        <source>The other window closed %1. This window saves changes again.</source>
        <translation>La otra ventana cerró %1. Esta ventana vuelve a guardar los cambios.</translation>
    </message>
    <message>
        <source>%1 is open in another window</source>
        <translation>%1 está abierto en otra ventana</translation>
    </message>
    <message>
        <source>Opened by %1. Changes in this window are not saved to the file until you take over the project.</source>
        <translation>Abierto por %1. Los cambios de esta ventana no se guardan en el archivo hasta que se haga cargo del proyecto.</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Hacerse cargo</translation>
    </message>
    <message>
        <source>Save as a copy</source>
        <translation>Guardar como copia</translation>
    </message>
    <message>
        <source>View only</source>
        <translation>Solo ver</translation>
    </message>
    <message>
        <source>Another window or program has changed %1</source>
        <translation>Otra ventana o programa ha cambiado %1</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>Conservar ambos</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>Decidir más tarde</translation>
    </message>
    <message>
        <source>Reloaded %1</source>
        <translation>%1 recargado</translation>
    </message>
    <message>
        <source>The project in this window is now %1.</source>
        <translation>El proyecto de esta ventana es ahora %1</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>Proyecto sin título</translation>
    </message>
    <message>
        <source>Unsaved work can be recovered</source>
        <translation>Se puede recuperar trabajo sin guardar</translation>
    </message>
    <message>
        <source>“%1” was changed on %2 and not saved to a file.</source>
        <translation>«%1» se cambió el %2 y no se guardó en un archivo.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Ask again next time</source>
        <translation>Preguntar la próxima vez</translation>
    </message>
    <message>
        <source>%1 has unsaved changes. %2</source>
        <translation>%1 tiene cambios sin guardar. %2</translation>
    </message>
    <message>
        <source>The project has unsaved changes.</source>
        <translation>El proyecto tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>“Keep both” saves the project of this window to a second file. “Reload” shows the new content. Tiller then offers to restore the unsaved changes at the next start.</source>
        <translation>«Conservar ambos» guarda el proyecto de esta ventana en un segundo archivo. «Recargar» muestra el contenido nuevo; los cambios sin guardar de esta ventana se ofrecen en el próximo inicio.</translation>
    </message>
    <message>
        <source>Unreadable boxes and planes of the cell: %1. Collisions with these objects are not prevented.</source>
        <translation>Cajas y planos ilegibles de la celda: %1. No se evitan colisiones con ellos.</translation>
    </message>
    <message>
        <source>The unsaved work in “%1” will be deleted. This cannot be undone.</source>
        <translation>Se eliminará el trabajo no guardado de «%1». No se puede deshacer.</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Proyecto nuevo</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 guardado</translation>
    </message>
    <message>
        <source>The project could not be taken over</source>
        <translation>No se pudo tomar el proyecto</translation>
    </message>
    <message>
        <source>%1 already exists. Choose a different name for the new project.</source>
        <translation>%1 ya existe. Elija otro nombre para el proyecto nuevo.</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFit</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 y %n más</numerusform>
            <numerusform>%1 y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>TCP of %1</source>
        <translation>TCP de %1</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but a %2 is connected. The same joint positions lead to different poses.</source>
        <translation>El proyecto se enseñó con un %1, pero está conectado un %2. Las mismas posiciones articulares llevan a poses distintas.</translation>
    </message>
    <message>
        <source>The project uses the TCP “%1”. The active TCP of the robot differs by %2.</source>
        <translation>El proyecto usa el TCP «%1». El TCP activo del robot difiere en %2.</translation>
    </message>
    <message>
        <source>The project matches the connected robot.</source>
        <translation>El proyecto es compatible con el robot conectado.</translation>
    </message>
    <message>
        <source>No robot is connected. Connect the robot that belongs to this project.</source>
        <translation>No hay ningún robot conectado. Conecte el robot de este proyecto.</translation>
    </message>
    <message>
        <source>Keep poses</source>
        <translation>Conservar poses</translation>
    </message>
    <message>
        <source>Keep joints</source>
        <translation>Conservar articulaciones</translation>
    </message>
    <message>
        <source>TCP differs from the project</source>
        <translation>El TCP difiere del proyecto</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>Poner «%1» en el robot</translation>
    </message>
    <message>
        <source>Keep the robot&apos;s TCP</source>
        <translation>Conservar el TCP del robot</translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same poses</source>
        <translation>Convertir de %1 a %2, conservar poses</translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same joint positions</source>
        <translation>Convertir de %1 a %2, conservar articulaciones</translation>
    </message>
    <message>
        <source>Out of reach: %1.</source>
        <translation>Fuera de alcance: %1.</translation>
    </message>
    <message>
        <source>Removed because they are out of reach: %1. Press Ctrl+Z to restore them.</source>
        <translation>Eliminados por estar fuera de alcance: %1. Deshacer los recupera.</translation>
    </message>
    <message>
        <source>Some positions are out of reach</source>
        <translation>Algunas posiciones están fuera de alcance</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>The robot model is not known yet. Wait until the robot reports the model.</source>
        <translation>Aún no se conoce el modelo del robot. Espere a que el robot lo comunique.</translation>
    </message>
    <message>
        <source>Project for a different robot model</source>
        <translation>Proyecto para otro modelo de robot</translation>
    </message>
    <message>
        <source>“Keep poses” recalculates the joint positions; the tool reaches the same poses. “Keep joints” keeps the arm configuration; the tool reaches different poses. Until you decide, moves to positions in the project are blocked.</source>
        <translation>«Conservar poses» recalcula las posiciones articulares; la herramienta alcanza las mismas poses. «Conservar articulaciones» mantiene la configuración del brazo; la herramienta alcanza otras poses. Hasta que decida, los movimientos a posiciones del proyecto están bloqueados.</translation>
    </message>
    <message>
        <source>With the robot&apos;s TCP, the flange moves to the same poses as taught, but the TCP does not. Until you decide, moves to positions in the project are blocked.</source>
        <translation>Con el TCP del robot, la brida alcanza las poses enseñadas, pero el TCP no. Hasta que decida, los movimientos a posiciones del proyecto están bloqueados.</translation>
    </message>
    <message>
        <source>Moves to positions in this project are blocked</source>
        <translation>Los movimientos a posiciones de este proyecto están bloqueados</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectStore</name>
    <message>
        <source>%1 — a copy, not saved to a file</source>
        <translation>%1 — una copia, no guardada en un archivo</translation>
    </message>
    <message>
        <source>Project not saved to a file</source>
        <translation>Proyecto no guardado en un archivo</translation>
    </message>
    <message>
        <source>disk full</source>
        <translation>disco lleno</translation>
    </message>
    <message>
        <source>%1 — not saved: %2</source>
        <translation>%1 — no guardado: %2</translation>
    </message>
    <message>
        <source>%1 — saving…</source>
        <translation>%1 — guardando…</translation>
    </message>
    <message>
        <source>%1 — saved</source>
        <translation>%1 — guardado</translation>
    </message>
    <message>
        <source>No file is selected for the project. Save the project to a file first.</source>
        <translation>No hay ningún archivo elegido para el proyecto. Guarde primero el proyecto en un archivo.</translation>
    </message>
    <message>
        <source>%1 — open in another window; changes here are not saved</source>
        <translation>%1 — abierto en otra ventana, los cambios de aquí no se guardan</translation>
    </message>
    <message>
        <source>%1 — changed by another program; changes here are not saved</source>
        <translation>%1 — cambiado por otro programa, los cambios de aquí no se guardan</translation>
    </message>
    <message>
        <source>Unsaved project</source>
        <translation>Proyecto sin guardar</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>otro programa</translation>
    </message>
    <message>
        <source>%1 — new</source>
        <translation>%1 — nuevo</translation>
    </message>
    <message>
        <source>%1 is open in another window (%2). Close the project in that window, or save under a different name.</source>
        <translation>%1 está abierto en otra ventana (%2). Ciérrelo allí o guarde con otro nombre.</translation>
    </message>
    <message>
        <source>%1 was changed by another program. Reload the project, or save it under a different name.</source>
        <translation>Otro programa ha cambiado %1. Vuelva a cargarlo o guarde con otro nombre.</translation>
    </message>
</context>
<context>
    <name>tiller::RangeStatisticsCache</name>
    <message>
        <source>The range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation>El intervalo contiene muestras de robots distintos. Coloque los cursores A y B en los datos de un solo robot.</translation>
    </message>
</context>
<context>
    <name>tiller::RecordingsDialog</name>
    <message>
        <source>Recordings</source>
        <translation>Grabaciones</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Elegir la carpeta</translation>
    </message>
    <message>
        <source>Search recordings</source>
        <translation>Buscar grabaciones</translation>
    </message>
    <message>
        <source>Search name, date, metadata and notes</source>
        <translation>Buscar en nombre, fecha, metadatos y notas</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>Metadatos</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>This folder contains no recordings.</source>
        <translation>Esta carpeta no contiene grabaciones.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n recording(s)</source>
        <translation>
            <numerusform>%1 de %n grabación</numerusform>
            <numerusform>%1 de %n grabaciones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reading %n file(s)…</source>
        <translation>
            <numerusform>leyendo %n archivo…</numerusform>
            <numerusform>leyendo %n archivos…</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder with recordings</source>
        <translation>Carpeta con grabaciones</translation>
    </message>
</context>
<context>
    <name>tiller::RecoveryPage</name>
    <message>
        <source>Recovery</source>
        <translation>Recuperación</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Fuerza en el TCP</translation>
    </message>
    <message>
        <source>Joint current</source>
        <translation>Corriente de articulación</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>Velocidad del TCP</translation>
    </message>
    <message>
        <source>Waiting for data from the robot…</source>
        <translation>Esperando datos del robot…</translation>
    </message>
    <message>
        <source>Stopped at X %1, Y %2, Z %3.</source>
        <translation>Detenido en X %1, Y %2, Z %3.</translation>
    </message>
    <message>
        <source>Suspected joint: %1 (largest deviation from its target current).</source>
        <translation>Articulación sospechosa: %1 (mayor desviación respecto a su corriente de consigna).</translation>
    </message>
    <message>
        <source> (%1 s)</source>
        <translation> (%1 s)</translation>
    </message>
    <message>
        <source>Tick the items that you have checked.</source>
        <translation>Marque los puntos que ha comprobado.</translation>
    </message>
    <message>
        <source>Command sent; waiting for the robot…</source>
        <translation>Orden enviada; esperando al robot…</translation>
    </message>
</context>
<context>
    <name>tiller::RegisterPanel</name>
    <message>
        <source>General purpose registers</source>
        <translation>Registros de uso general</translation>
    </message>
    <message>
        <source>Int %1</source>
        <translation>Entero %1</translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation>Real %1</translation>
    </message>
    <message>
        <source>Int</source>
        <translation>Entero</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Real</translation>
    </message>
    <message>
        <source>Bit</source>
        <translation>Bit</translation>
    </message>
    <message>
        <source>Input register type</source>
        <translation>Tipo del registro de entrada</translation>
    </message>
    <message>
        <source>Input register number</source>
        <translation>Número del registro de entrada</translation>
    </message>
    <message>
        <source>Input register value</source>
        <translation>Valor para el registro de entrada</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Escribir</translation>
    </message>
</context>
<context>
    <name>tiller::ReplayBand</name>
    <message>
        <source>Replay</source>
        <translation>Reproducción</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Volver a lo actual</translation>
    </message>
    <message>
        <source>Show the current state of the robot. The recording stays open in the plots.</source>
        <translation>Mostrar el estado actual del robot. La grabación sigue abierta en los gráficos.</translation>
    </message>
</context>
<context>
    <name>tiller::RobotPopup</name>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Mensaje</translation>
    </message>
    <message>
        <source>Popup on the robot</source>
        <translation>Aviso en el robot</translation>
    </message>
    <message>
        <source>Tiller could not close the popup. Close the popup on the teach pendant.</source>
        <translation>Tiller no pudo cerrar la ventana emergente. Ciérrela en la consola portátil.</translation>
    </message>
    <message>
        <source>No data from the robot. Close the popup on the teach pendant.</source>
        <translation>Sin datos del robot. Cierre la ventana emergente en la consola portátil.</translation>
    </message>
    <message numerus="yes">
        <source>%n more popup(s) on the robot.</source>
        <translation>
            <numerusform>%n más en el robot.</numerusform>
            <numerusform>%n más en el robot.</numerusform>
        </translation>
    </message>
    <message>
        <source>A waiting program continues when the popup is closed: keep clear of the arm.</source>
        <translation>Un programa en espera continúa al cerrar la ventana emergente: manténgase alejado del brazo.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ocultar</translation>
    </message>
    <message>
        <source>Close the popup on the robot</source>
        <translation>Cerrar el aviso en el robot</translation>
    </message>
    <message>
        <source>Hide the popup</source>
        <translation>Ocultar el aviso</translation>
    </message>
    <message>
        <source>Read the popup first.</source>
        <translation>Lea primero el mensaje emergente.</translation>
    </message>
    <message>
        <source>The popup is being closed.</source>
        <translation>Se está cerrando el mensaje emergente.</translation>
    </message>
</context>
<context>
    <name>tiller::RobotSession</name>
    <message>
        <source>Stopped: %1 (%2 ms, %3)</source>
        <translation>Detenido: %1 (%2 ms, %3)</translation>
    </message>
    <message>
        <source>Connecting to %1 (%2)</source>
        <translation>Conectando con %1 (%2)</translation>
    </message>
    <message>
        <source>Disconnected from %1</source>
        <translation>Desconectado de %1</translation>
    </message>
    <message>
        <source>In control</source>
        <translation>Con control</translation>
    </message>
    <message>
        <source>Taking control was cancelled by a stop.</source>
        <translation>Una parada canceló la toma de control.</translation>
    </message>
    <message>
        <source>Connected to %1</source>
        <translation>Conectado con %1</translation>
    </message>
    <message>
        <source>Safety mode is Normal again</source>
        <translation>El modo de seguridad vuelve a ser «Normal»</translation>
    </message>
    <message>
        <source>Program: %1</source>
        <translation>Programa: %1</translation>
    </message>
    <message>
        <source>Program error on line %1, column %2: %3</source>
        <translation>Error de programa en línea %1, columna %2: %3</translation>
    </message>
    <message>
        <source>Popup on the robot: %1 %2</source>
        <translation>Aviso en el robot: %1 %2</translation>
    </message>
    <message>
        <source>The program on the robot is waiting for a response on the teach pendant: %1</source>
        <translation>El programa del robot espera una respuesta en la consola portátil: %1</translation>
    </message>
    <message>
        <source>Not connected to a robot.</source>
        <translation>Sin conexión con un robot.</translation>
    </message>
    <message>
        <source>Waiting for data from %1.</source>
        <translation>Esperando datos de %1.</translation>
    </message>
    <message>
        <source>Connecting to %1…</source>
        <translation>Conectando con %1…</translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically; motion does not resume.</source>
        <translation>Sin datos del robot. Se reconecta automáticamente; el movimiento no se reanuda.</translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation>Los datos del robot se retrasan. Esperando datos nuevos.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Tomando el control…</translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. STOP still works.</source>
        <translation>Solo supervisión: esta ventana no cambia nada en el robot. STOP sigue funcionando.</translation>
    </message>
    <message>
        <source>“Monitor only” is off. Commands to the robot are enabled.</source>
        <translation>«Solo supervisión» está desactivado. Se permiten órdenes al robot.</translation>
    </message>
    <message>
        <source>%1: refused. %2</source>
        <translation>%1: rechazado. %2</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Tomar el control</translation>
    </message>
    <message>
        <source>Control was lost: the control connection did not respond for 0.5 s or was closed. STOP, Space and Esc still stop the robot. Take control again.</source>
        <translation>Se ha perdido el control: la conexión de control no respondió durante 0,5 s o se cerró. STOP, Espacio y Esc siguen deteniendo el robot. Tome el control de nuevo.</translation>
    </message>
    <message numerus="yes">
        <source>The robot is sending too many messages. %n messages were not shown.</source>
        <translation>
            <numerusform>El robot envía demasiados mensajes. %n mensaje no se mostró.</numerusform>
            <numerusform>El robot envía demasiados mensajes. %n mensajes no se mostraron.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move refused: %1.</source>
        <translation>Movimiento rechazado: %1.</translation>
    </message>
    <message>
        <source>Moves are refused. %1.</source>
        <translation>Los movimientos se rechazan. %1.</translation>
    </message>
    <message>
        <source>No data from the robot: the arm may be moving. Reconnecting automatically.</source>
        <translation>Sin datos del robot: el brazo puede estar en movimiento. Se reconecta automáticamente.</translation>
    </message>
    <message>
        <source>A program is running. Wait until the program ends, or stop the program.</source>
        <translation>Se está ejecutando un programa. Espere a que termine o deténgalo.</translation>
    </message>
    <message>
        <source>Stopping the other client&apos;s program to take control.</source>
        <translation>Se detiene el programa del otro cliente para tomar el control.</translation>
    </message>
    <message>
        <source>The program on the robot is paused.</source>
        <translation>El programa del robot está en pausa.</translation>
    </message>
    <message>
        <source>Robot mode: %1</source>
        <translation>Modo del robot: %1</translation>
    </message>
    <message>
        <source>Stopped: %1 (%2)</source>
        <translation>Parado: %1 (%2)</translation>
    </message>
    <message>
        <source>Not stopped: a program is still running (%1). Press STOP again.</source>
        <translation>No se ha detenido: un programa sigue en ejecución (%1). Pulse STOP de nuevo.</translation>
    </message>
    <message>
        <source>Not stopped: the arm is still moving (%1). Press STOP again.</source>
        <translation>No se ha parado: el brazo se mueve (%1). Pulse STOP de nuevo.</translation>
    </message>
    <message>
        <source>The robot at %1 is a %2 now. It was a %3 before.</source>
        <translation>El robot en %1 es ahora un %2. Antes era un %3.</translation>
    </message>
    <message>
        <source>A program from another client has replaced the running program.</source>
        <translation>Un programa de otro cliente ha sustituido al programa en ejecución.</translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot. Taking control ends that program.</source>
        <translation>Un programa de otro cliente se ha hecho con el robot. Tomar el control lo termina.</translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot, and control was lost. Taking control again ends that program.</source>
        <translation>Un programa de otro cliente se ha hecho con el robot y se perdió el control. Volver a tomar el control termina ese programa.</translation>
    </message>
    <message>
        <source>A program from another client is running on the robot.</source>
        <translation>En el robot se ejecuta un programa de otro cliente.</translation>
    </message>
    <message>
        <source>while moving to point %1 of %2: %3</source>
        <translation>de camino al punto %1 de %2: %3</translation>
    </message>
    <message>
        <source>The program from the other client has ended.</source>
        <translation>El programa del otro cliente ha terminado.</translation>
    </message>
    <message>
        <source>The program started while Tiller was not connected, at most %1 s before this entry.</source>
        <translation>El programa se inició sin conexión con Tiller, como máximo %1 s antes de esta entrada.</translation>
    </message>
</context>
<context>
    <name>tiller::RobotiqLink</name>
    <message>
        <source>Connecting to the gripper…</source>
        <translation>Conectando con la pinza…</translation>
    </message>
    <message>
        <source>The gripper does not send any values. Power on the arm. If the problem persists, check the gripper cable at the wrist.</source>
        <translation>La pinza no envía valores. Encienda el brazo; si el problema continúa, compruebe el cable de la pinza en la muñeca.</translation>
    </message>
    <message>
        <source>The gripper responds again.</source>
        <translation>La pinza responde de nuevo.</translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation>La pinza está activa.</translation>
    </message>
    <message>
        <source>The gripper was not activated. Check that nothing blocks its fingers, then press “Activate” again.</source>
        <translation>La pinza no se activó. Compruebe que nada bloquea sus dedos y pulse Activar de nuevo.</translation>
    </message>
    <message>
        <source>The gripper holds an object (%1 open).</source>
        <translation>La pinza sujeta un objeto (%1 abierta).</translation>
    </message>
    <message>
        <source>The gripper lost the object.</source>
        <translation>La pinza perdió el objeto.</translation>
    </message>
    <message>
        <source>Gripper: activate</source>
        <translation>Pinza: activar</translation>
    </message>
    <message>
        <source>%1 failed. %2</source>
        <translation>%1 falló. %2</translation>
    </message>
    <message>
        <source>No gripper service responds at %1:%2. Install Robotiq&apos;s URCap on the robot and select the gripper in the robot&apos;s installation.</source>
        <translation>Ningún servicio de pinza responde en %1:%2. Instale el URCap de Robotiq en el robot y seleccione la pinza en su Instalación.</translation>
    </message>
    <message>
        <source>The gripper is not responding. Check the cable at the wrist and the gripper settings on the Installation tab of the teach pendant. If the problem persists, restart the robot.</source>
        <translation>La pinza no responde. Compruebe el cable en la muñeca y los ajustes de la pinza en la pestaña Instalación de la consola. Si el problema continúa, reinicie el robot.</translation>
    </message>
    <message>
        <source>The gripper did not accept the command. Activate the gripper. If it is already active, check its settings on the Installation tab of the teach pendant.</source>
        <translation>La pinza no aceptó la orden. Actívela. Si ya está activa, compruebe sus ajustes en la pestaña Instalación de la consola.</translation>
    </message>
    <message>
        <source>The gripper is activating; the command runs afterwards.</source>
        <translation>La pinza se está activando; la orden se ejecuta después.</translation>
    </message>
    <message>
        <source>The gripper received a motion command before it was active. Press “Activate”.</source>
        <translation>La pinza recibió una orden de movimiento antes de estar activa. Pulse Activar.</translation>
    </message>
    <message>
        <source>The gripper is too hot. Let it cool down, then press “Activate”.</source>
        <translation>La pinza está demasiado caliente. Déjela enfriar y pulse Activar.</translation>
    </message>
    <message>
        <source>The gripper received no command for one second. Check its cable at the wrist, then press “Activate”.</source>
        <translation>La pinza no recibió ninguna orden durante un segundo. Compruebe su cable en la muñeca y pulse Activar.</translation>
    </message>
    <message>
        <source>The supply voltage of the gripper is too low. Set the tool voltage to 24 V, then press “Activate”.</source>
        <translation>La tensión de alimentación de la pinza es demasiado baja. Ajuste la tensión de la herramienta a 24 V y pulse Activar.</translation>
    </message>
    <message>
        <source>The automatic release of the gripper is in progress. Wait until it is complete, then press “Activate”.</source>
        <translation>La liberación automática de la pinza está en curso. Espere a que termine y pulse Activar.</translation>
    </message>
    <message>
        <source>The automatic release of the gripper is complete. Press “Activate”.</source>
        <translation>La liberación automática de la pinza ha terminado. Pulse Activar.</translation>
    </message>
    <message>
        <source>The gripper has an internal fault. Press “Activate”. If the fault returns, contact Robotiq.</source>
        <translation>La pinza tiene un fallo interno. Pulse Activar; si el fallo vuelve, contacte con Robotiq.</translation>
    </message>
    <message>
        <source>Activation failed. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation>La activación falló. Compruebe que nada bloquea los dedos y pulse Activar.</translation>
    </message>
    <message>
        <source>The gripper draws too much current. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation>La pinza consume demasiada corriente. Compruebe que nada bloquea los dedos y pulse Activar.</translation>
    </message>
    <message>
        <source>The gripper reports fault %1. Press “Activate”. If the fault returns, see the gripper manual.</source>
        <translation>La pinza comunica el fallo %1. Pulse Activar; si el fallo vuelve, consulte su manual.</translation>
    </message>
    <message>
        <source>The robot closed the connection to the gripper and may be restarting. Tiller reconnects automatically; the gripper continues to hold its object.</source>
        <translation>El robot cerró la conexión con la pinza y puede estar reiniciándose. Tiller se reconecta automáticamente; la pinza mantiene el agarre.</translation>
    </message>
</context>
<context>
    <name>tiller::RouteRunner</name>
    <message>
        <source>The route has no waypoints. Teach or select waypoints first.</source>
        <translation>La ruta no tiene puntos de paso. Enseñe o seleccione primero puntos de paso.</translation>
    </message>
    <message>
        <source>A waypoint of the route was deleted from the project. Select the waypoints of the route again.</source>
        <translation>Se eliminó del proyecto un punto de paso de la ruta. Seleccione de nuevo los puntos de paso de la ruta.</translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation>«%1»: %2</translation>
    </message>
    <message>
        <source>A loop requires at least two waypoints. Select more waypoints, or clear “Loop”.</source>
        <translation>Un bucle necesita al menos dos puntos de paso. Seleccione más puntos o desactive el bucle.</translation>
    </message>
    <message>
        <source>There is no waypoint before the first waypoint of the route.</source>
        <translation>No hay ningún punto de paso antes del primero de la ruta.</translation>
    </message>
</context>
<context>
    <name>tiller::RunBar</name>
    <message>
        <source>Run (hold)</source>
        <translation>Ejecutar (mantener)</translation>
    </message>
    <message>
        <source>Run the program (hold)</source>
        <translation>Ejecutar el programa, mantener</translation>
    </message>
    <message>
        <source>Move to start (hold)</source>
        <translation>Al inicio (mantener)</translation>
    </message>
    <message>
        <source>Move to the start position (hold)</source>
        <translation>Mover a la posición inicial, mantener</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecutar</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>No program is selected. Create or select a program first.</source>
        <translation>No hay ningún programa seleccionado. Cree o seleccione uno primero.</translation>
    </message>
    <message>
        <source>Stops the program</source>
        <translation>Para el programa</translation>
    </message>
    <message>
        <source>Runs the program at the programmed speed until it ends or is stopped. The arm also stops when Tiller closes or the connection is lost.</source>
        <translation>Ejecuta el programa a la velocidad programada hasta que termine o se pare. El brazo también se para si se cierra Tiller o se pierde la conexión.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Finish cycle</source>
        <translation>Acabar ciclo</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reanudar</translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation>No se ejecuta ningún programa.</translation>
    </message>
    <message>
        <source>Continues the program</source>
        <translation>Continúa el programa</translation>
    </message>
    <message>
        <source>Pauses the program before its next step</source>
        <translation>Pausa el programa antes del paso siguiente</translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation>Pause primero el programa.</translation>
    </message>
    <message>
        <source>Runs one step and then pauses the program</source>
        <translation>Ejecuta un paso y luego pausa el programa</translation>
    </message>
    <message>
        <source>The program has no endless loop.</source>
        <translation>El programa no tiene un bucle sin fin.</translation>
    </message>
    <message>
        <source>Ends the program before the next cycle of its endless loop</source>
        <translation>Termina el programa antes del siguiente ciclo de su bucle sin fin</translation>
    </message>
    <message>
        <source>Start from here</source>
        <translation>Desde aquí</translation>
    </message>
    <message>
        <source>Select one step.</source>
        <translation>Seleccione un paso.</translation>
    </message>
    <message>
        <source>Moves all joints to the start position while the button is held</source>
        <translation>Mueve todas las articulaciones a la posición inicial mientras se mantiene el botón</translation>
    </message>
    <message>
        <source>Continue at %1</source>
        <translation>Continuar en %1</translation>
    </message>
    <message>
        <source>Continue (hold)</source>
        <translation>Continuar (mantener)</translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation>El programa está en pausa en el robot. Reanúdelo en la consola portátil.</translation>
    </message>
    <message>
        <source>Run program</source>
        <translation>Ejecutar programa</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>The value of “%1” is being changed.</source>
        <translation>Se está cambiando el valor de «%1».</translation>
    </message>
    <message>
        <source>Continue program</source>
        <translation>Continuar programa</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>From step %1 ✕</source>
        <translation>Desde %1 ✕</translation>
    </message>
    <message>
        <source>Starts the program at the selected step. Move the arm to the start position first.</source>
        <translation>Inicia el programa en el paso seleccionado. Mueva antes el brazo a la posición inicial.</translation>
    </message>
    <message>
        <source>Hold “Continue (hold)” to continue.</source>
        <translation>Mantenga pulsado «Continuar (mantener)» para continuar.</translation>
    </message>
    <message>
        <source>The preview did not run %1, so these steps were not checked for collisions and other problems. Test them with “Run (hold)”, or set the inputs and preview the program again.</source>
        <translation>La vista previa no ha ejecutado todos los pasos (%1). Se desconocen las colisiones y otros problemas en ellos. Pruébelos con “Ejecutar (mantener)”, o ajuste las entradas y repita la vista previa.</translation>
    </message>
    <message>
        <source>A variable was changed. The moves after this change were not previewed, so they were not checked for collisions and other problems.</source>
        <translation>Se ha cambiado una variable. Los movimientos posteriores a este cambio no se han comprobado en la vista previa. Se desconocen las colisiones y otros problemas.</translation>
    </message>
    <message>
        <source>Runs the program while the button is held, no faster than the jog speed. The program ends when you release the button. If the arm is not at the start position of a complete preview, joint moves are slower so that no possible path exceeds the speed limit.</source>
        <translation>Ejecuta el programa mientras se mantiene pulsado el botón, como máximo a la velocidad de jog. El programa termina al soltar el botón. Los movimientos de articulación son más lentos si el brazo no está en la posición inicial de una vista previa completa, porque el límite de velocidad debe cumplirse entonces en cualquier trayectoria posible.</translation>
    </message>
    <message>
        <source>The program starts at step %1. Press to start from the beginning instead.</source>
        <translation>El programa empieza en el paso %1. Pulse para volver a empezar desde el principio.</translation>
    </message>
    <message>
        <source>The program started with a jog speed of %1 and cannot continue at a lower speed. Select this speed again, or stop the program.</source>
        <translation>El programa se inició con una velocidad manual de %1 y no puede continuar a una velocidad menor. Seleccione de nuevo esta velocidad o pare el programa.</translation>
    </message>
    <message>
        <source>%1 Preview the program with the current inputs, or select a higher jog speed, so that the program can run to the end.</source>
        <translation>%1 Simule el programa con las entradas actuales o seleccione una velocidad manual mayor para que pueda llegar a su final.</translation>
    </message>
</context>
<context>
    <name>tiller::SceneDock</name>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>No joint positions to replay</source>
        <translation>Sin posiciones articulares que reproducir</translation>
    </message>
    <message>
        <source>Robot model unknown</source>
        <translation>Modelo de robot desconocido</translation>
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
        <translation>Vista predeterminada (en perspectiva)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Look from the front: base X to the right, Z up</source>
        <translation>Mirar desde el frente: X de la base a la derecha, Z arriba</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>Look from the side: base Y to the right, Z up</source>
        <translation>Mirar desde el lado: Y de la base a la derecha, Z arriba</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Planta</translation>
    </message>
    <message>
        <source>Look from above: base X to the right, Y up</source>
        <translation>Mirar desde arriba: X de la base a la derecha, Y arriba</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view</source>
        <translation>Ajustar brazo, objetivo y puntos de paso a la vista</translation>
    </message>
</context>
<context>
    <name>tiller::SceneView</name>
    <message>
        <source>Arm view</source>
        <translation>Vista del brazo</translation>
    </message>
    <message>
        <source>Drag or use the arrow keys to rotate the view; hold Shift or the right button to pan. Zoom with the wheel or with plus and minus. Double-click or press Home for the default view. The robot does not move.</source>
        <translation>Arrastre o use las flechas para girar la vista; con Mayús o el botón derecho la desplaza. Amplíe con la rueda o con más y menos. Doble clic o Inicio para la vista predeterminada. El robot no se mueve.</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>SIN DATOS</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Sin conexión</translation>
    </message>
    <message>
        <source>ghost “%1” · out of reach</source>
        <translation>fantasma «%1» · fuera de alcance</translation>
    </message>
    <message>
        <source>ghost “%1” · reachable · largest rotation %2 %3 · %4 s at %5</source>
        <translation>fantasma «%1» · alcanzable · mayor giro %2 %3 · %4 s a %5</translation>
    </message>
    <message>
        <source>1 name hidden: zoom in</source>
        <translation>1 nombre oculto: acérquese</translation>
    </message>
    <message numerus="yes">
        <source>%n names hidden: zoom in</source>
        <translation>
            <numerusform>%n nombre oculto: acérquese</numerusform>
            <numerusform>%n nombres ocultos: acérquese</numerusform>
        </translation>
    </message>
    <message>
        <source>ghost “%1” · reachable</source>
        <translation>fantasma «%1» · alcanzable</translation>
    </message>
    <message>
        <source>ghost “%1” · %2 · largest rotation %3 %4 · %5 s at %6</source>
        <translation>fantasma «%1» · %2 · mayor giro %3 %4 · %5 s a %6</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Después: %1</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Antes: %1</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>REPRODUCCIÓN</translation>
    </message>
    <message>
        <source>LIVE ARM</source>
        <translation>BRAZO EN VIVO</translation>
    </message>
    <message>
        <source>ghost “%1” · taught with a different robot model</source>
        <translation>fantasma «%1» · enseñado con otro modelo de robot</translation>
    </message>
</context>
<context>
    <name>tiller::SignalStore</name>
    <message>
        <source>compute a signal</source>
        <translation>calcular una señal</translation>
    </message>
    <message>
        <source>%1 is not part of the same RTDE packets as the other signals.</source>
        <translation>%1 no está en los mismos paquetes RTDE que las demás señales.</translation>
    </message>
    <message>
        <source>Derived</source>
        <translation>Derivadas</translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. Remove other signals first.</source>
        <translation>El robot no puede enviar tantas señales a la vez: quite primero otras señales.</translation>
    </message>
    <message>
        <source>The recording %1 contains no samples. Open a different recording.</source>
        <translation>La grabación %1 no contiene muestras. Abra otra grabación.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>The history memory is too small to show %1. Increase the memory in the “Layout” menu.</source>
        <translation>La memoria del historial es demasiado pequeña para mostrar %1: auméntela en el menú Disposición.</translation>
    </message>
    <message>
        <source>%1 could not be computed completely: %2</source>
        <translation>No se pudo calcular %1 por completo: %2</translation>
    </message>
</context>
<context>
    <name>tiller::SignalTree</name>
    <message>
        <source>Search signals</source>
        <translation>Buscar señales</translation>
    </message>
    <message>
        <source>Robot signals</source>
        <translation>Señales del robot</translation>
    </message>
    <message>
        <source>New: |F| [N] = norm(…)</source>
        <translation>Nueva: |F| [N] = norm(…)</translation>
    </message>
    <message>
        <source>Derived signal</source>
        <translation>Señal derivada</translation>
    </message>
    <message>
        <source>%1: not sent by this robot.</source>
        <translation>%1: este robot no lo envía.</translation>
    </message>
    <message>
        <source>Enter a name, an optional unit in brackets, and an expression that uses signals. Drag signals here to insert their names. Functions: norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ and standard functions. Press Return to create the signal.</source>
        <translation>Introduzca un nombre, una unidad opcional entre corchetes y una expresión de señales. Arrastre señales aquí para insertar sus nombres. Funciones: norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ y funciones estándar. Intro crea la señal.</translation>
    </message>
</context>
<context>
    <name>tiller::SimulationChip</name>
    <message>
        <source>Simulation</source>
        <translation>Simulación</translation>
    </message>
    <message>
        <source>This robot is simulated. No real robot moves.</source>
        <translation>Este robot es simulado. Ningún robot real se mueve.</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULACIÓN</translation>
    </message>
</context>
<context>
    <name>tiller::SpeedChip</name>
    <message>
        <source>Speed slider</source>
        <translation>Deslizador de velocidad</translation>
    </message>
    <message>
        <source>Robot speed slider, 2 to 100 %</source>
        <translation>Deslizador de velocidad del robot, 2 a 100 %</translation>
    </message>
    <message>
        <source>SPEED</source>
        <translation>VELOC.</translation>
    </message>
</context>
<context>
    <name>tiller::StatusLine</name>
    <message>
        <source>Recording, project and last message</source>
        <translation>Grabación, proyecto y último mensaje</translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation>REC %1</translation>
    </message>
    <message>
        <source>%1 samples · %2 · %3 free</source>
        <translation>%1 muestras · %2 · %3 libres</translation>
    </message>
    <message>
        <source>Recording stopped</source>
        <translation>Grabación terminada</translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation>Sin grabación</translation>
    </message>
</context>
<context>
    <name>tiller::StepForm</name>
    <message>
        <source>Select one step to edit it.</source>
        <translation>Seleccione un paso para editarlo.</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(ninguno)</translation>
    </message>
</context>
<context>
    <name>tiller::StepPalette</name>
    <message>
        <source>Steps to add</source>
        <translation>Pasos disponibles</translation>
    </message>
</context>
<context>
    <name>tiller::StepTree</name>
    <message>
        <source>Program steps</source>
        <translation>Pasos del programa</translation>
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
        <translation>Parar</translation>
    </message>
    <message>
        <source>Software stop. Not an emergency stop. Power stays on.</source>
        <translation>Parada por software. No es una parada de emergencia. La alimentación sigue activa.</translation>
    </message>
    <message>
        <source>Space and Esc also stop the arm.</source>
        <translation>Espacio y Esc también detienen el brazo.</translation>
    </message>
    <message>
        <source>Click to stop the arm. Space and Esc stop the arm only while this window is in control.</source>
        <translation>Haga clic para detener. Espacio y Esc solo detienen mientras esta ventana tiene el control.</translation>
    </message>
    <message>
        <source>Space / Esc</source>
        <translation>Espacio / Esc</translation>
    </message>
    <message>
        <source>click</source>
        <translation>clic</translation>
    </message>
    <message>
        <source>not an e-stop</source>
        <translation>no es paro emerg.</translation>
    </message>
</context>
<context>
    <name>tiller::StopPlot</name>
    <message>
        <source>Maximum in the last five seconds: %1</source>
        <translation>Máximo de los últimos cinco segundos: %1</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>máx. %1</translation>
    </message>
    <message>
        <source>no data before the stop</source>
        <translation>sin datos antes de la parada</translation>
    </message>
</context>
<context>
    <name>tiller::TcpPage</name>
    <message>
        <source>In use</source>
        <translation>En uso</translation>
    </message>
    <message>
        <source>Enter a name for the TCP.</source>
        <translation>Introduzca un nombre para el TCP.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renombrar «%1» a «%2»</translation>
    </message>
    <message>
        <source>TCPs</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>No TCPs yet.
Press “From robot” to store the active TCP, or “Teach…” to teach a TCP with the arm.</source>
        <translation>Aún no hay TCP.
Pulse «Del robot» para guardar el TCP activo, o «Enseñar…» para enseñar uno con el brazo.</translation>
    </message>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>Relative to the flange. Press Return to apply the value to the project. The robot&apos;s TCP does not change.</source>
        <translation>Relativo a la brida. Intro lo aplica al proyecto. El TCP del robot no cambia.</translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation>Fijar en el robot</translation>
    </message>
    <message>
        <source>Use this TCP and set it on the robot</source>
        <translation>Usar este TCP y fijarlo en el robot</translation>
    </message>
    <message>
        <source>Teach…</source>
        <translation>Enseñar…</translation>
    </message>
    <message>
        <source>Teach a TCP with the arm</source>
        <translation>Enseñar un TCP con el brazo</translation>
    </message>
    <message>
        <source>From robot</source>
        <translation>Del robot</translation>
    </message>
    <message>
        <source>Store the active TCP of the robot</source>
        <translation>Guardar el TCP activo del robot</translation>
    </message>
    <message>
        <source>Teach the selected TCP again…</source>
        <translation>Enseñar de nuevo el TCP seleccionado…</translation>
    </message>
    <message>
        <source>Enter new TCP</source>
        <translation>Introducir TCP nuevo</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>herramienta</translation>
    </message>
    <message>
        <source>Rename TCP</source>
        <translation>Renombrar TCP</translation>
    </message>
    <message>
        <source>Duplicate TCP</source>
        <translation>Duplicar TCP</translation>
    </message>
    <message>
        <source>Delete TCP</source>
        <translation>Eliminar TCP</translation>
    </message>
    <message>
        <source>Change the TCP “%1”</source>
        <translation>Cambiar el TCP «%1»</translation>
    </message>
    <message>
        <source>Teach the TCP “%1” again</source>
        <translation>Enseñar de nuevo el TCP «%1»</translation>
    </message>
    <message>
        <source>Add the TCP “%1”</source>
        <translation>Añadir el TCP «%1»</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>Ningún robot conectado. Conecte uno o pruebe el simulador.</translation>
    </message>
    <message>
        <source>The active TCP of the robot is already stored as “%1”.</source>
        <translation>El TCP activo del robot ya está guardado como «%1».</translation>
    </message>
    <message>
        <source>Teach “%1” again</source>
        <translation>Enseñar de nuevo «%1»</translation>
    </message>
    <message>
        <source>Teach a new TCP</source>
        <translation>Enseñar un TCP nuevo</translation>
    </message>
    <message>
        <source>Select the TCP to set.</source>
        <translation>Seleccione un TCP para fijar.</translation>
    </message>
    <message>
        <source>Use the TCP “%1”</source>
        <translation>Usar el TCP «%1»</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller no tiene el control. Tome primero el control.</translation>
    </message>
    <message>
        <source>Delete the TCP “%1”</source>
        <translation>Eliminar el TCP «%1»</translation>
    </message>
    <message>
        <source>%1, relative to the flange</source>
        <translation>%1, desde la brida</translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation>%1, activo en el robot</translation>
    </message>
    <message>
        <source>%1, %2 from the robot&apos;s TCP</source>
        <translation>%1, a %2 del TCP del robot</translation>
    </message>
    <message>
        <source>The robot&apos;s TCP differs from “%1”</source>
        <translation>El TCP del robot difiere de «%1»</translation>
    </message>
    <message>
        <source>On the robot: %1. In the project: %2. Difference: %3. Nothing was changed.</source>
        <translation>En el robot: %1. En el proyecto: %2. Distancia: %3. No se cambió nada.</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>Fijar «%1» en el robot</translation>
    </message>
    <message>
        <source>Set TCP on robot</source>
        <translation>Fijar el TCP en el robot</translation>
    </message>
    <message>
        <source>A TCP named “%1” already exists. Choose a different name.</source>
        <translation>Ya existe un TCP con el nombre «%1». Elija otro nombre.</translation>
    </message>
</context>
<context>
    <name>tiller::TcpTeacher</name>
    <message>
        <source>Record pose</source>
        <translation>Tomar pose</translation>
    </message>
    <message>
        <source>Redo least accurate pose</source>
        <translation>Repetir la peor pose</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Tomar</translation>
    </message>
    <message>
        <source>Keep TCP</source>
        <translation>Conservar TCP</translation>
    </message>
    <message>
        <source>Teach the TCP</source>
        <translation>Enseñar el TCP</translation>
    </message>
    <message>
        <source>Record pose for the tool orientation</source>
        <translation>Tomar pose para la orientación</translation>
    </message>
    <message>
        <source>Tool orientation</source>
        <translation>Orientación de la herramienta</translation>
    </message>
    <message>
        <source>Keep current orientation</source>
        <translation>Conservar la orientación</translation>
    </message>
    <message>
        <source>Orientation from one pose: tool straight down</source>
        <translation>Orientación con una pose: herramienta recta hacia abajo</translation>
    </message>
    <message>
        <source>Orientation from three poses: along +Z, towards +X</source>
        <translation>Orientación con tres poses: por +Z, hacia +X</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Tip at %1. The poses agree within %2 (RMS); pose %3 deviates most, by %4.</source>
        <translation>Punta en %1. Las poses coinciden en %2 (RMS); la pose %3 es la que más se desvía, %4.</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the poses again.</source>
        <translation>El robot envió una posición no válida. Tome las poses de nuevo.</translation>
    </message>
    <message>
        <source>The tool keeps the current orientation.</source>
        <translation>La herramienta conserva la orientación actual.</translation>
    </message>
    <message>
        <source>Rotate the tool until it points straight down and its X axis is parallel to the base X axis, then record the pose.</source>
        <translation>Gire la herramienta hasta que apunte recta hacia abajo y su eje X sea paralelo al eje X de la base; después tome la pose.</translation>
    </message>
    <message>
        <source>Orientation recorded. Record another pose to replace the orientation.</source>
        <translation>Orientación tomada. Tómela de nuevo para sustituirla.</translation>
    </message>
    <message>
        <source>Record the pose at the current position. After that, do not rotate the tool: jog along X, Y and Z only.</source>
        <translation>Tome la pose en la posición actual. No gire la herramienta a partir de aquí: mueva solo X, Y y Z.</translation>
    </message>
    <message>
        <source>Move the tool along its +Z direction, away from the flange, by at least %1, and record the pose.</source>
        <translation>Mueva la herramienta en su dirección +Z, alejándola de la brida, al menos %1, y tome la pose.</translation>
    </message>
    <message>
        <source>Now move the tool along its +X direction by at least %1, and record the pose.</source>
        <translation>Ahora mueva la herramienta en su dirección +X al menos %1 y tome la pose.</translation>
    </message>
    <message>
        <source>Orientation recorded: %1 along +Z, %2 along +X; maximum flange rotation %3 at pose %4.</source>
        <translation>Orientación tomada: %1 en +Z, %2 en +X; giro máximo de la brida %3 en la pose %4.</translation>
    </message>
    <message>
        <source>The flange rotated by up to %1 (pose %2). Record the three poses again without rotating the tool.</source>
        <translation>La brida giró hasta %1 (pose %2). Tome las tres poses de nuevo sin girar la herramienta.</translation>
    </message>
    <message>
        <source>The distance along +Z is only %1. Record the three poses again, at least %2 apart.</source>
        <translation>La distancia en +Z es de solo %1. Tome las tres poses de nuevo, separadas %2 como mínimo.</translation>
    </message>
    <message>
        <source>The distance along +X is only %1. Record the three poses again, at least %2 apart.</source>
        <translation>La distancia en +X es de solo %1. Tome las tres poses de nuevo, separadas %2 como mínimo.</translation>
    </message>
    <message>
        <source>The three poses are collinear: the third pose is only %1 from the line. Record the three poses again.</source>
        <translation>Las tres poses están alineadas: la tercera está a solo %1 de la línea. Tómelas de nuevo.</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the three poses again.</source>
        <translation>El robot envió una posición no válida. Tome las tres poses de nuevo.</translation>
    </message>
    <message>
        <source>Redo last pose</source>
        <translation>Repetir la última pose</translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation>Tomar pose %1</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>Pose %1</translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation>  ◀ menos precisa</translation>
    </message>
    <message>
        <source>Poses can be recorded only while the robot sends data. Connect to a robot, or wait for new data.</source>
        <translation>Las poses solo se pueden tomar mientras el robot envía datos. Conéctese a un robot o espere nuevos datos.</translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool tilted by at least 30° in a different direction.</source>
        <translation>Las orientaciones de la herramienta son demasiado parecidas. Tome otra pose, inclinada 30° o más en otra dirección.</translation>
    </message>
    <message>
        <source>Jog the tip to a fixed, sharp point and record the pose. Record four poses in total, each with the tip on the same point and the tool tilted in a different direction.</source>
        <translation>Lleve la punta a un punto fijo y afilado y tome la pose. Tome cuatro poses en total, cada una con la punta en el mismo punto y la herramienta inclinada en otra dirección.</translation>
    </message>
    <message numerus="yes">
        <source>Tilt the tool in a different direction, move the tip to the same point again, and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>Incline la herramienta en otra dirección, lleve la punta de nuevo al mismo punto y tome la pose. Poses que faltan: %n.</numerusform>
            <numerusform>Incline la herramienta en otra dirección, lleve la punta de nuevo al mismo punto y tome la pose. Poses que faltan: %n.</numerusform>
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
        <translation>Carga útil</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Posiciones</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Celda</translation>
    </message>
    <message>
        <source>TCP, payload, positions or cell</source>
        <translation>TCP, carga útil, posiciones o celda</translation>
    </message>
</context>
<context>
    <name>tiller::TravelWatch</name>
    <message>
        <source>%1: %2 left until %3 is %4 from %5</source>
        <translation>%1: quedan %2 hasta que %3 esté a %4 de %5</translation>
    </message>
    <message>
        <source>%1: %2 left until the %3 joint limit</source>
        <translation>%1: quedan %2 hasta el límite de %3</translation>
    </message>
    <message>
        <source>%1: %2 left until the reach limit or a singularity</source>
        <translation>%1: quedan %2 hasta el límite de alcance o una singularidad</translation>
    </message>
</context>
<context>
    <name>tiller::VariableList</name>
    <message>
        <source>Program variables</source>
        <translation>Variables del programa</translation>
    </message>
    <message>
        <source>The variable list changed during editing, so the value was not applied. Enter the value again.</source>
        <translation>La lista de variables cambió durante la edición, por lo que el valor no se aplicó. Introdúzcalo de nuevo.</translation>
    </message>
</context>
<context>
    <name>tiller::VariableModel</name>
    <message>
        <source>%1 (changing…)</source>
        <translation>%1 (cambiando…)</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
</context>
<context>
    <name>tiller::VectorEditor</name>
    <message>
        <source>%1. Press Return to apply the value. The robot does not move.</source>
        <translation>%1. Pulse Intro para aplicar. El robot no se mueve.</translation>
    </message>
</context>
<context>
    <name>tiller::ViewCard</name>
    <message>
        <source>Collapse</source>
        <translation>Plegar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>The view is too small to expand this card</source>
        <translation>La vista es demasiado pequeña para desplegar esta tarjeta</translation>
    </message>
    <message>
        <source>Expand</source>
        <translation>Desplegar</translation>
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
        <translation>En el sistema del punto de paso. Pulse Intro para aplicar. Solo cambia el punto de paso; el robot no se mueve.</translation>
    </message>
    <message>
        <source>Selected waypoint</source>
        <translation>Punto de paso seleccionado</translation>
    </message>
    <message>
        <source>Waypoint frame</source>
        <translation>Sistema del punto de paso</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Sistemas de coordenadas</translation>
    </message>
    <message numerus="yes">
        <source>used in %n steps</source>
        <translation>
            <numerusform>usado en %n paso</numerusform>
            <numerusform>usado en %n pasos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the current pose</source>
        <translation>a %1 de la pose actual</translation>
    </message>
    <message>
        <source>joints have priority</source>
        <translation>prioridad de articulaciones</translation>
    </message>
    <message>
        <source>pose has priority</source>
        <translation>prioridad de pose</translation>
    </message>
    <message>
        <source>cell of “%1”</source>
        <translation>celda de «%1»</translation>
    </message>
    <message>
        <source>corner of “%1”</source>
        <translation>esquina de «%1»</translation>
    </message>
    <message>
        <source>home position “%1”</source>
        <translation>inicio, «%1»</translation>
    </message>
    <message>
        <source>position “%1”</source>
        <translation>posición «%1»</translation>
    </message>
    <message>
        <source>Run route</source>
        <translation>Ruta</translation>
    </message>
    <message>
        <source>Shows the route controls instead of the values.</source>
        <translation>Muestra los mandos de la ruta en lugar de los valores.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Shows the values instead of the route controls.</source>
        <translation>Muestra los valores en lugar de los mandos de la ruta.</translation>
    </message>
    <message>
        <source>TCP “%1”</source>
        <translation>TCP «%1»</translation>
    </message>
    <message>
        <source>TCP at the flange</source>
        <translation>TCP en la brida</translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation>TCP a %1 de la brida</translation>
    </message>
    <message>
        <source>Reference frame of the waypoint. Changing the frame does not move the waypoint. “—” means no frame: the joint positions have priority.</source>
        <translation>Sistema de referencia del punto de paso. La posición en el espacio no cambia. «—»: sin sistema, las articulaciones tienen prioridad</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointDialogs</name>
    <message>
        <source>Select waypoints to change.</source>
        <translation>Seleccione puntos para cambiar.</translation>
    </message>
    <message numerus="yes">
        <source>Change the properties of %n waypoints</source>
        <translation>
            <numerusform>Cambiar propiedades de %n punto</numerusform>
            <numerusform>Cambiar propiedades de %n puntos</numerusform>
        </translation>
    </message>
    <message>
        <source>Select waypoints to move.</source>
        <translation>Seleccione puntos para mover.</translation>
    </message>
    <message>
        <source>Change the pattern “%1”</source>
        <translation>Cambiar el patrón «%1»</translation>
    </message>
    <message>
        <source>Create the pattern “%1”</source>
        <translation>Crear el patrón «%1»</translation>
    </message>
    <message>
        <source>Convert the pattern “%1” to waypoints</source>
        <translation>Convertir el patrón «%1» en puntos de paso</translation>
    </message>
    <message>
        <source>Select a waypoint that belongs to a pattern.</source>
        <translation>Seleccione una celda de un patrón.</translation>
    </message>
    <message>
        <source>Delete the pattern “%1”</source>
        <translation>Eliminar el patrón «%1»</translation>
    </message>
    <message>
        <source>Select a waypoint to see its history.</source>
        <translation>Seleccione un punto para ver su historial.</translation>
    </message>
    <message>
        <source>Restore an earlier version of “%1”</source>
        <translation>Restaurar una versión anterior de «%1»</translation>
    </message>
    <message>
        <source>Import waypoints</source>
        <translation>Importar puntos de paso</translation>
    </message>
    <message>
        <source>Waypoint files (*.csv *.txt *.json *.tiller);;All files (*)</source>
        <translation>Puntos de paso (*.csv *.txt *.json *.tiller);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Export waypoints</source>
        <translation>Exportar puntos de paso</translation>
    </message>
    <message>
        <source>CSV file (*.csv);;JSON file (*.json)</source>
        <translation>Archivo CSV (*.csv);;Archivo JSON (*.json)</translation>
    </message>
    <message>
        <source>Import failed</source>
        <translation>Error de importación</translation>
    </message>
    <message>
        <source>%1 is too large. The maximum size of a waypoint file is 64 MB.</source>
        <translation>%1 es demasiado grande. El tamaño máximo de un archivo de puntos de paso es de 64 MB.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>punto de paso</translation>
    </message>
    <message numerus="yes">
        <source>Import %n waypoints</source>
        <translation>
            <numerusform>Importar %n punto</numerusform>
            <numerusform>Importar %n puntos</numerusform>
        </translation>
    </message>
    <message>
        <source>The project contains no waypoints to export. Teach a waypoint first.</source>
        <translation>El proyecto no contiene puntos de paso que exportar. Enseñe primero un punto de paso.</translation>
    </message>
    <message>
        <source>Export failed</source>
        <translation>Error de exportación</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints exported to %1</source>
        <translation>
            <numerusform>%n punto escrito en %1</numerusform>
            <numerusform>%n puntos escritos en %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the waypoints to add actions to.</source>
        <translation>Seleccione los puntos de paso a los que añadir acciones.</translation>
    </message>
    <message numerus="yes">
        <source>Change the actions at %n waypoints</source>
        <translation>
            <numerusform>Cambiar las acciones en %n punto</numerusform>
            <numerusform>Cambiar las acciones en %n puntos</numerusform>
        </translation>
    </message>
    <message>
        <source>Teach three waypoints at the corners of the pattern first.</source>
        <translation>Enseñe primero tres puntos de paso en las esquinas del patrón.</translation>
    </message>
    <message>
        <source>The earlier version cannot be restored because its frame was deleted from the project. Select a different version.</source>
        <translation>La versión anterior no se puede restaurar porque su sistema de coordenadas se eliminó del proyecto. Seleccione otra versión.</translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>Desplazar, girar o reflejar %n punto</numerusform>
            <numerusform>Desplazar, girar o reflejar %n puntos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 contains no waypoints. Choose a different file.</source>
        <translation>No hay puntos de paso en %1. Elija otro archivo.</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointEditing</name>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Duplicar «%1»</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n waypoints</source>
        <translation>
            <numerusform>Duplicar %n punto de paso</numerusform>
            <numerusform>Duplicar %n puntos de paso</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste failed</source>
        <translation>Error al pegar</translation>
    </message>
    <message>
        <source>The clipboard contains no waypoints. Copy waypoints first.</source>
        <translation>El portapapeles no contiene puntos de paso. Copie primero puntos de paso.</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>punto de paso</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n waypoints</source>
        <translation>
            <numerusform>Pegar %n punto de paso</numerusform>
            <numerusform>Pegar %n puntos de paso</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::WaypointHistoryDialog</name>
    <message>
        <source>History of “%1”</source>
        <translation>Historial de «%1»</translation>
    </message>
    <message>
        <source>Changes, newest first</source>
        <translation>Cambios, el más nuevo primero</translation>
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
        <translation>Restaurar la versión anterior a este cambio</translation>
    </message>
    <message>
        <source>Name: “%1” → “%2”</source>
        <translation>Nombre: «%1» → «%2»</translation>
    </message>
    <message>
        <source>Position: moved by %1 (%2, base frame)</source>
        <translation>Posición: desplazada %1 (%2, base)</translation>
    </message>
    <message>
        <source>Joints: largest change %2 (%1)</source>
        <translation>Articulaciones: mayor cambio %2 (%1)</translation>
    </message>
    <message>
        <source>none (joints have priority)</source>
        <translation>ninguno (prioridad de articulaciones)</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>a deleted frame</source>
        <translation>un sistema eliminado</translation>
    </message>
    <message>
        <source>Frame: %1 → %2</source>
        <translation>Sistema: %1 → %2</translation>
    </message>
    <message>
        <source>Move: MoveL → MoveJ</source>
        <translation>Tipo: MoveL → MoveJ</translation>
    </message>
    <message>
        <source>Move: MoveJ → MoveL</source>
        <translation>Tipo: MoveJ → MoveL</translation>
    </message>
    <message>
        <source>MoveJ speed: %1 → %2</source>
        <translation>Velocidad de MoveJ: %1 → %2</translation>
    </message>
    <message>
        <source>MoveL speed: %1 → %2</source>
        <translation>Velocidad de MoveL: %1 → %2</translation>
    </message>
    <message>
        <source>Blend: %1 → %2</source>
        <translation>Fusión: %1 → %2</translation>
    </message>
    <message>
        <source>TCP: taught with a different TCP</source>
        <translation>TCP: enseñado con otro TCP</translation>
    </message>
    <message>
        <source>Group: “%1” → “%2”</source>
        <translation>Grupo: «%1» → «%2»</translation>
    </message>
    <message>
        <source>Colour: %1 → %2</source>
        <translation>Color: %1 → %2</translation>
    </message>
    <message>
        <source>Note: “%1” → “%2”</source>
        <translation>Nota: «%1» → «%2»</translation>
    </message>
    <message>
        <source>Actions: changed</source>
        <translation>Acciones: cambiadas</translation>
    </message>
    <message>
        <source>No changes have been recorded for this waypoint.</source>
        <translation>No se han registrado cambios de este punto de paso.</translation>
    </message>
    <message>
        <source>The version before this change is identical to the current version.</source>
        <translation>La versión anterior a este cambio es idéntica a la actual.</translation>
    </message>
    <message>
        <source>Changes from the version before this change to the current version:</source>
        <translation>Cambios de la versión anterior a este cambio a la versión actual:</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointModel</name>
    <message>
        <source>✕ joint</source>
        <translation>✕ art.</translation>
    </message>
    <message>
        <source>✕ frame</source>
        <translation>✕ sistema</translation>
    </message>
    <message>
        <source>✕ line</source>
        <translation>✕ línea</translation>
    </message>
    <message>
        <source>✕ reach</source>
        <translation>✕ alcance</translation>
    </message>
    <message>
        <source>Out of reach. Touch up the waypoint closer to the base.</source>
        <translation>Fuera de alcance. Retoque el punto más cerca de la base.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>MoveJ: all joints start and stop together</source>
        <translation>MoveJ: todas las articulaciones empiezan y paran juntas</translation>
    </message>
    <message>
        <source>MoveL: the TCP moves along a straight line</source>
        <translation>MoveL: el TCP se mueve en línea recta</translation>
    </message>
    <message>
        <source>Joints have priority: the arm returns to the same configuration</source>
        <translation>Prioridad de articulaciones: el brazo vuelve a la misma configuración</translation>
    </message>
    <message>
        <source>The pose has priority: the waypoint moves with its frame</source>
        <translation>Prioridad de pose: el punto de paso se mueve con su sistema</translation>
    </message>
    <message>
        <source>Within reach</source>
        <translation>Al alcance</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Sistema</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Blend %1</source>
        <translation>Fusión %1</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>Enter a name for the waypoint.</source>
        <translation>Introduzca un nombre para el punto de paso.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renombrar «%1» a «%2»</translation>
    </message>
    <message>
        <source>Change “%1” to MoveJ</source>
        <translation>Cambiar «%1» a MoveJ</translation>
    </message>
    <message>
        <source>Change “%1” to MoveL</source>
        <translation>Cambiar «%1» a MoveL</translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation>Cambiar la pose de «%1»</translation>
    </message>
    <message>
        <source>Use joint positions for “%1”</source>
        <translation>Usar posiciones articulares para «%1»</translation>
    </message>
    <message>
        <source>Change the frame of “%1” to %2</source>
        <translation>Cambiar el sistema de «%1» a %2</translation>
    </message>
    <message>
        <source>Set the blend of “%1”</source>
        <translation>Fijar la fusión de «%1»</translation>
    </message>
    <message>
        <source>Set the speed of “%1”</source>
        <translation>Fijar la velocidad de «%1»</translation>
    </message>
    <message>
        <source>Group: %1</source>
        <translation>Grupo: %1</translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation>Color: %1</translation>
    </message>
    <message>
        <source>Name %1, next waypoint</source>
        <translation>Nombre %1, punto siguiente</translation>
    </message>
    <message>
        <source>Actions: %1</source>
        <translation>Acciones: %1</translation>
    </message>
    <message>
        <source>Name %1</source>
        <translation>Nombre %1</translation>
    </message>
    <message numerus="yes">
        <source>%n actions</source>
        <translation>
            <numerusform>%n acción</numerusform>
            <numerusform>%n acciones</numerusform>
        </translation>
    </message>
    <message>
        <source>✕ model</source>
        <translation>✕ modelo</translation>
    </message>
    <message>
        <source>✕ path</source>
        <translation>✕ ruta</translation>
    </message>
    <message>
        <source>The arm cannot reach this pose, so “%1” was not changed. Enter a different pose.</source>
        <translation>El brazo no puede alcanzar esta pose. «%1» no se cambió. Introduzca otra pose.</translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation>«%1» no es un número. Introduzca un número.</translation>
    </message>
    <message>
        <source>%1 is out of range. Enter a value from %2 to %3.</source>
        <translation>%1 está fuera del intervalo. Introduzca un valor de %2 a %3.</translation>
    </message>
    <message>
        <source>A joint would exceed its limit. Touch up the waypoint with a different arm configuration.</source>
        <translation>Una articulación superaría su recorrido. Retoque el punto con otra configuración del brazo.</translation>
    </message>
    <message>
        <source>The frame of the waypoint is not in this project. Choose a different frame.</source>
        <translation>El sistema del punto de paso no está en este proyecto. Elija otro sistema.</translation>
    </message>
    <message>
        <source>The straight line from the current position leaves the reach of the arm. Use MoveJ, or start from a different position.</source>
        <translation>La línea recta desde la posición actual sale del alcance del brazo. Use MoveJ o empiece en otra posición.</translation>
    </message>
    <message>
        <source>Waypoint %2 is already named “%1”. Choose a different name.</source>
        <translation>El punto de paso %2 ya se llama «%1». Elija otro nombre.</translation>
    </message>
    <message>
        <source>The project has no frame named “%1”. Choose a different frame.</source>
        <translation>El proyecto no tiene ningún sistema «%1». Elija otro sistema.</translation>
    </message>
    <message>
        <source>The project was taught with a different robot model. Use “Adapt project to this robot…” first.</source>
        <translation>El proyecto se enseñó con otro modelo de robot. Use primero «Adaptar el proyecto a este robot…».</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointProperties</name>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Azul</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Naranja</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Verde</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>Rosa</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Amarillo</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Celeste</translation>
    </message>
    <message>
        <source>Only the selected properties are changed.</source>
        <translation>Solo se cambian las propiedades seleccionadas.</translation>
    </message>
    <message>
        <source>Properties of “%1”</source>
        <translation>Propiedades de «%1»</translation>
    </message>
    <message numerus="yes">
        <source>Properties of %n waypoints</source>
        <translation>
            <numerusform>Propiedades de %n punto</numerusform>
            <numerusform>Propiedades de %n puntos</numerusform>
        </translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>MoveJ speed</source>
        <translation>Velocidad de MoveJ</translation>
    </message>
    <message>
        <source>MoveL speed</source>
        <translation>Velocidad de MoveL</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Fusión</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointSearch</name>
    <message>
        <source>Find waypoints</source>
        <translation>Buscar puntos</translation>
    </message>
    <message>
        <source>Find waypoints by name, group or note</source>
        <translation>Buscar puntos por nombre, grupo o nota</translation>
    </message>
    <message>
        <source>Name, group or note</source>
        <translation>Nombre, grupo o nota</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostrar todos</translation>
    </message>
    <message>
        <source>Show all waypoints</source>
        <translation>Mostrar todos los puntos</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n encontrado</numerusform>
            <numerusform>%n encontrados</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::WaypointShift</name>
    <message>
        <source>Transformation type</source>
        <translation>Tipo de transformación</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Desplazamiento</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Reflejar</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Tool of each waypoint</source>
        <translation>Herramienta de cada punto de paso</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Offset X, Y, Z</source>
        <translation>Desplazamiento X, Y, Z</translation>
    </message>
    <message>
        <source>Offset %1</source>
        <translation>Desplazamiento %1</translation>
    </message>
    <message>
        <source>Rotation axis or mirror normal</source>
        <translation>Eje de giro o normal del plano de reflexión</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>The arm cannot reach these waypoints after the move: %1. Choose a different offset, rotation or mirror plane. No waypoint will be moved.</source>
        <translation>El brazo no puede alcanzar estos puntos de paso después del desplazamiento: %1. Elija otro desplazamiento, giro o plano de simetría. No se moverá ningún punto de paso.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the moved waypoints will be out of reach. They will be kept and marked.</source>
        <translation>
            <numerusform>%n de ellos quedaría fuera de alcance. Se conserva y se marca.</numerusform>
            <numerusform>%n de ellos quedarían fuera de alcance. Se conservan y se marcan.</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirrors across the plane through the origin that is perpendicular to the axis. The tool approaches from the mirrored side.</source>
        <translation>Refleja en el plano que pasa por el origen y es perpendicular al eje. La herramienta se acerca por el lado reflejado.</translation>
    </message>
    <message>
        <source>All waypoints remain within reach.</source>
        <translation>Todos siguen al alcance.</translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>Desplazar, girar o reflejar %n punto</numerusform>
            <numerusform>Desplazar, girar o reflejar %n puntos</numerusform>
        </translation>
    </message>
    <message>
        <source>The frame of a selected waypoint is not in the project. Choose a different frame for the waypoint first.</source>
        <translation>El sistema de un punto de paso seleccionado no está en el proyecto. Elija primero otro sistema para el punto de paso.</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointTable</name>
    <message>
        <source>Waypoints</source>
        <translation>Puntos de paso</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointsTab</name>
    <message>
        <source>Waypoints</source>
        <translation>Puntos de paso</translation>
    </message>
    <message>
        <source>Teach here  T</source>
        <translation>Enseñar aquí  T</translation>
    </message>
    <message>
        <source>Teach here</source>
        <translation>Enseñar aquí</translation>
    </message>
    <message>
        <source>Touch up  U</source>
        <translation>Retocar  U</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Retocar</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Más</translation>
    </message>
    <message>
        <source>No waypoints yet.
Jog the arm to a position and press “Teach here” (T).</source>
        <translation>Aún no hay puntos de paso.
Mueva el brazo a una posición y pulse «Enseñar aquí» (T).</translation>
    </message>
    <message>
        <source>Select a waypoint to go to.</source>
        <translation>Seleccione un punto de paso al que ir.</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller no tiene el control. Tome primero el control.</translation>
    </message>
    <message>
        <source>Add the current position after the selection (T)</source>
        <translation>Añadir la posición actual después de la selección (T)</translation>
    </message>
    <message>
        <source>Replace the selected waypoint with the current position (U)</source>
        <translation>Sustituir el punto seleccionado por la posición actual (U)</translation>
    </message>
    <message>
        <source>Select a waypoint to touch up.</source>
        <translation>Seleccione un punto de paso para retocar.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Subir</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Bajar</translation>
    </message>
    <message>
        <source>Copy as table</source>
        <translation>Copiar como tabla</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>punto de paso</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>Enseñar «%1»</translation>
    </message>
    <message>
        <source>The current position is %1 away (%2, base frame). Largest joint change: %3 %4.</source>
        <translation>La posición actual está a %1 (%2, base). Mayor cambio articular: %3 %4.</translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>¿Retocar «%1»?</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>Retocar «%1»</translation>
    </message>
    <message>
        <source>Path recorded</source>
        <translation>Trayectoria grabada</translation>
    </message>
    <message>
        <source>Import waypoints…</source>
        <translation>Importar puntos de paso…</translation>
    </message>
    <message>
        <source>Export waypoints…</source>
        <translation>Exportar puntos de paso…</translation>
    </message>
    <message>
        <source>Find waypoints</source>
        <translation>Buscar puntos de paso</translation>
    </message>
    <message>
        <source>Group, colour, note, speeds…</source>
        <translation>Grupo, color, nota, velocidades…</translation>
    </message>
    <message>
        <source>Offset, rotate or mirror…</source>
        <translation>Desplazar, girar o reflejar…</translation>
    </message>
    <message>
        <source>History…</source>
        <translation>Historial…</translation>
    </message>
    <message>
        <source>Convert pattern to waypoints</source>
        <translation>Convertir patrón en puntos de paso</translation>
    </message>
    <message>
        <source>Delete pattern and its waypoints</source>
        <translation>Eliminar el patrón y sus puntos</translation>
    </message>
    <message>
        <source>Actions…</source>
        <translation>Acciones…</translation>
    </message>
    <message>
        <source>Import and export</source>
        <translation>Importar y exportar</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Patrón</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trayectoria</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Proyecto</translation>
    </message>
    <message>
        <source>Taught “%1”</source>
        <translation>«%1» enseñado</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Create or edit pattern…</source>
        <translation>Crear o editar patrón…</translation>
    </message>
    <message>
        <source>The frame of “%1” is not in this project. Choose a different frame first.</source>
        <translation>El sistema de «%1» no está en este proyecto. Elija antes otro sistema.</translation>
    </message>
</context>
<context>
    <name>tiller::app::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>Órdenes</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Buscar órdenes</translation>
    </message>
    <message>
        <source>Type a command or keyword</source>
        <translation>Escriba una orden o palabra clave</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Órdenes encontradas</translation>
    </message>
    <message>
        <source>not available now</source>
        <translation>no disponible ahora</translation>
    </message>
</context>
<context>
    <name>tiller::app::ConnectDialog</name>
    <message>
        <source>Enter the robot&apos;s address, as shown on the teach pendant under About.</source>
        <translation>Introduzca la dirección del robot, como la muestra la consola portátil en Acerca de.</translation>
    </message>
    <message>
        <source>An IP address consists of four numbers from 0 to 255, e.g. 192.168.0.10.</source>
        <translation>Una dirección IP tiene cuatro números de 0 a 255, p. ej. 192.168.0.10.</translation>
    </message>
    <message>
        <source>A host name contains only letters, digits, dots and hyphens.</source>
        <translation>Un nombre de host contiene solo letras, cifras, puntos y guiones.</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Olvidar</translation>
    </message>
    <message>
        <source>Start the simulated robot</source>
        <translation>Iniciar el robot simulado</translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation>Abrir proyecto de ejemplo…</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Conectar</translation>
    </message>
    <message>
        <source>Before you move a real arm: keep everyone out of its reach, keep the emergency stop within reach, check the payload and the TCP, and start slowly. STOP in this window is not an emergency stop.</source>
        <translation>Antes de mover un brazo real: mantenga a todos fuera de su alcance, tenga a mano la parada de emergencia, compruebe la carga útil y el TCP, y empiece despacio. STOP en esta ventana no es una parada de emergencia.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Abrir proyecto…</translation>
    </message>
    <message>
        <source>Opens a project without a robot, to view and edit waypoints and programs.</source>
        <translation>Abre un proyecto sin robot para ver y editar puntos de paso y programas.</translation>
    </message>
    <message>
        <source>Try the simulator</source>
        <translation>Probar el simulador</translation>
    </message>
    <message>
        <source>A simulated UR5e that runs in Tiller. All functions are available without risk.</source>
        <translation>Un UR5e simulado que se ejecuta en Tiller. Todas las funciones están disponibles sin riesgo.</translation>
    </message>
    <message>
        <source>Starts the simulated robot and opens a project with taught waypoints.</source>
        <translation>Inicia el robot simulado y abre un proyecto con puntos de paso enseñados.</translation>
    </message>
    <message>
        <source>Connect to a robot</source>
        <translation>Conectar un robot</translation>
    </message>
    <message>
        <source>Address or host name of the robot</source>
        <translation>Dirección o nombre de host del robot</translation>
    </message>
    <message>
        <source>Display name of the robot</source>
        <translation>Nombre visible del robot</translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation>UR5e del laboratorio</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Recently connected robots</source>
        <translation>Robots conectados recientemente</translation>
    </message>
    <message>
        <source>Removes the selected robot from this list (Delete). The robot itself is not affected.</source>
        <translation>Quita de esta lista el robot seleccionado (Supr). El robot no se ve afectado.</translation>
    </message>
</context>
<context>
    <name>tiller::app::Demonstration</name>
    <message>
        <source>Cannot create the folder %1. Choose a folder that you have permission to write to.</source>
        <translation>No se puede crear la carpeta %1. Elija una carpeta en la que tenga permiso para escribir.</translation>
    </message>
    <message>
        <source>connect</source>
        <translation>conectar</translation>
    </message>
    <message>
        <source>power on</source>
        <translation>encender</translation>
    </message>
    <message>
        <source>release the brakes</source>
        <translation>liberar los frenos</translation>
    </message>
    <message>
        <source>take control</source>
        <translation>tomar el control</translation>
    </message>
    <message>
        <source>start recording</source>
        <translation>empezar la grabación</translation>
    </message>
    <message>
        <source>teach the first waypoint</source>
        <translation>enseñar el primer punto de paso</translation>
    </message>
    <message>
        <source>jog X+ in Base for 50 mm</source>
        <translation>mover X+ en Base 50 mm</translation>
    </message>
    <message>
        <source>teach the second waypoint</source>
        <translation>enseñar el segundo punto de paso</translation>
    </message>
    <message>
        <source>move to the first waypoint (button held)</source>
        <translation>ir al primer punto de paso (mantenido)</translation>
    </message>
    <message>
        <source>digital output 0 on</source>
        <translation>salida digital 0 activada</translation>
    </message>
    <message>
        <source>digital output 0 off</source>
        <translation>salida digital 0 desactivada</translation>
    </message>
    <message>
        <source>take the screenshots</source>
        <translation>tomar las capturas de pantalla</translation>
    </message>
    <message>
        <source>Cannot write the screenshots to %1. Check the permissions of the folder and the free disk space.</source>
        <translation>No se pueden escribir las capturas de pantalla en %1. Compruebe los permisos de la carpeta y el espacio libre en disco.</translation>
    </message>
    <message>
        <source>stop recording</source>
        <translation>detener la grabación</translation>
    </message>
    <message>
        <source>%1: not completed within %2 s (%3)</source>
        <translation>%1: no se completó en %2 s (%3)</translation>
    </message>
    <message>
        <source>the robot reported no reason</source>
        <translation>el robot no comunicó el motivo</translation>
    </message>
    <message>
        <source>pressed again        %1 times: the motion had stopped before the button was released</source>
        <translation>pulsado de nuevo     %1 veces: el movimiento se había detenido antes de soltar el botón</translation>
    </message>
    <message>
        <source>jogged               </source>
        <translation>movido               </translation>
    </message>
    <message>
        <source>release to standstill </source>
        <translation>de soltar a reposo </translation>
    </message>
    <message>
        <source>packets              </source>
        <translation>paquetes              </translation>
    </message>
    <message>
        <source> received, </source>
        <translation> recibidos, </translation>
    </message>
    <message>
        <source> late, </source>
        <translation> tarde, </translation>
    </message>
    <message>
        <source> lost
</source>
        <translation> perdidos
</translation>
    </message>
    <message>
        <source>recorded             </source>
        <translation>grabado             </translation>
    </message>
    <message>
        <source> rows, </source>
        <translation> filas, </translation>
    </message>
    <message>
        <source>files                </source>
        <translation>archivos                </translation>
    </message>
    <message>
        <source>the window has no button “%1”</source>
        <translation>la ventana no tiene el botón «%1»</translation>
    </message>
    <message>
        <source>release the jog button</source>
        <translation>soltar el botón de jog</translation>
    </message>
    <message>
        <source>release the “Go to” button</source>
        <translation>soltar el botón «Ir a»</translation>
    </message>
</context>
<context>
    <name>tiller::app::DeviceSettings</name>
    <message>
        <source>Jog device</source>
        <translation>Dispositivo</translation>
    </message>
    <message>
        <source>Test device…</source>
        <translation>Probar dispositivo…</translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation>Muestra los valores actuales de cada dispositivo y la dirección en que se movería el brazo.</translation>
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
        <translation>Zona muerta: %1</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Deflection below which the device does not move the arm.</source>
        <translation>Desviación por debajo de la cual el dispositivo no mueve el brazo.</translation>
    </message>
    <message>
        <source>%1 curve</source>
        <translation>Curva: %1</translation>
    </message>
    <message>
        <source>exponent </source>
        <translation>exponente </translation>
    </message>
    <message>
        <source>1: linear. Higher values: finer near the centre, faster at full deflection.</source>
        <translation>1: lineal. Mayor: más fino cerca del centro, más rápido al final.</translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation>Solo el eje dominante</translation>
    </message>
    <message>
        <source>%1: dominant axis only</source>
        <translation>%1: solo el eje dominante</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>Zona muerta</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation>No se encontró ningún mando ni SpaceMouse. Conecte uno; se detecta automáticamente.</translation>
    </message>
    <message>
        <source>The device moves the arm only while the hold-to-run button is held. The selection is not stored: after a restart, no device moves the arm.</source>
        <translation>Mueve el brazo solo mientras se mantiene el botón de habilitación. No se guarda: tras un reinicio, ningún dispositivo mueve el brazo.</translation>
    </message>
</context>
<context>
    <name>tiller::app::DockStage</name>
    <message>
        <source>No panels are shown. Select a perspective at the lower right, or show a panel from the View menu.</source>
        <translation>No se muestra ningún panel. Seleccione una perspectiva abajo a la derecha o muestre un panel con el menú Vista.</translation>
    </message>
</context>
<context>
    <name>tiller::app::HelpPage</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>Ejercicios</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manual (en inglés)</translation>
    </message>
    <message>
        <source>Jogging and keys</source>
        <translation>Movimiento y teclas</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Índice</translation>
    </message>
    <message>
        <source>&lt;h2&gt;The manual is not installed on this PC&lt;/h2&gt;&lt;p&gt;The Debian package of Tiller contains the manual. To add the manual to your own build, install the package python3-sphinx:&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;Then build again. You can also read the pages as text in the folder packaging/manual of the source code. The page “Jogging and keys” of this window contains the jogging rules and all shortcuts.&lt;/p&gt;</source>
        <translation>&lt;h2&gt;El manual no está instalado en este ordenador&lt;/h2&gt;&lt;p&gt;El paquete Debian de Tiller lo contiene. Para añadirlo a su propia compilación, instale el paquete python3-sphinx:&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;Después compile otra vez. También puede leer las páginas como texto en la carpeta packaging/manual del código fuente. Las reglas del movimiento manual y todas las teclas están en la otra página de esta ventana.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;h2&gt;Moving the arm&lt;/h2&gt;&lt;p&gt;The arm moves while you hold a jog button, and stops when you release it. It also stops when&lt;/p&gt;&lt;ul&gt;&lt;li&gt;the pointer leaves the button, a different mouse button is pressed, or a second input device is used;&lt;/li&gt;&lt;li&gt;a modifier or an opposite key is pressed while a keyboard key is held;&lt;/li&gt;&lt;li&gt;the window loses focus, a dialog or menu opens, or the frame, speed, step or tab changes;&lt;/li&gt;&lt;li&gt;data from the robot are late, Tiller hangs, or the robot mode, the safety mode or Remote control changes;&lt;/li&gt;&lt;li&gt;the screen is locked, the PC goes to sleep, or the input device is unplugged or stops sending data;&lt;/li&gt;&lt;li&gt;the key-state check fails: on X11, Tiller checks every 10 ms with the display server that the button or key is still pressed. If the button or key is not pressed, or if the server does not respond for 100 ms, the motion ends. If the check is not available, the header and Settings show a note;&lt;/li&gt;&lt;li&gt;the maximum hold time is reached: %1 s for a jog (Settings), five minutes for Freedrive, the duration of the move plus 5 s for a move to a position. The last 3 s are counted down.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;After a stop, press the button or key again to move the arm. While Tiller is in control, &lt;b&gt;Space&lt;/b&gt; and &lt;b&gt;Esc&lt;/b&gt; stop the arm from every window, dialog and text field. When Tiller is not in control, they act on the focused element; click &lt;b&gt;STOP&lt;/b&gt; to stop a program from another client. This is a software stop, not an emergency stop: keep the emergency stop within reach.&lt;/p&gt;&lt;p&gt;Hold &lt;b&gt;Ctrl&lt;/b&gt; for one-tenth of the speed, or &lt;b&gt;Shift&lt;/b&gt; for three times the speed, up to the speed cap. On a keyboard without Latin letters, the letters below refer to key positions on a US keyboard.&lt;/p&gt;&lt;h2&gt;Commands&lt;/h2&gt;</source>
        <translation>&lt;h2&gt;Mover el brazo&lt;/h2&gt;&lt;p&gt;El brazo se mueve mientras mantiene pulsado un botón de movimiento y se detiene al soltarlo. También se detiene cuando&lt;/p&gt;&lt;ul&gt;&lt;li&gt;el puntero sale del botón, se pulsa otro botón del ratón o se usa un segundo dispositivo de entrada;&lt;/li&gt;&lt;li&gt;se pulsa un modificador o la tecla contraria mientras se mantiene una tecla del teclado;&lt;/li&gt;&lt;li&gt;la ventana pierde el foco, se abre un diálogo o menú, o cambia el sistema de coordenadas, la velocidad, el paso o la pestaña;&lt;/li&gt;&lt;li&gt;los datos del robot llegan tarde, este programa no responde o el robot sale de «En marcha», de su modo de seguridad o del control remoto;&lt;/li&gt;&lt;li&gt;se bloquea la pantalla, el PC entra en suspensión, o el dispositivo de entrada se desconecta o deja de enviar datos;&lt;/li&gt;&lt;li&gt;falla la comprobación de teclas: en X11, Tiller comprueba cada 10 ms en el servidor gráfico que el botón o la tecla sigue pulsado. Si no lo está, o si el servidor no responde durante 100 ms, el movimiento termina. Si la comprobación no está disponible, lo indican la cabecera y los ajustes;&lt;/li&gt;&lt;li&gt;se alcanza el tiempo máximo de pulsación: %1 s para el movimiento manual (Ajustes), cinco minutos para el movimiento libre, la duración del movimiento más 5 s para ir a una posición. Se muestra una cuenta atrás de los últimos 3 s.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;Después de una parada hay que pulsar de nuevo. Mientras Tiller tiene el control, &lt;b&gt;Espacio&lt;/b&gt; y &lt;b&gt;Esc&lt;/b&gt; detienen el brazo desde cualquier ventana, diálogo y campo de texto. Cuando Tiller no tiene el control, actúan sobre el elemento que tiene el foco; haga clic en &lt;b&gt;STOP&lt;/b&gt; para detener un programa de otro cliente. Es una parada por software, no una parada de emergencia: tenga la parada de emergencia a su alcance.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; hace el movimiento diez veces más fino y &lt;b&gt;Mayús&lt;/b&gt; tres veces más rápido, pero nunca por encima del límite. En un teclado sin letras latinas, las letras siguientes se refieren a su posición en un teclado de EE. UU.&lt;/p&gt;&lt;h2&gt;Órdenes&lt;/h2&gt;</translation>
    </message>
</context>
<context>
    <name>tiller::app::ImportDialog</name>
    <message>
        <source>Colours, sizes and units</source>
        <translation>Colores, tamaños y unidades</translation>
    </message>
    <message>
        <source>Speed cap and maximum hold time</source>
        <translation>Límite de velocidad y tiempo máximo de pulsación</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Atajos de teclado</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation>Gamepad y SpaceMouse</translation>
    </message>
    <message>
        <source>Robots and their grippers</source>
        <translation>Robots y sus pinzas</translation>
    </message>
    <message>
        <source>I/O names and scales</source>
        <translation>Nombres y escalas de entradas y salidas</translation>
    </message>
    <message>
        <source>Window layout</source>
        <translation>Disposición de la ventana</translation>
    </message>
    <message>
        <source>Other settings</source>
        <translation>Otros ajustes</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Sustituir</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Importar ajustes</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed.</source>
        <translation>%1 no se importó. No se cambió nada.</translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1:</source>
        <translation>Los ajustes seleccionados se sustituyen por los de %1:</translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1 (written by Tiller %2):</source>
        <translation>Los ajustes seleccionados se sustituyen por los de %1 (escrito por Tiller %2):</translation>
    </message>
    <message>
        <source>%1: identical</source>
        <translation>%1: idéntico</translation>
    </message>
    <message>
        <source>%1: not in the file</source>
        <translation>%1: no está en el archivo</translation>
    </message>
    <message>
        <source>%1: %2 in Tiller, %3 in the file</source>
        <translation>%1: %2 en Tiller, %3 en el archivo</translation>
    </message>
    <message>
        <source>The replaced settings are saved to a separate file, which can be imported again.</source>
        <translation>Los ajustes sustituidos se guardan en un archivo aparte, que se puede importar de nuevo.</translation>
    </message>
    <message>
        <source>All settings in the file match the current settings.</source>
        <translation>Todos los ajustes del archivo coinciden con los actuales.</translation>
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
        <translation>Teclado desarmado</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Sistemas</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/S</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>%1 disconnected. The arm was stopped.</source>
        <translation>%1 desconectado. El brazo se detuvo.</translation>
    </message>
    <message>
        <source>%1 stopped sending data while it was moving the arm. The arm was stopped. Release the device; if the problem persists, reconnect it.</source>
        <translation>%1 dejó de enviar datos mientras movía el brazo. El brazo se detuvo. Suelte el dispositivo; si el problema continúa, vuelva a conectarlo.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Open recent project</source>
        <translation>Abrir proyecto reciente</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Abrir proyecto…</translation>
    </message>
    <message>
        <source>Opens a project file.</source>
        <translation>Abre un archivo de proyecto.</translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation>Abrir proyecto de ejemplo…</translation>
    </message>
    <message>
        <source>Opens a copy of a sample project to try on the simulated robot.</source>
        <translation>Abre una copia de un proyecto de ejemplo para probarla en el robot simulado.</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>Guardar proyecto como…</translation>
    </message>
    <message>
        <source>Saves the project to a different file, and saves all further changes to that file automatically.</source>
        <translation>Guarda en este archivo ahora y después cada cambio automáticamente.</translation>
    </message>
    <message>
        <source>Show waypoints</source>
        <translation>Mostrar puntos de paso</translation>
    </message>
    <message>
        <source>Show frames</source>
        <translation>Mostrar sistemas</translation>
    </message>
    <message>
        <source>Show I/O</source>
        <translation>Mostrar E/S</translation>
    </message>
    <message>
        <source>Show log</source>
        <translation>Mostrar registro</translation>
    </message>
    <message>
        <source>Shows this tab.</source>
        <translation>Muestra esta pestaña.</translation>
    </message>
    <message>
        <source>Show gripper</source>
        <translation>Mostrar pinza</translation>
    </message>
    <message>
        <source>Shows the Gripper page of the I/O tab.</source>
        <translation>Muestra la página Pinza de la pestaña E/S.</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Restablecer disposición</translation>
    </message>
    <message>
        <source>Restores the panel layout of the current perspective.</source>
        <translation>Restablece la disposición de los paneles de la perspectiva actual.</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Colores claros</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Colores oscuros</translation>
    </message>
    <message>
        <source>Changes the colour theme. The setting is stored.</source>
        <translation>Cambia el tema de color. El ajuste se guarda.</translation>
    </message>
    <message>
        <source>Zero the force in the plots, or show the measured force</source>
        <translation>Poner a cero la fuerza en los gráficos, o mostrarla como se mide</translation>
    </message>
    <message>
        <source>Subtracts the current TCP force in the plots. Press again to show the measured force.</source>
        <translation>Resta la fuerza actual del TCP en los gráficos. Pulse de nuevo para mostrar la fuerza medida.</translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation>Órdenes…</translation>
    </message>
    <message>
        <source>Finds a command by name.</source>
        <translation>Encuentra una orden por su nombre.</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Ajustes…</translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation>Exportar ajustes…</translation>
    </message>
    <message>
        <source>Saves all settings to one file, for another computer or as a backup.</source>
        <translation>Guarda todos los ajustes en un archivo, para otro ordenador o como copia de seguridad.</translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation>Importar ajustes…</translation>
    </message>
    <message>
        <source>Shows which settings a file will replace, then imports them.</source>
        <translation>Muestra qué ajustes sustituirá un archivo y después los importa.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Stops the arm, ends the connection and closes the window.</source>
        <translation>Detiene el brazo, termina la conexión y cierra la ventana.</translation>
    </message>
    <message>
        <source>Load program</source>
        <translation>Cargar programa</translation>
    </message>
    <message>
        <source>Name of the program on the robot, as shown on the teach pendant</source>
        <translation>Nombre del programa en el robot, como se ve en la consola portátil</translation>
    </message>
    <message>
        <source>Name of the program on the robot, e.g. pick.urp</source>
        <translation>Nombre del programa en el robot, p. ej. pick.urp</translation>
    </message>
    <message>
        <source>Speed cap set to %1</source>
        <translation>Límite de velocidad ajustado a %1</translation>
    </message>
    <message>
        <source>A recording is running. Stop the recording first.</source>
        <translation>Hay una grabación en curso. Deténgala primero.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message numerus="yes">
        <source>The cell has more boxes or planes than the simulated robot supports: %n are ignored.</source>
        <translation>
            <numerusform>%n caja o plano de la celda supera el límite del robot simulado y este lo ignora.</numerusform>
            <numerusform>%n cajas o planos de la celda superan el límite del robot simulado y este los ignora.</numerusform>
        </translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Informar de un problema…</translation>
    </message>
    <message>
        <source>Shows versions, log and settings, then saves them to one file for support.</source>
        <translation>Muestra versiones, registro y ajustes y después los guarda en un archivo para el soporte.</translation>
    </message>
    <message>
        <source>Report saved: %1</source>
        <translation>Informe guardado: %1</translation>
    </message>
    <message>
        <source>Tiller closed unexpectedly</source>
        <translation>Tiller se cerró de forma inesperada</translation>
    </message>
    <message>
        <source>Tiller saved a crash log. You can attach it to a problem report.</source>
        <translation>Tiller guardó un registro del fallo. Puede adjuntarlo a un informe de problemas.</translation>
    </message>
    <message>
        <source>Opens the manual page for the focused control, the list of commands and shortcuts, and the jogging rules.</source>
        <translation>Abre la página del manual del elemento con foco, la lista de órdenes y atajos, y las reglas del movimiento manual.</translation>
    </message>
    <message>
        <source>The settings could not be saved. %1</source>
        <translation>No se pudieron guardar los ajustes. %1</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Deshecho: %1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>Rehecho: %1</translation>
    </message>
    <message>
        <source>Adapt project to this robot…</source>
        <translation>Adaptar el proyecto a este robot…</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Tomar el control</translation>
    </message>
    <message>
        <source>A program is paused on the robot.</source>
        <translation>Hay un programa en pausa en el robot.</translation>
    </message>
    <message>
        <source>A program is running on the robot.</source>
        <translation>Hay un programa en marcha en el robot.</translation>
    </message>
    <message>
        <source>The program “%1” is paused on the robot.</source>
        <translation>El programa «%1» está en pausa en el robot.</translation>
    </message>
    <message>
        <source>The program “%1” is running on the robot.</source>
        <translation>El programa «%1» está en marcha en el robot.</translation>
    </message>
    <message>
        <source>Taking control stops the program. The program cannot be resumed, only restarted.</source>
        <translation>Al tomar el control se detiene el programa. No se puede reanudar, solo reiniciar.</translation>
    </message>
    <message>
        <source>Stop program and take control</source>
        <translation>Detener el programa y tomar el control</translation>
    </message>
    <message>
        <source>Keep program</source>
        <translation>Mantener el programa</translation>
    </message>
    <message>
        <source>Waypoints, Program, Frames, Tools, I/O, Log</source>
        <translation>Puntos, Programa, Sistemas, Herramientas, E/S, Registro</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Powering off stops the program. The program cannot be resumed, only restarted.</source>
        <translation>Al apagar se detiene el programa. No se puede reanudar, solo reiniciar.</translation>
    </message>
    <message>
        <source>Stop program and power off</source>
        <translation>Detener el programa y apagar</translation>
    </message>
    <message>
        <source>A path is being recorded. Stop the path recording first.</source>
        <translation>Se está grabando una trayectoria. Deténgala primero.</translation>
    </message>
    <message>
        <source>Close window</source>
        <translation>Cerrar ventana</translation>
    </message>
    <message>
        <source>A recording is running.</source>
        <translation>Hay una grabación en curso.</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>Proyecto nuevo…</translation>
    </message>
    <message>
        <source>Starts an empty project in a new file.</source>
        <translation>Inicia un proyecto vacío en un archivo nuevo.</translation>
    </message>
    <message>
        <source>The change takes effect immediately and may disturb the program.</source>
        <translation>El cambio tiene efecto inmediato y puede perturbar el programa.</translation>
    </message>
    <message>
        <source>Change anyway</source>
        <translation>Cambiar de todos modos</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Change while a program is active</source>
        <translation>Cambio con un programa activo</translation>
    </message>
    <message>
        <source>Change connection</source>
        <translation>Cambiar conexión</translation>
    </message>
    <message>
        <source>Do not ask again during this program</source>
        <translation>No volver a preguntar durante este programa</translation>
    </message>
    <message>
        <source>A program is loaded on the robot.</source>
        <translation>Hay un programa cargado en el robot.</translation>
    </message>
    <message>
        <source>The program “%1” is loaded on the robot.</source>
        <translation>El programa «%1» está cargado en el robot.</translation>
    </message>
    <message>
        <source>Pausing stops the arm until the program is resumed.</source>
        <translation>El brazo se detiene hasta que se reanude el programa.</translation>
    </message>
    <message>
        <source>The program cannot be resumed, only restarted.</source>
        <translation>El programa no se puede reanudar, solo reiniciar.</translation>
    </message>
    <message>
        <source>The arm may move immediately. Make sure that no one is within reach of the arm.</source>
        <translation>El brazo puede moverse de inmediato. Asegúrese de que no haya nadie al alcance del brazo.</translation>
    </message>
    <message>
        <source>Resume program</source>
        <translation>Reanudar programa</translation>
    </message>
    <message>
        <source>Start program</source>
        <translation>Iniciar programa</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Detener y cerrar</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>Mantener en marcha</translation>
    </message>
    <message>
        <source>Stop and continue</source>
        <translation>Detener y continuar</translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation>Se está ejecutando un programa. Pare primero el programa.</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Guardar proyecto</translation>
    </message>
    <message>
        <source>Keyboard jogging was disarmed, because an input field has the focus: the keys now edit the field. Arm the keyboard again to jog.</source>
        <translation>El teclado se ha desarmado porque un campo de entrada tiene el foco: las teclas editan ahora el campo. Arme de nuevo el teclado para mover el brazo.</translation>
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
        <translation>Teclado armado: las flechas mueven en X e Y, RePág y AvPág en Z; con Alt giran la herramienta. Mantenga pulsado 1 a 6 y pulse + o − para mover una articulación. Espacio y Esc detienen el brazo.</translation>
    </message>
    <message>
        <source>Changes the theme, sizes, units, speed cap, devices and keyboard shortcuts.</source>
        <translation>Tema, tamaños, unidades, límite de velocidad, dispositivos y atajos de teclado.</translation>
    </message>
    <message>
        <source>This activity stops when you close the window.</source>
        <translation>Esto se detiene al cerrar la ventana.</translation>
    </message>
    <message>
        <source>This activity stops when you change the connection.</source>
        <translation>Esto se detiene al cambiar la conexión.</translation>
    </message>
    <message>
        <source>Saves the project now. Tiller also saves all changes automatically. If another window or program has changed the file, Tiller asks whether to reload the file or keep both versions.</source>
        <translation>Guarda el proyecto ahora. Tiller también guarda todos los cambios automáticamente. Si otra ventana u otro programa ha modificado el archivo, pregunta si se recarga o se conservan ambas versiones.</translation>
    </message>
    <message>
        <source>Converts a project for a different robot model, keeping either the poses or the joint positions.</source>
        <translation>Convierte un proyecto para otro modelo de robot y conserva las poses o las posiciones articulares.</translation>
    </message>
    <message>
        <source>A program is running. Stop the program before you open a different project.</source>
        <translation>Se está ejecutando un programa. Pare el programa antes de abrir otro proyecto.</translation>
    </message>
</context>
<context>
    <name>tiller::app::PanelDock</name>
    <message>
        <source>Dock</source>
        <translation>Acoplar</translation>
    </message>
    <message>
        <source>Moves this panel back to the main window.</source>
        <translation>Devuelve este panel a la ventana principal.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Closes this panel. Use the View menu to show it again.</source>
        <translation>Cierra este panel. Use el menú Vista para mostrarlo de nuevo.</translation>
    </message>
    <message>
        <source>Move, float or close %1</source>
        <translation>Mover, separar o cerrar %1</translation>
    </message>
    <message>
        <source>Click to move, float or close this panel. Drag to move it.</source>
        <translation>Haga clic para mover, soltar o cerrar este panel. Arrastre para moverlo.</translation>
    </message>
</context>
<context>
    <name>tiller::app::PerspectiveActions</name>
    <message>
        <source>Save perspective</source>
        <translation>Guardar perspectiva</translation>
    </message>
    <message>
        <source>Saves the current panel layout to the current perspective.</source>
        <translation>Guarda la disposición actual de los paneles en la perspectiva actual.</translation>
    </message>
    <message>
        <source>Save perspective as…</source>
        <translation>Guardar perspectiva como…</translation>
    </message>
    <message>
        <source>Saves the current panel layout under a new name.</source>
        <translation>Guarda la disposición actual de los paneles con un nombre nuevo.</translation>
    </message>
    <message>
        <source>Save perspective as</source>
        <translation>Guardar perspectiva como</translation>
    </message>
    <message>
        <source>Rename perspective…</source>
        <translation>Renombrar perspectiva…</translation>
    </message>
    <message>
        <source>Renames the current perspective.</source>
        <translation>Cambia el nombre de la perspectiva actual.</translation>
    </message>
    <message>
        <source>Rename perspective</source>
        <translation>Renombrar perspectiva</translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be renamed.</source>
        <translation>Esta perspectiva está predefinida y no se puede renombrar.</translation>
    </message>
    <message>
        <source>Delete perspective…</source>
        <translation>Eliminar perspectiva…</translation>
    </message>
    <message>
        <source>Deletes the current perspective. The panel layout does not change.</source>
        <translation>Elimina la perspectiva actual. La disposición de los paneles no cambia.</translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be deleted.</source>
        <translation>Esta perspectiva está predefinida y no se puede eliminar.</translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation>Perspectiva %1</translation>
    </message>
    <message>
        <source>Perspective %1. Select a panel layout, or save the current layout.</source>
        <translation>Perspectiva %1. Seleccione una disposición de paneles o guarde la actual.</translation>
    </message>
    <message>
        <source>Perspective name</source>
        <translation>Nombre de la perspectiva</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Delete perspective</source>
        <translation>Eliminar perspectiva</translation>
    </message>
    <message>
        <source>Delete the perspective “%1”? This cannot be undone.</source>
        <translation>¿Eliminar la perspectiva «%1»? No se puede deshacer.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>This perspective is built in. Save it under a different name.</source>
        <translation>Esta perspectiva está predefinida. Guárdela con otro nombre.</translation>
    </message>
</context>
<context>
    <name>tiller::app::Perspectives</name>
    <message>
        <source>Teach</source>
        <translation>Enseñar</translation>
    </message>
    <message>
        <source>Shows the view, the waypoints next to it and the plots below.</source>
        <translation>Muestra la vista, los puntos de paso al lado y los gráficos debajo.</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>Supervisar</translation>
    </message>
    <message>
        <source>Shows inputs and outputs, a smaller view next to them and taller plots below.</source>
        <translation>Muestra entradas y salidas, una vista menor al lado y gráficos más altos debajo.</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Shows only the plots, as large as possible.</source>
        <translation>Muestra solo los gráficos, lo más grandes posible.</translation>
    </message>
    <message>
        <source>Shows the panels as you saved them.</source>
        <translation>Muestra los paneles como los guardó.</translation>
    </message>
    <message>
        <source>The perspective “%1” cannot be shown because the stored layout is damaged. Arrange the panels and save the perspective again.</source>
        <translation>No se puede mostrar la perspectiva «%1»: su disposición guardada está dañada. Ordene los paneles y guárdela de nuevo.</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Introduzca un nombre.</translation>
    </message>
    <message>
        <source>The maximum number of perspectives has been reached. Delete a perspective first.</source>
        <translation>Se alcanzó el número máximo de perspectivas. Elimine primero una.</translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the layout of the earlier version is not compatible. Arrange the panels again. The new layout is saved automatically.</source>
        <translation>La disposición de los paneles se restableció a la perspectiva «%1»: la disposición de la versión anterior no es compatible. Ordene los paneles de nuevo. La nueva disposición se guarda automáticamente.</translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the stored layout is damaged or from another version. Arrange the panels again. The new layout is saved automatically.</source>
        <translation>La disposición de los paneles se restableció a la perspectiva «%1»: la disposición guardada está dañada o es de otra versión. Ordene los paneles de nuevo. La nueva disposición se guarda automáticamente.</translation>
    </message>
    <message>
        <source>The name is too long. Enter a shorter name.</source>
        <translation>El nombre es demasiado largo. Introduzca un nombre más corto.</translation>
    </message>
    <message>
        <source>A perspective with this name already exists. Choose a different name.</source>
        <translation>Ya existe una perspectiva con este nombre. Elija otro nombre.</translation>
    </message>
</context>
<context>
    <name>tiller::app::RecordingSettings</name>
    <message>
        <source>Folder for recordings</source>
        <translation>Carpeta de grabaciones</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the folder for recordings</source>
        <translation>Elegir la carpeta de grabaciones</translation>
    </message>
    <message>
        <source>File name pattern</source>
        <translation>Patrón del nombre de archivo</translation>
    </message>
    <message>
        <source>{date}, {time}, {robot} and {number} are replaced when a recording starts.</source>
        <translation>{date}, {time}, {robot} y {number} se sustituyen al iniciar una grabación.</translation>
    </message>
    <message>
        <source>Packets/row</source>
        <translation>Paquetes/fila</translation>
    </message>
    <message>
        <source>Search signals</source>
        <translation>Buscar señales</translation>
    </message>
    <message>
        <source>Signals in a recording</source>
        <translation>Señales en una grabación</translation>
    </message>
    <message>
        <source>All signals</source>
        <translation>Todas las señales</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>File name</source>
        <translation>Nombre de archivo</translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation>UR5e del laboratorio</translation>
    </message>
    <message>
        <source>Example: %1. {date}, {time}, {robot}, {number} are placeholders. Existing files are never overwritten.</source>
        <translation>Ejemplo: %1. {date}, {time}, {robot} y {number} son marcadores. Los archivos existentes nunca se sobrescriben.</translation>
    </message>
    <message numerus="yes">
        <source>%n packet(s) per row: %1 rows per second from a robot that sends 500 packets per second.</source>
        <translation>
            <numerusform>%n paquete por fila: %1 filas por segundo de un robot que envía 500 paquetes por segundo.</numerusform>
            <numerusform>%n paquetes por fila: %1 filas por segundo de un robot que envía 500 paquetes por segundo.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording format</source>
        <translation>Formato de grabación</translation>
    </message>
    <message>
        <source>Free disk space to keep, in megabytes</source>
        <translation>Espacio libre en disco que conservar, en megabytes</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Recording stops, and the file is saved, before the free disk space falls below this value.</source>
        <translation>Una grabación se detiene y se completa antes de que el espacio libre baje de este valor.</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Keep free</source>
        <translation>Dejar libre</translation>
    </message>
    <message>
        <source>Maximum duration of a file, in minutes</source>
        <translation>Duración máxima de un archivo, en minutos</translation>
    </message>
    <message>
        <source>Maximum size of a file, in megabytes</source>
        <translation>Tamaño máximo de un archivo, en megabytes</translation>
    </message>
    <message>
        <source>Recorded time before the trigger, in seconds</source>
        <translation>Tiempo grabado antes del disparador, en segundos</translation>
    </message>
    <message>
        <source>Recorded time after the trigger, in seconds</source>
        <translation>Tiempo grabado después del disparador, en segundos</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Sin límite</translation>
    </message>
    <message>
        <source>A longer recording continues in a new file without losing packets.</source>
        <translation>Una grabación más larga continúa en un archivo nuevo sin perder paquetes.</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation>Metadatos de las grabaciones</translation>
    </message>
    <message>
        <source>When to enter metadata</source>
        <translation>Cuándo introducir los metadatos</translation>
    </message>
    <message>
        <source>Use for each recording</source>
        <translation>Usar siempre</translation>
    </message>
    <message>
        <source>Ask before each recording</source>
        <translation>Preguntar cada vez</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Disparador</translation>
    </message>
    <message>
        <source>None: recording starts at once</source>
        <translation>Ninguno: graba enseguida</translation>
    </message>
    <message>
        <source>Combine conditions with “and” and “or”, for example:
norm(actual_TCP_force_0, actual_TCP_force_1) &gt; 20 and robot_mode = 7
actual_digital_input_bits:3 = 1
runtime_state changes
program starts</source>
        <translation>Combine condiciones con «and» y «or», por ejemplo:
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
        <translation>Dividir tras</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>Metadatos</translation>
    </message>
    <message>
        <source>Before trigger</source>
        <translation>Antes de él</translation>
    </message>
    <message>
        <source>after</source>
        <translation>después</translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation>Metadatos…</translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>Metadatos (%n campo)…</numerusform>
            <numerusform>Metadatos (%n campos)…</numerusform>
        </translation>
    </message>
    <message>
        <source>With a trigger, Tiller records only while the condition is true, in numbered files.</source>
        <translation>Con un disparador, Tiller solo graba mientras se cumple la condición, en archivos numerados.</translation>
    </message>
</context>
<context>
    <name>tiller::app::ReportDialog</name>
    <message>
        <source>Include names and addresses of robots, inputs, outputs and files</source>
        <translation>Con nombres y direcciones de robots, entradas, salidas y archivos</translation>
    </message>
    <message>
        <source>Report a problem</source>
        <translation>Informar de un problema</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Qué ocurrió</translation>
    </message>
    <message>
        <source>What did you do? What did you expect? What happened?</source>
        <translation>¿Qué hizo? ¿Qué esperaba? ¿Qué ocurrió?</translation>
    </message>
    <message>
        <source>Report files</source>
        <translation>Archivos del informe</translation>
    </message>
    <message>
        <source>File content</source>
        <translation>Contenido de este archivo</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>Guardar informe…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>The report is one file with the information that support needs. The complete content is listed below. You choose where to save the file. Tiller does not send it.</source>
        <translation>Un archivo con la información que necesita el soporte. Abajo se muestra todo su contenido. El archivo se guarda donde usted elija; Tiller no lo envía.</translation>
    </message>
    <message>
        <source>Tiller report %1.zip</source>
        <translation>Informe de Tiller %1.zip</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Guardar informe</translation>
    </message>
    <message>
        <source>Zip archives (*.zip)</source>
        <translation>Archivos zip (*.zip)</translation>
    </message>
</context>
<context>
    <name>tiller::app::SampleDialog</name>
    <message>
        <source>Open sample project</source>
        <translation>Abrir proyecto de ejemplo</translation>
    </message>
    <message>
        <source>Each project was taught with a UR5e and runs on the simulated robot. You work on a copy. To keep your changes, save the project to a new file.</source>
        <translation>Cada proyecto se enseñó con un UR5e y funciona en el robot simulado. Usted trabaja con una copia: elija un archivo nuevo para guardarla.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open “%1”</source>
        <translation>Abrir «%1»</translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Appearance and motion</source>
        <translation>Aspecto y movimiento</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Dispositivos</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Grabación</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Atajos</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation>Exportar ajustes…</translation>
    </message>
    <message>
        <source>Save all settings to one file, for another computer or as a backup</source>
        <translation>Guardar todos los ajustes en un archivo, para otro ordenador o como copia de seguridad</translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation>Importar ajustes…</translation>
    </message>
    <message>
        <source>Show which settings a file will replace, then import them</source>
        <translation>Mostrar qué ajustes sustituirá un archivo y después importarlos</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Control size</source>
        <translation>Tamaño de los controles</translation>
    </message>
    <message>
        <source>Compact</source>
        <translation>Compacto</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Ratón</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Táctil</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Interface size</source>
        <translation>Tamaño de la interfaz</translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation>Unidad de longitud</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Milímetros</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pulgadas</translation>
    </message>
    <message>
        <source>Orientation format</source>
        <translation>Formato de orientación</translation>
    </message>
    <message>
        <source>Roll, pitch, yaw in degrees</source>
        <translation>Alabeo, cabeceo, guiñada en grados</translation>
    </message>
    <message>
        <source>Rotation vector in radians, as in scripts</source>
        <translation>Vector de rotación en radianes, como en los scripts</translation>
    </message>
    <message>
        <source>Tiller speed cap</source>
        <translation>Límite de velocidad de Tiller</translation>
    </message>
    <message>
        <source>Maximum hold time</source>
        <translation>Tiempo máximo de pulsación</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>After this time, a jog stops and its button must be pressed again. Freedrive has a limit of five minutes. A move to a position has a limit of its duration plus 5 s.</source>
        <translation>Después de este tiempo, el movimiento manual se detiene y hay que pulsar el botón de nuevo. Movimiento libre: cinco minutos. Ir a una posición: su duración más 5 s.</translation>
    </message>
    <message>
        <source>Touch: large enough for fingers. In windows less than %1 px high, joint buttons, tabs and title bars remain smaller.</source>
        <translation>Táctil: suficientemente grande para los dedos. En ventanas de menos de %1 px de alto, los botones de articulación, pestañas y barras de título siguen siendo más pequeños.</translation>
    </message>
    <message>
        <source>Units for displaying and entering lengths, TCP speeds and orientations. The units in plots and files do not change.</source>
        <translation>Unidades para mostrar e introducir longitudes, velocidades del TCP y orientaciones. Las unidades de gráficos y archivos no cambian.</translation>
    </message>
    <message>
        <source>Speed cap</source>
        <translation>Límite de velocidad</translation>
    </message>
    <message>
        <source>Scales text, controls, plots and the view.</source>
        <translation>Escala el texto, los controles, los gráficos y la vista.</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted, limited to %1 % on this screen.</source>
        <translation>Se aplica en el próximo inicio de Tiller, limitado a %1 % en esta pantalla.</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted.</source>
        <translation>Se aplica en el próximo inicio de Tiller.</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Atajos de teclado</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Atajo</translation>
    </message>
    <message>
        <source>Restore default shortcuts</source>
        <translation>Restaurar atajos predeterminados</translation>
    </message>
    <message>
        <source>Shortcut for %1</source>
        <translation>Atajo de %1</translation>
    </message>
    <message>
        <source>%1 is reserved for stopping the arm.</source>
        <translation>%1 está reservada para detener el brazo.</translation>
    </message>
    <message>
        <source>%1 is assigned to “%2”. Remove that shortcut first.</source>
        <translation>%1 está asignada a «%2». Quite primero ese atajo.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>System language: %1</source>
        <translation>Idioma del sistema: %1</translation>
    </message>
    <message>
        <source>Reopen window</source>
        <translation>Abrir la ventana de nuevo</translation>
    </message>
    <message>
        <source>Stops the arm, gives control back and reconnects. The plots restart. The project is saved.</source>
        <translation>Detiene el brazo, devuelve el control y se reconecta. Los gráficos empiezan de nuevo. El proyecto se guarda.</translation>
    </message>
    <message>
        <source>Language of the window and of the connection check. Files and scripts are not affected.</source>
        <translation>Idioma de la ventana y de la comprobación de la conexión. Los archivos y scripts no se ven afectados.</translation>
    </message>
    <message>
        <source>Monitor only</source>
        <translation>Solo supervisión</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>For PCs that only monitor: this window does not take control, set outputs or start programs. STOP still works.</source>
        <translation>Para equipos que solo supervisan: esta ventana no toma el control, no cambia salidas ni inicia programas. STOP sigue funcionando.</translation>
    </message>
    <message>
        <source>Monitor only (set on the command line)</source>
        <translation>Solo supervisión (definido en la línea de órdenes)</translation>
    </message>
    <message>
        <source>Press the new shortcut in the field, or Backspace to remove the shortcut. While Tiller is in control, Space and Esc always stop the arm.</source>
        <translation>Pulse el nuevo atajo en el campo; Retroceso lo elimina. Mientras Tiller tiene el control, Espacio y Esc siempre detienen el brazo.</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted or the window is reopened. The plots then restart.</source>
        <translation>Se aplica al reiniciar Tiller o al reabrir la ventana. Los gráficos empiezan entonces de nuevo.</translation>
    </message>
    <message>
        <source>Maximum speed of the TCP and elbow for all motion commanded by Tiller. A change takes effect immediately and stops any motion.</source>
        <translation>Velocidad máxima de TCP y codo para todo movimiento ordenado por Tiller. Se aplica de inmediato y detiene el movimiento en curso.</translation>
    </message>
    <message>
        <source>▲ Above %1. Manual mode and the enabling device of the teach pendant do not limit jogging from a PC. The header shows a warning. The cap is reset when Tiller is closed.</source>
        <translation>▲ Por encima de %1. El modo manual y el dispositivo de habilitación de la consola no limitan el movimiento desde un PC. La cabecera muestra un aviso. El límite se restablece al cerrar Tiller.</translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsTransfer</name>
    <message>
        <source>Tiller settings (*.json)</source>
        <translation>Ajustes de Tiller (*.json)</translation>
    </message>
    <message>
        <source>Export settings</source>
        <translation>Exportar ajustes</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Importar ajustes</translation>
    </message>
    <message>
        <source>Settings exported to %1</source>
        <translation>Ajustes exportados a %1</translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed. %2</source>
        <translation>%1 no se importó. No se cambió nada. %2</translation>
    </message>
    <message>
        <source>Settings imported from %1. The previous settings were saved to %2.</source>
        <translation>Ajustes importados de %1. Los ajustes anteriores se guardaron en %2.</translation>
    </message>
</context>
<context>
    <name>tiller::app::Tutorial</name>
    <message>
        <source>First steps</source>
        <translation>Primeros pasos</translation>
    </message>
    <message>
        <source>Shows a checklist in the view, from powering on to recording.</source>
        <translation>Muestra en la vista una lista de comprobación, desde el encendido hasta la grabación.</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>Ejercicios</translation>
    </message>
    <message>
        <source>Five tasks on the simulated robot. Each task checks the result.</source>
        <translation>Cinco ejercicios en el robot simulado. Cada uno comprueba el resultado.</translation>
    </message>
    <message>
        <source>Practice works only with the built-in simulated robot. The current robot is “%1”. Connect to the simulated robot first.</source>
        <translation>Los ejercicios solo funcionan con el robot simulado integrado. El robot actual es «%1». Conéctese primero al robot simulado.</translation>
    </message>
    <message>
        <source>Practice: add “%1”</source>
        <translation>Ejercicio: añadir «%1»</translation>
    </message>
</context>
</TS>
