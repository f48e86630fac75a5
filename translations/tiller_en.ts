<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ActionStep</name>
    <message>
        <source>No gripper is configured for this robot. Select a gripper under I/O &gt; Gripper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run route</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 did not turn on within %2 s. Check the connected device, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 did not turn off within %2 s. Check the connected device, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The action “%1” was not completed. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper did not stop moving within %1 s. Check the gripper, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ActionTable</name>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power and safety</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control and programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Application</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I/O</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspectives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program steps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ActionWords</name>
    <message>
        <source>%1 on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 on for %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 off for %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until %1 is on (max. %2 s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until %1 is off (max. %2 s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until %1 is on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until %1 is off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set an output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulse an output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for an input</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Jog, teach, run and monitor a Universal Robots arm from a PC.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with the built-in simulated UR5e.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to the robot at this address or host name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the scripted demonstration on the simulated robot, write its files to this folder, and exit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open this project file (.tiller).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour theme: light or dark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>see tiller --help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--theme must be light or dark, not &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--robot and --simulator cannot be combined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--demo works only on the simulated robot and cannot be combined with --robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--demo requires a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--robot requires an address, e.g. --robot 192.168.0.10</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only one project can be opened; remove &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monitor only: do not change anything on the robot; STOP still works. Cannot be turned off in Settings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--demo moves the simulated robot and cannot be combined with --monitor-only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open these recordings in the plots.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>Joint positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: within %2 at all times, maximum %3 at %4 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>TCP 6.2 mm</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: %2 deviates by %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the TCP deviates by %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the current of %2 deviates by %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: a force of %2 acts on the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motion matches the model of a %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to compare: the arm was powered off or guided by hand for the whole recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm deviates from the model from the start of the recording. Check the payload and the robot model, and check whether something was touching the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From this time on, the arm was pushed or held, its payload differed, or a joint did not follow its target.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: its sampling interval is too long. Record every packet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not compared with the arm model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The compared values match the model of a %1; other values were not recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recorded arm is a %1, but it was compared with the model of a %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No deviation from the model of a %1, but the recorded values may fit other models too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare the recording with the model of a %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not compared because the recording has no %2; record all signals to an MCAP file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: target or actual joint positions are missing. Record all signals to an MCAP file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: exceeds %2 starting at %3 s (%4), maximum %5 at %6 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ControllerCodes</name>
    <message>
        <source>Near a joint limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A joint came close to its limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog the joint away from the limit, or change the waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near a tool orientation limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool orientation came close to the limit set in the safety configuration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate the tool away from the limit, or change the waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near a safety plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm came close to a safety plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog away from the plane, or change the waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position deviates from path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is not at the commanded position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check for obstacles; check payload, centre of gravity and mounting; reduce the acceleration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Singularity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The linear move passes through a singularity of the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog individual joints away from the singularity. Use MoveJ to pass through the region.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot hold position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm sagged or was pushed while at standstill.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check payload, centre of gravity and mounting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrong payload or mounting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measured forces do not match the payload, or the arm was pushed when Freedrive started.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collision detected by a joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A joint required more torque than expected for the motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the obstacle. If the arm did not touch anything, check the payload.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collision detected at the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force at the tool exceeded the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A joint deviated from its commanded position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check for obstacles, and check payload and mounting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many protective stops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One joint had fifty protective stops within eight hours.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find and correct the cause of the stops, then restart the controller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sudden change in target position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the program at the current position of the arm, and send servo targets in small steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sudden change in target speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reduce the acceleration, or smooth the path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protective stop requested by a program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The running program requested the stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See the preceding program messages in the log.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A script was sent, but the robot accepts commands only from its teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch to Remote control on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Controller message C%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller has no description of this message code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look up C%1 in the manufacturer&apos;s error code directory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct the payload and the mounting, and do not push the arm when Freedrive starts.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DerivedSignal</name>
    <message>
        <source>compute a signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The signal “%1” does not exist. See the signal list for the names.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The expression contains no signal. Add the name of a signal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The expression contains too many signals. Use fewer signals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The expression must evaluate to one number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The text is too long. Use a shorter name or expression.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a name, an equals sign and an expression, for example |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many equals signs. Use == to compare values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The functions are nested too deeply. Use at most %1 levels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The closing parenthesis of “%1” is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression, a cut-off frequency in Hz and optionally the order (1 to 8), for example %1(actual_q_0, 10, 2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression and a time window in seconds, for example %1(actual_q_0, 0.5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cut-off frequency of “%1” must be between %2 and %3 Hz.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time window of “%1” must be between 0.001 and 60 seconds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The function “%1” does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” contains a decimal comma. Write decimal numbers with a point: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DeviceTrainer</name>
    <message>
        <source>%1 in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device axes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Doctor</name>
    <message>
        <source>%1 and %2 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the RTDE port accepts connections but does not respond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the service on port %1 does not use RTDE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many RTDE clients are connected, or the controller has stopped responding. Close other programs, then restart the controller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the address. The address may belong to another device, or another program may be using the port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>protocol version %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another program uses %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the other program that controls this robot (another Tiller window, ROS, ur_rtde).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this software version has no registers 24 to 47</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update the robot&apos;s software to 3.9, 5.3 or newer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>registers 24 to 47 are free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a fieldbus adapter or another program uses %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No action needed for jogging. To use these registers, disable EtherNet/IP, PROFINET or MODBUS in the robot&apos;s installation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>registers 0 to 23 are free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s software is too old. Update the software to %1.%2 or newer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some values and the control registers are missing. Update the robot&apos;s software to %1.%2 or newer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inspect the arm and remove the cause. Then press “Recover…” in the Tiller header, or use the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes, with the button in the Tiller header or on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot accepts the subscription but sends no data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other RTDE programs, then restart the robot&apos;s controller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 packets per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packets are missing. Use a cable instead of a wireless link, and close other programs that put load on the robot or this PC.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>priority %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the system does not grant this user real-time priority</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP %1 mm from the flange, payload %2 kg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If a tool is mounted, set the TCP and the payload in the robot&apos;s installation: a wrong payload causes protective stops and makes the arm drift in Freedrive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a valid address, and no host with this name was found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter the IP address shown on the teach pendant under About, or ask your network administrator for the host name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not respond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no network route to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and no firewall blocks the connection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign this PC an address in the robot&apos;s network (the same first three numbers), and check the cable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 responds, but provides no robot services</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that this is the address of the robot. A robot that has just been switched on may need another minute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 responds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dashboard, port %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>port %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>port %1 is closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>port %1 does not respond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enable this interface on the robot under Settings &gt; Security &gt; Services.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A firewall may be blocking this port. Allow TCP port %1 to the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant. Until then, Tiller can only monitor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the dashboard accepts connections but does not respond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the service on port %1 is not a dashboard server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart the robot&apos;s controller. If the problem persists, see the controller log.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the address, and check that no other program is using this port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this series has no Local/Remote switch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remote</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neither the dashboard (port %1) nor the Robot API (port %2) is available</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the primary interface sends no data about the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that this is the address of the robot, and restart its controller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot type %1 is not known to this version of Tiller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monitoring works. Limits and previews use the dimensions that the robot reports; jog slowly at first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address resolves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Host responds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RTDE port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Primary port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Secondary port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Real-time port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dashboard or Robot API</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RTDE protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Controller software</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remote control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power and brakes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control registers free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Real-time priority on this PC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP and payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPUs may enter deep sleep states, which delay real-time loops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enable the dashboard server on the robot under Settings &gt; Security &gt; Services. On PolyScope X, the Robot API requires version 10.11 or newer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot API %1, port %2; popups can be closed only on the teach pendant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fieldbus registers free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real-time loops can keep the CPUs out of deep sleep states</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wake-up latency on this PC</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Freedrive</name>
    <message>
        <source>All axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>XY plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for standstill before you start Freedrive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm would drift: the robot measures %1 with a payload of %2 kg. Do not touch the tool, or correct the payload and the TCP.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Gamepad</name>
    <message>
        <source>left bumper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left stick: X and Y. Right stick: Z and rotation. Hold the right bumper to rotate with both sticks.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>InterfaceSize</name>
    <message>
        <source>This screen has a high resolution. Increase “Interface size” in Settings to enlarge text, controls and plots.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>JogActions</name>
    <message>
        <source>Jog speed %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog step %1, %2°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm or disarm keyboard jogging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While the keyboard is armed, the arrow keys move the arm and a border surrounds the window. The keyboard is disarmed after 30 s without use.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the TCP displacement from the current position. Press again to show the displacement since the start of the last motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the arm. The next press uses this speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the arm by this distance while the button is held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each press moves the arm by this distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog until contact (%1 N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves slowly while the button is held and stops when the contact force reaches this value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other jog speed…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the TCP speed. Rotation and joint speeds change in proportion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other jog step…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other contact force for jogging…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the contact force in N that ends the motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freedrive: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selects the axes that can be moved by hand during Freedrive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the step length. The step angle does not change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other jog angle…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the step angle of tool and joint rotations. The step length does not change.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>JogColumn</name>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>JointNames</name>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>KeyStateProbe</name>
    <message>
        <source>Key-state check unavailable on this platform (%1): Tiller relies on window events to detect key releases.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key-state check active: Tiller checks with the display server every 10 ms whether the button or key is still pressed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key-state check unavailable: Tiller could not open a second connection to the display server. Tiller relies on window events to detect key releases.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LimiterAdvice</name>
    <message>
        <source>Elbow almost straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elbow almost straight: %1 speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bend the elbow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog %1 or bend the elbow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist near the base axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist near the base axis: %1 speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move outwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog %1 or rotate the base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°: %1 speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotate wrist 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog %1 or rotate wrist 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2° from its limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotate %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog %1 or rotate %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP at the speed cap: %1 speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change the cap in Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elbow at the speed cap: %1 speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation at the speed cap: %1 speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at its maximum speed: %2 speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose a lower speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2 from %3: %4 speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2 from %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LocalSimulator</name>
    <message>
        <source>Simulated UR5e</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ModeLook</name>
    <message>
        <source>MOVING</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot reports that the arm is moving.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remote</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monitoring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packets are late or lost: jogging may stop and plots may have gaps. Use a cable instead of a wireless link, and close other programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands take longer than 20 ms: the arm responds with a delay. Jog slowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: the arm responds immediately and stops within 250 ms if the link fails.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Late: %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LINK · JOG STOPS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LINK</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LINK · JOG MAY STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LINK · ARM LAGS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LINK · GOOD</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the simulator or enter the address of a robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the cause of the stop, the five seconds before it, and the recovery steps. The arm does not move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last 10 s: %1 packets, %2 late, %3 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Since connecting: %1 packets, %2 late, %3 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A packet counts as late when it arrives more than half a period after its expected time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · %1 late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FREEDRIVE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm can be moved by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ModeWords</name>
    <message>
        <source>No controller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s controller is not running. Restart the control box.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm disconnected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The controller has no connection to the arm. See the teach pendant for the cause.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confirm safety</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confirm the safety configuration on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Booting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is starting. Wait a few seconds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is powered off. Power on the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is powered on and initializing. Wait a moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Idle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The brakes are engaged. Release the brakes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is being moved by hand with its brakes released. Release the Freedrive button.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Updating firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The joints&apos; firmware is being updated. Do not switch off the power until the update is complete.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No safety stop is active.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reduced safety limits are active.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is outside a safety limit. Use the teach pendant to move the arm back within the limits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A safeguard is open. Close it and, if a reset is configured, press the reset button.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A safety limit was exceeded and power was cut. Check the cause, then restart the safety system.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The safety system found a fault. Check the robot&apos;s log, then restart the safety system.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Validate joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A joint was replaced. Validate the joints on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undefined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The controller does not report its safety mode. Check the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic safeguard stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The automatic mode safeguard is open. Close it, or switch to manual mode.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enabling device stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The enabling device is not held. Hold it in its middle position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pendant enabling stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IMMI emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IMMI safeguard stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The moulding machine&apos;s safeguard is open. Close it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PROFIsafe waiting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is waiting for the PROFIsafe controller. Check the fieldbus and the PROFIsafe parameters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PROFIsafe automatic stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an automatic mode safeguard stop. Clear the request on that controller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PROFIsafe safeguard stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests a safeguard stop. Clear the request on that controller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PROFIsafe emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety API stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program requests a safeguard stop through the safety API. Clear the request in that program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I/O plane stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool crossed a safety plane that is enabled by an input. Move the tool back with the teach pendant, or turn the input off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program stopping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program on the robot is stopping.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program is running on the robot and may move the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program pausing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program is pausing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press “Play” to continue the interrupted motion, or stop the program to discard it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program resuming</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program is resuming, and the arm may move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown robot mode %1. See the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown safety mode %1. See the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown program state %1. See the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The brakes are released. The arm is at standstill.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The controller stopped the arm. Find the cause, wait 5 s, then unlock the protective stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cell&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The emergency stop button of the robot is pressed. Twist it clockwise to release it, then power on the arm and release the brakes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The moulding machine&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an emergency stop. Clear the request on that controller, then power on the arm and release the brakes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The enabling button of the teach pendant is not held. Hold it in its middle position.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OutputGripper</name>
    <message>
        <source>The robot did not confirm the outputs. Another program or the installation may control them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pending…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open requested</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>close requested</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both outputs off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both outputs on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose different outputs for closing and opening.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PanelActions</name>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records the robot data to a file until you stop the recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recording is already running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the recording and completes its file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recording is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause or resume the plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freezes the plots while data and recording continue. Press again to return to the newest samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the plots…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves the visible range as an image, PDF page or table of values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots: last %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the time range of the plots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds a terminal or a register by its number or name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename selected input or output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Renames the input or output in the selected row of the I/O tab.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch selected output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on or off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulse selected output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on for 0.5 s, then off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows only entries that contain the search text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log: show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log: show warnings and errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log: show errors only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selects which log entries are shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the selected entries. If no entry is selected, copies all visible entries.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the log…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the visible entries to a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search plot signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens the list of all signals. To add a signal to a plot, drag it, double-click it or press Return.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New plot page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds an empty page at the end. All pages share the time axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the entire history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows all data in memory and scales each plot automatically.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add note…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a note at the selected cursor if it is visible, otherwise at the end of the plots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the panel to a separate window, e.g. on a second screen, or back to the main window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the panel to this side of the main window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaces the pages of live data with the standard page. Pages with recordings are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows a recording or a table of another program on its own page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes all opened recordings from the plots. The files are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recording is open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compares the displayed recording with the model of its arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the page of a recording first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows or hides the table of values at the cursors and between them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows or hides the spectrum and the XY plot of two signals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to the top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to the bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots: start or stop playback</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves cursor A in real time through the recording or the paused plots. The Layout menu contains other speeds.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlotMenu</name>
    <message>
        <source>Remove lane %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add note here…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show values of %1 at the cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1 to a separate plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warn when %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not warn when %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate of change of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving mean of %1 over 0.5 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Norm of the curves in this plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New plot below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New plot to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low-pass filter of %1 at 10 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filtered %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis limits…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale to curves</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlotPane</name>
    <message>
        <source>%1 (right)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Practice</name>
    <message>
        <source>Waiting for the protective stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is in a protective stop. Press “Recover…” in the header.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlocked. The arm is not running yet: follow the steps on the recovery page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlocked. Take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is running and under your control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No new frame yet. Use “3 points” in the Frames tab.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” meets the requirements.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Z axis of “%1” differs from the base Z axis by %2°. The third point must be on the +Y side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The X axis of “%1” differs from the base Y axis by %2°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was not taught with the arm: the TCP was never at its origin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The waypoint was deleted. Press “Start” to add a new waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has not changed. The arm is %2 away from the waypoint along X.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has moved by %2 and is %3 from the expected position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the tool orientation changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” matches the part again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the arm is not. Touch up the waypoint with the arm at the part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slowed down to %1. Continue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No limit reached yet. The line below the pad will show the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit reached. Now jog back: %1 of %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You reached the limit and moved back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording: %1 s of %2 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording is too short. Record for at least three seconds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recording yet. Press “Record” above the plots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded. Enter the force shown in the plot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not match the recording. Look at the Fz curve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct: the force was %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover from a protective stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach a frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up a waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find the reach limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record and measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press “Start” to simulate a collision that causes a protective stop. Find out what stopped the arm, wait five seconds, unlock the arm and take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach a frame from three points in the Frames tab. Its X axis must point along the base Y+ direction and its Z axis up: record the origin, then a point further along Y+, then a point further along X−.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press “Start” to add a waypoint “part” at the current position of the arm. The part then moves by %1 along the base X+ direction. Jog to the part, select the waypoint and touch it up (U).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog outwards, away from the base, until a limit halves the speed. The line below the pad shows the limit and how to move away from it. Then jog back by %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press “Start” to simulate a hand pressing on the tool from above. Record for at least three seconds, then stop. Read the force Fz in the plots and enter the value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>part</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ProgramText</name>
    <message>
        <source>Maximum distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is %2. The value must be between %3 and %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The group “%1” contains no waypoints. Add waypoints to the group, or select a different group.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” refers to an item that was deleted from the project. Select a different item.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” must come directly after “%2”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” must be inside “%2”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps in “Watch in parallel” cannot move the arm. Move this step out of the section.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This version of Tiller does not support the step “%1”. Update Tiller, or delete the step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program can start only at a top-level step, and not at a branch such as Else. Select a different step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project does not contain this program. Select a different program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a %2. Use “Adapt project to this robot…” first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program with parameters cannot be started directly. Use a “Call program” step in another program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program has no steps. Add steps first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The variable “%1” has a different type elsewhere in the program. Use the same type or a different name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program calls are nested too deeply. Use fewer levels of calls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was taught with a different TCP than the waypoints before it. Set the active TCP, or put the step in a TCP section.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blend radii of this move and the previous move (%1 and %2) exceed the distance of %3 between the two targets. Reduce a blend radius.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The expression is empty. Enter an expression.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An expression must be a single line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a valid variable name. Use letters, digits and underscores, and do not start with a digit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name “%1” is reserved. Use a different name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm comes too close to itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm comes too close to “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm comes too close to the floor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The step failed and ended the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program did not end within %1 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preview was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool and speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Structure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set variable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>True or false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Call program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program “%1” requires %2 comma-separated values, but the step passes %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“Default” must be the last branch of a Switch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Else if</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Else</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program failed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For each pattern cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For each waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input to check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If the input is off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select different outputs for opening and closing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper is not holding an object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exit loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“Exit loop” must be inside a loop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repetitions (0: endless)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This loop may never end and contains no delay. Add a Wait step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A loop can have 1 to %1 positions; this loop has %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for the operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MoveC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Via</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixed to arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move through a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run waypoint actions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MoveJ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MoveL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MoveP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distance is zero. Enter a value for X, Y or Z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The waypoint “%1” moves the gripper. In a program, use the Gripper step and turn off “Run waypoint actions”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Approach distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm cannot reach “%1”. Change the waypoint, or select a different waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set either a waypoint or a pose, not both.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set a waypoint or a pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move until</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Until</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input is on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If not reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select an input.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The input did not turn on within the maximum distance. Check the sensor and its wiring.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No contact was detected within the maximum distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write to the log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulse output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Question</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Questions require robot software 5.6 or newer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URScript</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names that begin with “tiller_” are reserved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each block in the script needs an “end”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set analog output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set register</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Integer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boolean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Register</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Programs can set registers only up to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A Switch must contain at least one Case.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only Case and Default can be placed directly in a Switch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“Try” must be followed directly by “On error”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On timeout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The condition did not become true before the timeout.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for input</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 did not change to the expected state before the timeout.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watch in parallel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A parallel watch must be at the top level of the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1 s: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1 (%2) at %3 s: %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” must be between %2 and %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The TCP of the robot differs from the TCP of the program&apos;s waypoints. Set the active TCP of the project, or use a TCP section.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview the program first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preview found problems. Fix them, then preview the program again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the arm to the start position first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program ended after %1 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1 (%2) failed and ended the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped in step %1 (%2): %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped before the first step: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later steps use the variable “%1” from step %2 (%3). Start at that step or earlier.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later steps depend on step %1 (%2). Start at that step or earlier.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preview does not reach this step. Select a different step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated program does not complete step %1 (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm has left the start position of step %1 (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper may hold a part and would close again (%1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper may have lost a part (%1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 would turn on again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 would have a different value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program would wait in step %1 (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program would fail in step %1 (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An analog output would have a different value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A register would have a different value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The variable “%1” would have a different value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The TCP or the payload would differ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program would run different steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm would end at a different position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✔ Continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>↩ Move back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✖ Unsafe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated, after a stop in this step:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>can continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>can continue after moving back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot continue safely</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop by the operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connection loss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power loss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: the program cannot continue safely. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: the program can continue from step %1 (%2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stop was inside a force section, so the contact cannot be restored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The relative move is only partly complete.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The URScript text was only partly executed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Severity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program cannot continue inside a section or a called program. The next run starts from the beginning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program cannot continue in the middle of this step. The next run starts from the beginning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paused on the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed, acceleration or blend is not a number, or a time is set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, disabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program has no name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the project already has a program &apos;%1&apos;; choose another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is too large for a program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is not text in UTF-8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this line ends a block that was not opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program contains a return</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program has too many statements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the script of the steps does not compile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program is too complex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file contains no statements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file contains %1 functions or parameters, but no statement that calls a function; add the call</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program contains no statements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Installation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In this project, programs begin with the TCP of the tool &apos;%1&apos;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program does not set the TCP. Its waypoints require the TCP %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the TCP applies until the end of the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program does not call this function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>imported as a program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>part of a waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a different model. Adapt the project to the robot first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1 failed and ended the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>step numbers</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The position of the arm is unknown because no robot data arrive. Check the connection to the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is unknown whether the program completed, because robot data were missing at its end. Check the workpiece.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last known step: %1 (%2). %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until the robot has confirmed the new value of “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a whole number. Enter a number without decimals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not True or False. Enter one of these values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A URScript step in this program could move the arm after a change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only numbers and True or False values can be changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program has no variable “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variable “%1”: %2 → %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot did not confirm the new value of “%1”. Check the value in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot does not report its variables. Wait until the connection is restored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recoverability check did not reach step %1 (%2). Check again with the inputs of the run to find out whether the program can continue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This variable is set by URScript text. Only variables of a “Set variable” step can be changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not set. Select or enter a value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has an invalid value. Enter a different value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot contain steps. Move its steps to another section.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program cannot call itself. Select a different program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unexpected character “%1”. Remove this character.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot be part of an expression. Remove this word.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The brackets do not match. Add or remove a bracket.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Message step cannot have this title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the payload is not given as numbers in the permitted range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the target cannot be stored as a waypoint or as the pose of a step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the External Control node runs a script from another computer, which cannot be imported. Remove this node from the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the blocks are nested too deeply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a block extends beyond its node</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the line contains several statements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the block that begins on line %1 has no end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no step corresponds to this statement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program uses output integer register 46 or 47, to which Tiller writes the number of the running step. Use different registers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a disabled node in a section that is imported as URScript text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the condition cannot be used in a step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no step corresponds to a thread, or to a function with parameters or a result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the type or the scope of the variable cannot be determined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Save the program on the teach pendant and copy its .script file to the same folder, or change the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nodes cannot be imported: %1. The script saved by the teach pendant was imported instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Complete the program on the teach pendant first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ended on the robot (teach pendant, another client or halt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a program from another client has taken over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values of a program from another client cannot be changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the statement is nested too deeply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program cannot pause before this step. Select a different step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The move is only partly complete.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ProjectLock</name>
    <message>
        <source>%1 on %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>process %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another program</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>No robot connected. Choose a robot at the top left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not in control. Press “Take control” in the header.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot data are out of date. Wait for new data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is moving. Stop the arm first, then store the position.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RecordingChoice</name>
    <message>
        <source>A file name must not be empty or begin with a period.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A file name cannot contain “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This name is too long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not a condition: “%1”. Examples: actual_TCP_force_2 &gt; 20, robot_mode = 7, actual_digital_input_bits:3 = 1, runtime_state changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no signal “%1”. Vectors have one signal per number, such as actual_q_0.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RecoveryGuide</name>
    <message>
        <source>Safety mode is Normal again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm can be moved. Motions interrupted by the stop do not resume. Press the button again for each motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is ready. Take control to move the arm, or continue on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data from the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for the connection…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I have inspected the arm. No one is touching it, and nothing is trapped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cause of the stop is known and has been removed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Payload and TCP match the mounted tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlocking is available in %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I have inspected the arm and the robot&apos;s log, and I know the cause.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cause has been removed, and no one is within reach of the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No action is needed in Tiller. This state ends when the cause is removed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Replay</name>
    <message>
        <source>REPLAY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history at %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1 s in %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RetracePath</name>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RobotActions</name>
    <message>
        <source>Connect to a robot first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give control back first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program is already running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the simulator, a robot or a project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts the simulated robot and connects to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the connection…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checks the connection between this PC and the robot and suggests fixes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a robot first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops Tiller&apos;s motion, then closes the connection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is powered on or powering on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops programs, engages the brakes and powers the arm off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is powered off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the cause of the stop and the recovery steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The safety system reports no stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resets the safety system after a violation or fault. The arm stays powered off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Available only after a safety violation or fault.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes the popups on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Already in control.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give control back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends the control program on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not in control.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software stop of all motion. Not an emergency stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load program…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads a program on the robot by name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts the loaded program or resumes the paused program. The arm may move immediately.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pauses the running program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the program on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RobotOutputs</name>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analog output %1: %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input int register %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed slider: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: on for %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: off for %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot times pulses only while Tiller is in control. Take control first, or switch the output on and off manually.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot did not end the pulse on %1 because the program on the robot was stopped or paused. Tiller switches the output off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input float register %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input bit register %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot cannot time pulses while a program is running. Stop the program first, or switch the output on and off manually.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RobotServices</name>
    <message>
        <source>%1 failed. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close popups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protective stop unlocked by the operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load program %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program on the robot was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program on the robot could not be stopped. Stop the program on the teach pendant. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot was switched to Local control: the motion was stopped and control was given back. Switch the robot to Remote control on the teach pendant, then take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlock protective stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot sends no data, so a stop may not reach the robot. Press the emergency stop if the arm must stop.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RobotTooling</name>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP and payload can be set only at standstill. Wait until the arm has stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP set on the robot: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Payload set on the robot: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SampleProjects</name>
    <message>
        <source>Pick and place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picks a part from a feeder and places it in one of six tray cells. The cells are defined in the frame of the tray and move with it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gluing along a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Applies a bead around a lid with rounded corners in slow, straight moves. Blends keep the nozzle moving through the corners.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A probe touches a part from above and from four sides. Each touch starts at an approach waypoint with the tool tilted.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SceneActions</name>
    <message>
        <source>Default view (perspective)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the arm diagonally from the front, slightly from above, and fits everything in the view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base X to the right, Z up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base Y to the right, Z up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base X to the right, Y up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit everything in the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view without changing the viewing direction.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SessionRecording</name>
    <message>
        <source>Cannot record: connect to a robot first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n rows to %1</source>
        <translation>
            <numerusform>Recorded %n row to %1</numerusform>
            <numerusform>Recorded %n rows to %1</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording continues without notes. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not recorded, because the robot does not accept a second connection: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>The recording has gaps: %n packets are missing.</source>
        <translation>
            <numerusform>The recording has gaps: %n packet is missing.</numerusform>
            <numerusform>The recording has gaps: %n packets are missing.</numerusform>
        </translation>
    </message>
    <message>
        <source>The current recording does not contain %1. Start a new recording to record displayed signals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. These signals are not recorded: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for the trigger %1 to record to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trigger has not occurred. No file was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n files; the last one is %1</source>
        <translation>
            <numerusform>Recorded %n file; the last one is %1</numerusform>
            <numerusform>Recorded %n files; the last one is %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SettingsFile</name>
    <message>
        <source>Invalid value for the setting “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is too large for a settings file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is damaged at byte %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file contains no Tiller settings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file was written by a newer version of Tiller. Update Tiller to import the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file contains no version number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The list of settings is missing or too long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a valid setting name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SignalInfo</name>
    <message>
        <source>TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modes and states</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power and temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed and program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Payload and tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP rotation vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP angular speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP acceleration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target TCP position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target TCP rotation vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target TCP speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target TCP angular speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw sensor force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw sensor torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP force, norm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool accelerometer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elbow position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elbow speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint speeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint temperatures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint voltages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target joint positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target joint speeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target joint accelerations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target joint currents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target joint torques</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint control currents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allowed current deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position deviation, ratio to limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collision detection, ratio to limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint modes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analog input 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analog input 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analog output 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analog output 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool analog input 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool analog input 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety status</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot status</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Main voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I/O current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed scaling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control step time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Script line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Payload centre of gravity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freedrive button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Violation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enabling device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output registers, floats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input registers, floats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output registers, integers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input registers, integers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output registers, bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input registers, bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped due to safety</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SpaceMouse</name>
    <message>
        <source>left button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool follows the motion of the cap.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Spectrum</name>
    <message>
        <source>compute a spectrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The range contains fewer than %1 samples. Select a longer range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values are missing in this range. Select a range without gaps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not enough memory. Select a shorter range.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StartProject</name>
    <message>
        <source>The last project no longer exists: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StateLane</name>
    <message>
        <source>Protective stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enabling device released</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brakes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At standstill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Late data</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Enter an IP address, such as 192.168.0.10, or a host name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and this PC is on the same network.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enable the interface on the robot under Settings &gt; Security &gt; Services. A robot that has just started may need another minute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot may be restarting or switching between Local and Remote control. Wait a minute, then connect again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot does not respond. Check the cable and the address.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No more data received. Check the cable. Tiller reconnects automatically; motion does not resume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The response is not valid for this protocol. Check the address and the port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If newer software is available for this robot, update the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s software does not provide this value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program or a fieldbus on the robot uses these registers. Close the other program, or disable the fieldbus in the installation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power on the arm, release the brakes and clear any safety stop first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a target within the reach of the arm and a speed below the speed cap.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm cannot reach this pose. Move the target closer or rotate the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot could not run the program. See the log for the controller&apos;s message.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the file exists and that you have permission to read it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder that you have permission to write to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file was not changed. Open a backup, or repair the file at the reported position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address not found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot not reachable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connection closed by the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timed out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protocol error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not supported by this robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value not available</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Registers in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot not ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outside the limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Invalid value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused by the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program error on the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot read the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot write the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File is damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disk full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Internal error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>button or key released</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointer left the button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>focus lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another window became active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>window closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a dialog or menu opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another button or key pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>input device lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot data arrived too late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot or safety mode changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>control lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>target reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped by a program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contact detected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>target cannot be reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>could not verify that the button or key is still pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>maximum hold time reached; press again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PolyScope X before 10.11 does not accept these commands over the network. Use the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PolyScope X cannot close popups over the network. Use the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monitoring. Take control to move the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control was given back. Take control to move the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The control program on the robot was stopped. Take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The control program was replaced or does not respond. Take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection was lost. Take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your script is running. Tiller regains control when the script ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free some space on the disk, then save or record again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. Turn off “Monitor only” in Settings, or start Tiller without --monitor-only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No current data from the robot. Check the network connection to the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>selection or modifier key changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the window did not respond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured: no data during the stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured: another program is moving the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the PC is going to sleep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot did not receive the stop command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>servo target too far from the previous target</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WaypointClipboard</name>
    <message>
        <source>the value is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is outside the range %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column “%2”: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” must be “J” or “L”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” must be “joints” or “pose”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the project has no frame named “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The text is not a table of waypoints. Copy a waypoint from the list to see the columns, or use the six values of a pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a waypoint colour (none, blue, orange, green, pink, yellow or sky)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WaypointExchange</name>
    <message>
        <source>Line %1: the closing quotation mark is missing.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ActionsDialog</name>
    <message>
        <source>Actions at “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Actions at %n waypoints</source>
        <translation>
            <numerusform>Actions at %n waypoint</numerusform>
            <numerusform>Actions at %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>“Run route (hold)” runs these actions in order at the waypoint while the button is held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These waypoints have different actions. “Apply” replaces them all with the actions below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions in order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the selected action up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the selected action down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Terminal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After this time, the action fails with a message. With 0, the action waits while the button is held, up to one hour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an action after the selected action</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::AnalogRow</name>
    <message>
        <source>4–20 mA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0–10 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 domain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>e.g. bar; empty: no scaling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At 4 mA or 0 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At 20 mA or 10 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2
To rename or scale the signal, right-click it, or press F2 or Shift+F2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ArmKey</name>
    <message>
        <source>Keyboard armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm keyboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While the keyboard is armed, holding an arrow key moves the arm. A border around the window shows that the keyboard is armed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys move along X and Y, PgUp and PgDn along Z; with Alt, they rotate the tool. Hold 1 to 6 and press + or − to move a joint. Space and Esc stop the arm. To disarm the keyboard, click this button or wait 30 s.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::CellPage</name>
    <message>
        <source>Size %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown and checked for collisions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a name for the box or plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No boxes or planes yet.
Move the TCP to a corner of an obstacle and press “Teach corner”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check for collisions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of the box. Press Return to apply the values. Only the box changes; the robot does not move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LX</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LZ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First corner recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the TCP to the opposite corner and press “Teach corner 2”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The corners must differ by at least 1 mm along X, Y and Z. Move the TCP to the opposite corner of the box.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the safety distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach corner 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2 in %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length along X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length along Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length along Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point on the plane, X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point on the plane, Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point on the plane, Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal X, towards the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal Y, towards the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal Z, towards the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When off, the box or plane is neither shown nor checked for collisions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal plane in the base frame that the arm must stay above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Floor height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jogging stops at this distance from objects in the cell and between parts of the arm. Moves that would bring the arm closer are refused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the floor to the TCP height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach a box corner at the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a plane through the TCP, perpendicular to the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a box numerically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a plane through the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a plane numerically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the box or plane to the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename box or plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate box or plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete box or plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resize “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The normal must not be zero. Enter at least one nonzero component.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn on the collision check of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn off the collision check of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn collision check on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cell already contains “%1”. Choose a different name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ChecklistItem</name>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not done yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonBand</name>
    <message>
        <source>Comparison with the arm model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare this recording with the arm model using different limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel the comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place cursor A where the arm and the model diverge</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonDialog</name>
    <message>
        <source>Compare with the arm model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated arm follows the recorded joint targets, and its motion is compared with the recorded motion. The model includes neither contact nor friction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals with a limit of 0 are not compared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum duration</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::CurveDialog</name>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displayed value = value × scale + offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name and unit cannot contain = [ ].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a number other than 0 as the scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a number as the offset.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::DecimalSpinBox</name>
    <message>
        <source>“%1” is out of range (%2 to %3). The value is still %4.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::DeviceTrainer</name>
    <message>
        <source>Enable motion (until Tiller is closed)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction in which the arm would move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold-to-run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● held (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>○ not held: hold the %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none (neutral)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the keyboard armed (Ctrl+J): arrow keys for X and Y; PgUp and PgDn for Z; Alt with these keys for rotation; 1 to 6 with + and − for joints; Home for the home position; End to align; Backspace to move back; F for Freedrive; Ctrl for slower; Shift for faster. Space and Esc stop the arm.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::EmptyState</name>
    <message>
        <source>Nothing found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing found with these filters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing found for “%1”.
Clear the search to see everything.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::FirstSteps</name>
    <message>
        <source>Power on (header)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release brakes (header)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take control and hold a jog button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach here (T)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog away and hold “Go to” (G)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record (above the plots)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::FirstStepsCard</name>
    <message>
        <source>First steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The list will not appear again. Use the command “First steps” to reopen it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First steps · %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::FrameDetails</name>
    <message>
        <source>Selected frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not used by any waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>used by %n waypoints</source>
        <translation>
            <numerusform>used by %n waypoint</numerusform>
            <numerusform>used by %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the base frame. Press Return to apply the values. Only the frame changes; the robot does not move.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::FrameEditing</name>
    <message>
        <source>No waypoints moved with the frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints moved with the frame.</source>
        <translation>
            <numerusform>%n waypoint moved with the frame.</numerusform>
            <numerusform>%n waypoints moved with the frame.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Waypoints out of reach: %n.</source>
        <translation>
            <numerusform>Waypoints out of reach: %n.</numerusform>
            <numerusform>Waypoints out of reach: %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frame moves by %1 (%2, base frame).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No waypoint uses this frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints move with the frame.</source>
        <translation>
            <numerusform>%n waypoint moves with the frame.</numerusform>
            <numerusform>%n waypoints move with the frame.</numerusform>
        </translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touched up “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints use this frame. They keep their positions and are converted to Base.</source>
        <translation>
            <numerusform>%n waypoint uses this frame. It keeps its position and is converted to Base.</numerusform>
            <numerusform>%n waypoints use this frame. They keep their positions and are converted to Base.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pose of “%1” was changed. %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::FrameModel</name>
    <message>
        <source>Enter a name for the frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin in Base, X Y Z, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation, rad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation vector in Base, radians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll, pitch and yaw in Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoints that move with the frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance from the TCP, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is a built-in frame. Choose a different name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A frame named “%1” already exists. Choose a different name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::FrameTable</name>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::FrameTeacher</name>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame from three points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On +X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Towards +Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record the origin at the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record the point on +X at the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record the point towards +Y at the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the point again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The point on +X is only %1 from the origin. Record it again at least %2 away. A larger distance gives more accurate axes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The third point is only %1 from the origin. Record the point again at least %2 away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The three points are collinear: the third point is only %1 from the X axis. Record the point again at least %2 towards +Y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready: the point on +X is %1 from the origin, and the third point is %2 from the X axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog the tip to the origin of the frame and record the point (P).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now jog to a point on +X: %1 from the origin (minimum %2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now jog towards +Y: %1 from the X axis (minimum %2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record  P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::FramesTab</name>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach a frame from the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach a frame from three points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up the frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More frame commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No frames yet.
Jog the tip to a corner of the tray or table. Press “From TCP”, or press “3 points” to record the origin, +X and +Y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create a frame at the TCP with the axes of the tool (Shift+T)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create a frame from its origin, a point on +X and a point towards +Y (Ctrl+Shift+T)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the selected frame to the TCP (Shift+U)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a frame to touch up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach frame from the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach frame from three points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record the next point of the frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create frame from points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up frame from the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up frame from three points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog in this frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up “%1” from three points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New frame from three points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit frame values</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::GoThroughBar</name>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n waypoint</numerusform>
            <numerusform>%n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>Loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the route</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run route (hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run route, hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous waypoint, hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves to the previous waypoint while the button is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next waypoint, hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves to the next waypoint while the button is held, then stops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Route waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After the last waypoint, continues with the first waypoint while the button is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next: %1 of %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done. The next press starts at the first waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves from waypoint to waypoint while the button is held, no faster than the jog speed, and runs the actions of each waypoint. Release to pause; the next press continues to the next waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selects the waypoints to run, in list order</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::GoToButton</name>
    <message>
        <source>Go to (hold)  G</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to, hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the arm to the selected waypoint while the button or G is held, no faster than the jog speed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::GripperPanel</name>
    <message>
        <source>Gripper state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripped object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Activate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Activate the gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper: move to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robotiq %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One output: on = closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two outputs: open, close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finger speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finger force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suggested action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target opening of the fingers, 0 to %1. “Move” starts the motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the next motion. 0 % is about %1, 100 % about %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force of the next grip. 0 % is about %1, 100 % about %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper set to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (speed %2, force %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Please wait…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the mounted gripper. The choice is stored for this robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>activating…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pending…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>active, at standstill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown while moving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper is not available with this port offset. Use a smaller port offset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Activating: the fingers open and close once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Activate the gripper first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fingers open and close once and drop any gripped object. Keep your fingers clear of the gripper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens the gripper and releases the object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes the gripper. Keep your fingers clear of the gripper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper did not execute the command. Check that no other program controls the gripper, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper: stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the fingers to the target opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closed by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to a robot first. Tiller stores the gripper selection for each robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>external grip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>internal grip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping the arm does not open the gripper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the fingers to the target opening.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed or force is out of range. Enter a value from 0 to 100 %.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::HeaderBar</name>
    <message>
        <source>ROBOT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ROBOT MODE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SAFETY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CONTROL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LINK</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LAST STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured from the stop command to standstill. Cause: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No stop measured yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Speed cap raised to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm may move faster than %1. Lower the speed cap in Settings. The cap is reset when Tiller is closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot stopped sending data while the arm was moving, so the stop could not be measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LAST STOP · no key check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MONITOR ONLY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cause: %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program was stopped on the robot, so the stop could not be measured.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::HoldRules</name>
    <message>
        <source>The window was not active. Press again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click in the window first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A dialog or a menu is open. Close it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The display server does not respond, so Tiller cannot detect the release of a button or key. Release the button or key, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::HoldToRunButton</name>
    <message>
        <source>hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold this button. The arm moves only while the button is held.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ImportReport</name>
    <message>
        <source>Steps: %1. Kept as URScript text: %2. Not imported: %3. New waypoints: %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Imported program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Node or statement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import report for “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::IncidentWatch</name>
    <message>
        <source>protective stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>safety violation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The incident (%1) could not be recorded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Incident recorded: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording %2 starts %1 s before the stop. Double-click this entry to open the recording.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::IoChannel</name>
    <message>
        <source>no data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pending…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, outdated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
The output cannot be switched while the robot is not sending data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Click to switch the output %1. Press P to pulse it. Right-click to pulse or rename it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Right-click or press F2 to rename the input.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::IoPages</name>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I/O page</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::IoTab</name>
    <message>
        <source>Inputs and outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search by terminal or name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Configurable outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Configurable inputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool inputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>General purpose registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the Tab key to select a row on the I/O tab first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot did not confirm %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay is active. Press “Back to live” first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be pulsed now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>controlled by another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program or the installation may control the output. Check both, then switch the output again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::JogColumn</name>
    <message>
        <source>Jog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose or joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves all joints to the home position while the button is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aligns the tool with the nearest axis of the selected frame while the button is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Retraces the last motion while the button is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>aligned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last stop: %1, standstill after %2 ms, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the arm by hand while this button is held: %1. Right-click to select axes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freedrive, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freedrive…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check payload before Freedrive (resets on reconnect)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>release and press again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends in %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold to move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last stop: not measured (data lost)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press for one step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last stop: %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::JogKey</name>
    <message>
        <source>%1 left in this direction</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::JogPad</name>
    <message>
        <source>Jog buttons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::JogSelectors</name>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves while the button is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View axes: X right, Y away from you, Z up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Requires the 3D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No frame taught yet. Teach a frame on the Frames tab.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves by %1 per press.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>≤ %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves slowly while the button is held, until the contact force reaches %1 N. Click again to select a different step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves by %1 per press. Click again to select a different step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · rotation %2 · joints %3 · Ctrl × 0.1, Shift × 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other step…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Until contact, %1 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other contact force…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other speed…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP speed in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact force that ends the motion, in N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotates while the button is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press. Click again to select a different angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other angle…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The step continues after the button is released. Space, Esc and STOP end the step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the button until the step is complete.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::JointRow</name>
    <message>
        <source>%1 minus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 plus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::JointRows</name>
    <message>
        <source>Joints</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::KeyboardJog</name>
    <message>
        <source>Keyboard jogging is armed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::LimiterLine</name>
    <message>
        <source>Limiter</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::LimitsDialog</name>
    <message>
        <source>Limits of the value axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, minimum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, maximum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: enter two numbers. The minimum must be less than the maximum.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::LogModel</name>
    <message>
        <source>Info</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⬣ Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Severity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the recording of this incident at the time of the stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the recording at this time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · Origin: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times between %2 and %3 · Origin: %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(×%1, last at %2) %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::LogTab</name>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum severity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter the log by text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected entries, or all visible entries (Ctrl+C)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the visible entries to a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Details of the selected entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text file (*.txt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log written to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the recording of the selected entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::MetadataDialog</name>
    <message>
        <source>Ask before each recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller stores the fields with a value in each recording. The names and values are kept for the next recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value “%1” has no name. Enter a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name “%1” is not valid. Use letters, digits, spaces and _ - . (at most 60).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller stores “%1” itself. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name “%1” occurs twice. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value of “%1” must be one line of at most %2 characters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove fields: at most %1 fields are possible.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::MoveWords</name>
    <message>
        <source>%1 collides with %2 after %3 of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The move enters the wrist singularity after %1 of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The move slows down near the wrist singularity at %1 of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The move enters the elbow singularity after %1 of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The move slows down near the elbow singularity at %1 of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The move enters the shoulder singularity after %1 of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The move slows down near the shoulder singularity at %1 of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A joint would have to jump after %1 of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 exceeds its limit after %2 of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The move leaves the reach of the arm after %1 of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forearm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is in contact with %2, and the move reduces the distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is only %2 from %3, and the move reduces the distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 comes within %2 of %3 after %4 of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The position of “%1” is unknown because its frame is not in the project. Enter its position, turn off its collision check, or delete it on the Cell page</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notice action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second notice action</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::OpenTableDialog</name>
    <message>
        <source>Open table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller cannot determine the times of the rows in %1. Select how to read the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No time column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Column separator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Semicolon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decimal separator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Column names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detect automatically</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PartModel</name>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PartPage</name>
    <message>
        <source>More</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PathControls</name>
    <message numerus="yes">
        <source>%n waypoints exported as a path to %1</source>
        <translation>
            <numerusform>%n waypoint exported as a path to %1</numerusform>
            <numerusform>%n waypoints exported as a path to %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Path tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export path as CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import path from CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path recorded so far is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop recording path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simplifying the path…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops recording and stores the path as waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records the path of the arm during Freedrive or jogging and stores it as waypoints. Press again to stop. Recording does not move the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path was not exported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>○ Path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path of the arm is being recorded. To stop recording, press “● REC” or select “Stop recording path” in the menu.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path recording stopped because the maximum duration of ten minutes was reached.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path recording stopped because the robot stopped sending data or was restarted.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PathRecorder</name>
    <message numerus="yes">
        <source>%n packets were lost.</source>
        <translation>
            <numerusform>%n packet was lost.</numerusform>
            <numerusform>%n packets were lost.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 has no column “%2”. The columns “timestamp” and “actual_q_0” to “actual_q_5” are required.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import refused because another path is being recorded or processed. Stop the recording, or wait, and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path could not be imported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>path %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm did not move. No path was stored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”: %2 s, %3 waypoints. Maximum deviation from the recording: %4 and %5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is out of reach. Touch up or delete the waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PatternDialog</name>
    <message>
        <source>pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern from three corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End of the first row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start of the last row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As taught</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cells per row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance from one layer to the next, measured opposite to the tool direction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Row by row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zigzag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a name for the pattern.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach the corners first, then select a waypoint for each corner.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The layer height must not be 0. Enter a layer height.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pattern has %1 cells; the maximum is %2. Enter fewer cells per row, rows or layers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All cells are excluded. Click a cell to include it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The three corners are on a straight line. Select a different waypoint for one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two corners are at the same position. Select a different waypoint for one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n waypoint</numerusform>
            <numerusform>%n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, all within reach.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1, %n out of reach and marked.</source>
        <translation>
            <numerusform>%1, %n out of reach and marked.</numerusform>
            <numerusform>%1, %n out of reach and marked.</numerusform>
        </translation>
    </message>
    <message>
        <source>A pattern with this name already exists. Choose a different name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The layer height is not a number or is out of range. Enter a different layer height.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PatternGrid</name>
    <message>
        <source>Pattern cells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a cell to exclude or include it. The first cell is at the lower left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Row %1, column %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PayloadEstimator</name>
    <message>
        <source>Next pose (hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the payload in several poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next pose, hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotates the wrist to the next pose while the button is held, no faster than the jog speed. Make sure that the tool has space to rotate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel payload measurement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and record the pose again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is not sending force data. Enter the mass and the centre of gravity instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kg, centre of gravity at %2 from the flange. The poses agree within %3 and %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 The accuracy is low: pose %2 deviates most. Remove this pose and record another pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The load of %1 kg is too light to measure the centre of gravity. Enter the payload manually.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for standstill, keep the tool free of contact, and record the pose. Then rotate the wrist by jogging or with “Next pose (hold)”, and record three more poses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove least accurate pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove last pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose %1  %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool rotated in a different direction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Rotate the wrist in a different direction and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>Rotate the wrist in another direction and record the pose. Poses still needed: %n.</numerusform>
            <numerusform>Rotate the wrist in another direction and record the pose. Poses still needed: %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::PayloadPage</name>
    <message>
        <source>Mass kg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CX %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CY %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CZ %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a name for the payload.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing mounted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robotiq 2F-85, empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robotiq 2F-140, empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Payloads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CX</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CZ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Payload mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of gravity X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of gravity Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of gravity Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Return to apply the value to the project. The robot&apos;s payload does not change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use this payload and set it on the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the payload with the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verify</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verify the payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store the active payload of the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter new payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add preset: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the payload “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the payload “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the payload to set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the payload “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the payload “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and press “Verify” again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The payload cannot be verified because the robot is not sending force data. Wait for data, or reconnect.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With a payload of %1 kg, the arm measures a force of %2 and a torque of %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The payload is correct. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The payload is correct</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The load is about %1 kg heavier than the configured payload.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The load is about %1 kg lighter than the configured payload.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The centre of gravity differs, or something is touching the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 Measure the payload, or select a different payload. Zeroing the force sensor hides a wrong payload until the tool rotates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The payload is wrong. %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The payload is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; the robot uses %2 kg, centre of gravity %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s payload differs from “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the robot: %1 kg, centre of gravity %2. In the project: %3 kg, centre of gravity %4. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No payloads yet.
Press “Measure…” to measure the payload with the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A payload named “%1” already exists. Choose a different name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PlotAnalysis</name>
    <message>
        <source>Spectrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>XY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysis type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X-axis signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a signal to the plots first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples are missing in this range. Place cursors A and B around a range without gaps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amplitude of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n sample</numerusform>
            <numerusform>%n samples</numerusform>
        </translation>
    </message>
    <message>
        <source>This range is too long to combine signals from different recordings. Place cursors A and B around a shorter range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the recording: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Hann window of %1 samples · resolution %2 Hz · mean of %n segment(s) · %3 to %4 s</source>
        <translation>
            <numerusform>Hann window of %1 samples · resolution %2 Hz · mean of %n segment · %3 to %4 s</numerusform>
            <numerusform>Hann window of %1 samples · resolution %2 Hz · mean of %n segments · %3 to %4 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) shown, 1 of every %1</source>
        <translation>
            <numerusform>%n sample shown, 1 of every %1</numerusform>
            <numerusform>%n samples shown, 1 of every %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 to %3 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PlotComparison</name>
    <message>
        <source>Arm and model diverge: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing the arm with its model: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not compared with the arm model: the recording does not specify the robot model. Press “Compare…” and select the model.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PlotDock</name>
    <message>
        <source>5 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>30 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>30 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range, then export again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause the plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the visible range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the visible range as an image (e.g. PNG) or as values (e.g. CSV)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freeze the plots. Reception and recording of data continue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● REC %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported the visible range to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot export: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG image (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SVG image (*.svg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time range of the plots. The mouse wheel zooms the time axis; over the value axis, or with Ctrl, it zooms the values. Double-click the value axis to scale automatically.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero the displayed force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot zero the force: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the force as measured by the robot. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Subtract the current force in the plots. The robot, recordings and exported values are not changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows, signals, folder and file name of the next recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One row per packet</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>One row every %n packet(s)</source>
        <translation>
            <numerusform>One row every %n packet</numerusform>
            <numerusform>One row every %n packets</numerusform>
        </translation>
    </message>
    <message>
        <source>All signals…</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s)…</source>
        <translation>
            <numerusform>%n signal…</numerusform>
            <numerusform>%n signals…</numerusform>
        </translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What happened at this time?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plots were copied to the clipboard as an image.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History %1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy plots as image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save layout…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open layout…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened the recording %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save plot layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plot layouts (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open plot layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot signals. Drag a signal to a plot, or to the edge of a plot to create a new plot. Double-click a signal to add it to a plot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values at cursors A and B, and statistics of the range between the cursors: minimum, maximum, mean, RMS, standard deviation, slope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plot pages and layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout ▾</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the visible range…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative to the newest sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The maximum number of plot pages has been reached. Remove a page first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV: text, for pandas and spreadsheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MCAP: every field, the log and the project, for ROS tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported the range between cursors A and B to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cursor A to cursor B (*%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page shows several recordings, or a recording and live signals. Show only one of them on the page, then export again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live signals can be exported only as .csv. For other formats, record the signals first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The range contains too many values to export from this window. Export a shorter range, or run “tiller-cli export”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (%1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record to a file (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record robot data to a file (%1). Use the arrow button to select the signals and the folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All %1 pages show recordings. Remove a page or close the recordings first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cursor readout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused · %1 s behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Return to the newest samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>controller time %1 to %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file type is not supported. Use the suffix .png, .svg or .pdf for an image, or .csv for values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click in the plots to place cursors A and B; drag them, or use the A, B and arrow keys. Click a legend entry to hide its curve; Ctrl+click the entry to show its values at the cursors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder: %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at controller time %2 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file does not contain a plot layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 · %2/s · %3 free · %n packet(s) lost</source>
        <translation>
            <numerusform>%1 · %2/s · %3 free · %n packet lost</numerusform>
            <numerusform>%1 · %2/s · %3 free · %n packets lost</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened the recording %1, but part of it could not be read. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the recording %1 could not be read. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The range contains samples from different robots. Use cursors A and B to select a range with data from one robot, then export again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image %1 could not be created. Choose a different image format.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plots do not contain data from %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● Waiting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for the trigger. Files so far: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>Metadata (%n field)…</numerusform>
            <numerusform>Metadata (%n fields)…</numerusform>
        </translation>
    </message>
    <message>
        <source>Trigger…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trigger %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File name: %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop playback</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot play: the page has no samples. Connect to a robot or open a recording first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PlotMarks</name>
    <message>
        <source>%1 is above %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is below %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PlotPages</name>
    <message>
        <source>Plot pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click to rename</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PlotValues</name>
    <message>
        <source>Values at the cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B − A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Std</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δt 0 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δt %1 s · 1/Δt %2 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click in the plots to place cursor A, then cursor B. The table then shows statistics of the range between the cursors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · calculating: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Statistics are incomplete: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slope per second</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PlotView</name>
    <message>
        <source> min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A–B Δt %1 s · Δ%2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 s · %3 %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (zeroed)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixed scale · double-click the axis to scale automatically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zeroed (offset %1 %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A and B place the cursors. Left and Right move the active cursor. Up and Down select the signal at the cursors. H hides the curve of this signal; Ctrl+Delete removes it. Plus and Minus change the time range, or the value scale with Ctrl; Ctrl+0 scales automatically. N adds a note, F shows all data, and End returns to the newest samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A–B Δt %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop signals here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No samples yet. Connect to a robot.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PoseEditor</name>
    <message>
        <source>%1 X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation about X (RX)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation about Y (RY)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation about Z (RZ)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PoseView</name>
    <message>
        <source>TCP at the flange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in %1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP pose in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ₀: displacement from the zero position. Click to show the displacement since the start of the last motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ: displacement since the start of the last motion. Click to set the displacement to zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP in the flange frame: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PositionsPage</name>
    <message>
        <source>Joints °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a name for the position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No positions yet.
Jog the arm to a position and press “Set home here” or “Add position”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safe height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Press Return to apply the values. Only the stored position changes; the robot does not move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height in the base frame. Above this height, the cell is free of obstacles, and the TCP may move sideways.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the safe height to the current TCP height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set home here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store the current position of the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use as home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the selected position as home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to default home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set “%1” to the current position of the arm?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Home button will then move the arm to this position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the position “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a position to touch up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest joint change: %1 %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use “%1” as home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a position to use as home.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the safe height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the safe height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Home button moves the arm to the default home position: upright, without self-collision.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: target of the Home button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2 %3 from the current position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A position named “%1” already exists. Choose a different name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::Practice</name>
    <message>
        <source>Start the simulated robot in the Robot menu first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The safety system has stopped the arm. Use “Recover…” first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done. Press “Start” to repeat the task.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press “Start”.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PracticeCard</name>
    <message>
        <source>Practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force Fz in newtons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a value and press Return</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fz [N]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice · %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts or restarts the task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continues with the next task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Available after the check above has passed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PreflightPage</name>
    <message>
        <source>Good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before you connect to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep everyone out of reach of the arm.
Keep the emergency stop within reach: STOP in this window is a software stop.
Start slowly: the initial speed is %1.
Watch the arm, not the screen, while you hold a button.
Release the button to stop the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problems found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready, with warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything is ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If you connect anyway, the window shows the available data. The red items above may prevent Tiller from taking control or may stop a running motion.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ProgramModel</name>
    <message>
        <source>%1 × %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, disabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, breakpoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ProgramTab</name>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add steps, or edit the selected step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename program…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export script…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disable or enable steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move steps up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move steps down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move steps into the section above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move steps out of the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag steps into the program, or double-click them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ Step %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program can run. Press “Preview” to simulate it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disable steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enable steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulating…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: the program takes %1 s. No problems found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>⚠ Simulated: %n problem(s) found. %1</source>
        <translation>
            <numerusform>⚠ Simulated: %n problem found. %1</numerusform>
            <numerusform>⚠ Simulated: %n problems found. %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Export script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URScript (*.script)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running step %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused before step %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pausing after step %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: two cycles of the endless program take %1 s. No problems found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check recoverability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In simulation, the program can continue after a stop in %1 of %2 steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add or remove breakpoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ The program cannot pause before this step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New breakpoints take effect at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program is running, so it cannot be deleted. Stop the program first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused on the robot in step %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program “%1” deleted. Ctrl+Z restores it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import program…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot programs (*.script *.urp *.urpx);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Imported “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ The import failed. The project is unchanged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking recoverability…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ Correct the problems in the program first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outputs were changed after the stop, so the program cannot continue. Run the program from the beginning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program was changed after the stop, so it cannot continue. Run the program from the beginning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) changed because the project changed. Press “Preview” to simulate the program.</source>
        <translation>
            <numerusform>%n step changed because the project changed. Press “Preview” to simulate the program.</numerusform>
            <numerusform>%n steps changed because the project changed. Press “Preview” to simulate the program.</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused before step %1 (%2) because of the maximum hold time. Hold “Continue (hold)” to continue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running step %1 (%2). Joint moves are slow because the preview did not run the whole program from this position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not run: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ProjectDocument</name>
    <message>
        <source>Delete “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Delete %n waypoints</source>
        <translation>
            <numerusform>Delete %n waypoint</numerusform>
            <numerusform>Delete %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>Change order</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFiles</name>
    <message>
        <source>The damaged project file was kept as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project could not be saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Update Tiller to open the file. The file was not changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller projects (*.tiller)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project could not be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Readable waypoints: %2, unreadable: %3. The damaged file is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Open %n waypoints</source>
        <translation>
            <numerusform>Open %n waypoint</numerusform>
            <numerusform>Open %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened a copy of “%1”. Save the copy to a file to keep changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is a copy with unsaved changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes are saved to %1 again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The other window closed %1. This window saves changes again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is open in another window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened by %1. Changes in this window are not saved to the file until you take over the project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as a copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another window or program has changed %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reloaded %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project in this window is now %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved work can be recovered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was changed on %2 and not saved to a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask again next time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has unsaved changes. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has unsaved changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“Keep both” saves the project of this window to a second file. “Reload” shows the new content. Tiller then offers to restore the unsaved changes at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unreadable boxes and planes of the cell: %1. Collisions with these objects are not prevented.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unsaved work in “%1” will be deleted. This cannot be undone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project could not be taken over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 already exists. Choose a different name for the new project.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFit</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
    <message>
        <source>TCP of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project was taught with a %1, but a %2 is connected. The same joint positions lead to different poses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project uses the TCP “%1”. The active TCP of the robot differs by %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project matches the connected robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is connected. Connect the robot that belongs to this project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP differs from the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the robot&apos;s TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same joint positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of reach: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removed because they are out of reach: %1. Press Ctrl+Z to restore them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some positions are out of reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot model is not known yet. Wait until the robot reports the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Project for a different robot model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“Keep poses” recalculates the joint positions; the tool reaches the same poses. “Keep joints” keeps the arm configuration; the tool reaches different poses. Until you decide, moves to positions in the project are blocked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the robot&apos;s TCP, the flange moves to the same poses as taught, but the TCP does not. Until you decide, moves to positions in the project are blocked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves to positions in this project are blocked</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ProjectStore</name>
    <message>
        <source>Project not saved to a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disk full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — not saved: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — saving…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file is selected for the project. Save the project to a file first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — a copy, not saved to a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — open in another window; changes here are not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — changed by another program; changes here are not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — new</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is open in another window (%2). Close the project in that window, or save under a different name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was changed by another program. Reload the project, or save it under a different name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::RangeStatisticsCache</name>
    <message>
        <source>The range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::RecordingsDialog</name>
    <message>
        <source>Recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search name, date, metadata and notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This folder contains no recordings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n recording(s)</source>
        <translation>
            <numerusform>%1 of %n recording</numerusform>
            <numerusform>%1 of %n recordings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reading %n file(s)…</source>
        <translation>
            <numerusform>reading %n file…</numerusform>
            <numerusform>reading %n files…</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder with recordings</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::RecoveryPage</name>
    <message>
        <source>Recovery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped at X %1, Y %2, Z %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suspected joint: %1 (largest deviation from its target current).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (%1 s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick the items that you have checked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command sent; waiting for the robot…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for data from the robot…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::RegisterPanel</name>
    <message>
        <source>General purpose registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Int %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Int</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input register type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input register number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input register value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ReplayBand</name>
    <message>
        <source>Replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the current state of the robot. The recording stays open in the plots.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::RobotPopup</name>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Popup on the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller could not close the popup. Close the popup on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data from the robot. Close the popup on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n more popup(s) on the robot.</source>
        <translation>
            <numerusform>%n more popup on the robot.</numerusform>
            <numerusform>%n more popups on the robot.</numerusform>
        </translation>
    </message>
    <message>
        <source>A waiting program continues when the popup is closed: keep clear of the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the popup on the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide the popup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the popup first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The popup is being closed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::RobotSession</name>
    <message>
        <source>Stopped: %1 (%2 ms, %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connecting to %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disconnected from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety mode is Normal again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program error on line %1, column %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Popup on the robot: %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected to a robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for data from %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connecting to %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically; motion does not resume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking control was cancelled by a stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program on the robot is waiting for a response on the teach pendant: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. STOP still works.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“Monitor only” is off. Commands to the robot are enabled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: refused. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control was lost: the control connection did not respond for 0.5 s or was closed. STOP, Space and Esc still stop the robot. Take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>The robot is sending too many messages. %n messages were not shown.</source>
        <translation>
            <numerusform>The robot is sending too many messages. %n message was not shown.</numerusform>
            <numerusform>The robot is sending too many messages. %n messages were not shown.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move refused: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves are refused. %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data from the robot: the arm may be moving. Reconnecting automatically.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program is running. Wait until the program ends, or stop the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping the other client&apos;s program to take control.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program on the robot is paused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot mode: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped: %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not stopped: a program is still running (%1). Press STOP again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not stopped: the arm is still moving (%1). Press STOP again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot at %1 is a %2 now. It was a %3 before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program from another client has replaced the running program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot. Taking control ends that program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot, and control was lost. Taking control again ends that program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program from another client is running on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>while moving to point %1 of %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program from the other client has ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program started while Tiller was not connected, at most %1 s before this entry.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::RobotiqLink</name>
    <message>
        <source>Connecting to the gripper…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper does not send any values. Power on the arm. If the problem persists, check the gripper cable at the wrist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper responds again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper was not activated. Check that nothing blocks its fingers, then press “Activate” again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper holds an object (%1 open).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper lost the object.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper: activate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 failed. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gripper service responds at %1:%2. Install Robotiq&apos;s URCap on the robot and select the gripper in the robot&apos;s installation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper is not responding. Check the cable at the wrist and the gripper settings on the Installation tab of the teach pendant. If the problem persists, restart the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper did not accept the command. Activate the gripper. If it is already active, check its settings on the Installation tab of the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper is activating; the command runs afterwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper received a motion command before it was active. Press “Activate”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper is too hot. Let it cool down, then press “Activate”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper received no command for one second. Check its cable at the wrist, then press “Activate”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The supply voltage of the gripper is too low. Set the tool voltage to 24 V, then press “Activate”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The automatic release of the gripper is in progress. Wait until it is complete, then press “Activate”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The automatic release of the gripper is complete. Press “Activate”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper has an internal fault. Press “Activate”. If the fault returns, contact Robotiq.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Activation failed. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper draws too much current. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper reports fault %1. Press “Activate”. If the fault returns, see the gripper manual.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot closed the connection to the gripper and may be restarting. Tiller reconnects automatically; the gripper continues to hold its object.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::RouteRunner</name>
    <message>
        <source>The route has no waypoints. Teach or select waypoints first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A waypoint of the route was deleted from the project. Select the waypoints of the route again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A loop requires at least two waypoints. Select more waypoints, or clear “Loop”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no waypoint before the first waypoint of the route.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::RunBar</name>
    <message>
        <source>Run (hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the program (hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move to start (hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move to the start position (hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program is selected. Create or select a program first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs the program at the programmed speed until it ends or is stopped. The arm also stops when Tiller closes or the connection is lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continues the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pauses the program before its next step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs one step and then pauses the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program has no endless loop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends the program before the next cycle of its endless loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select one step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves all joints to the start position while the button is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue (hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value of “%1” is being changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From step %1 ✕</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts the program at the selected step. Move the arm to the start position first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold “Continue (hold)” to continue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preview did not run %1, so these steps were not checked for collisions and other problems. Test them with “Run (hold)”, or set the inputs and preview the program again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A variable was changed. The moves after this change were not previewed, so they were not checked for collisions and other problems.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs the program while the button is held, no faster than the jog speed. The program ends when you release the button. If the arm is not at the start position of a complete preview, joint moves are slower so that no possible path exceeds the speed limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program starts at step %1. Press to start from the beginning instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program started with a jog speed of %1 and cannot continue at a lower speed. Select this speed again, or stop the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Preview the program with the current inputs, or select a higher jog speed, so that the program can run to the end.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::SceneDock</name>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No joint positions to replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot model unknown</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::SceneKeys</name>
    <message>
        <source>3D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default view (perspective)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the front: base X to the right, Z up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the side: base Y to the right, Z up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from above: base X to the right, Y up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::SceneView</name>
    <message>
        <source>Arm view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ghost “%1” · out of reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ghost “%1” · reachable · largest rotation %2 %3 · %4 s at %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag or use the arrow keys to rotate the view; hold Shift or the right button to pan. Zoom with the wheel or with plus and minus. Double-click or press Home for the default view. The robot does not move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 name hidden: zoom in</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n names hidden: zoom in</source>
        <translation>
            <numerusform>%n name hidden: zoom in</numerusform>
            <numerusform>%n names hidden: zoom in</numerusform>
        </translation>
    </message>
    <message>
        <source>ghost “%1” · reachable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ghost “%1” · %2 · largest rotation %3 %4 · %5 s at %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LIVE ARM</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ghost “%1” · taught with a different robot model</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::SignalStore</name>
    <message>
        <source>compute a signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not part of the same RTDE packets as the other signals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Derived</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. Remove other signals first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording %1 contains no samples. Open a different recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The history memory is too small to show %1. Increase the memory in the “Layout” menu.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be computed completely: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::SignalTree</name>
    <message>
        <source>Search signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New: |F| [N] = norm(…)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Derived signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not sent by this robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a name, an optional unit in brackets, and an expression that uses signals. Drag signals here to insert their names. Functions: norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ and standard functions. Press Return to create the signal.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::SimulationChip</name>
    <message>
        <source>Simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This robot is simulated. No real robot moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::SpeedChip</name>
    <message>
        <source>Speed slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot speed slider, 2 to 100 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SPEED</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::StatusLine</name>
    <message>
        <source>Recording, project and last message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples · %2 · %3 free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::StepForm</name>
    <message>
        <source>Select one step to edit it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(none)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::StepPalette</name>
    <message>
        <source>Steps to add</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::StepTree</name>
    <message>
        <source>Program steps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::StopButton</name>
    <message>
        <source>STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software stop. Not an emergency stop. Power stays on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space and Esc also stop the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to stop the arm. Space and Esc stop the arm only while this window is in control.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space / Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not an e-stop</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::StopPlot</name>
    <message>
        <source>Maximum in the last five seconds: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no data before the stop</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::TcpPage</name>
    <message>
        <source>In use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a name for the TCP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCPs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No TCPs yet.
Press “From robot” to store the active TCP, or “Teach…” to teach a TCP with the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative to the flange. Press Return to apply the value to the project. The robot&apos;s TCP does not change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use this TCP and set it on the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach a TCP with the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store the active TCP of the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach the selected TCP again…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter new TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the TCP “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach the TCP “%1” again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the TCP “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The active TCP of the robot is already stored as “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach “%1” again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach a new TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the TCP to set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the TCP “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the TCP “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, relative to the flange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 from the robot&apos;s TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s TCP differs from “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the robot: %1. In the project: %2. Difference: %3. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set TCP on robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A TCP named “%1” already exists. Choose a different name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::TcpTeacher</name>
    <message>
        <source>Record pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo least accurate pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record pose for the tool orientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool orientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep current orientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation from one pose: tool straight down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation from three poses: along +Z, towards +X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tip at %1. The poses agree within %2 (RMS); pose %3 deviates most, by %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the poses again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool keeps the current orientation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate the tool until it points straight down and its X axis is parallel to the base X axis, then record the pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation recorded. Record another pose to replace the orientation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record the pose at the current position. After that, do not rotate the tool: jog along X, Y and Z only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the tool along its +Z direction, away from the flange, by at least %1, and record the pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now move the tool along its +X direction by at least %1, and record the pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation recorded: %1 along +Z, %2 along +X; maximum flange rotation %3 at pose %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The flange rotated by up to %1 (pose %2). Record the three poses again without rotating the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distance along +Z is only %1. Record the three poses again, at least %2 apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distance along +X is only %1. Record the three poses again, at least %2 apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The three poses are collinear: the third pose is only %1 from the line. Record the three poses again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the three poses again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo last pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poses can be recorded only while the robot sends data. Connect to a robot, or wait for new data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool tilted by at least 30° in a different direction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog the tip to a fixed, sharp point and record the pose. Record four poses in total, each with the tip on the same point and the tool tilted in a different direction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Tilt the tool in a different direction, move the tip to the same point again, and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>Tilt the tool in another direction, move the tip to the same point again, and record the pose. Poses still needed: %n.</numerusform>
            <numerusform>Tilt the tool in another direction, move the tip to the same point again, and record the pose. Poses still needed: %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::ToolsTab</name>
    <message>
        <source>TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP, payload, positions or cell</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::TravelWatch</name>
    <message>
        <source>%1: %2 left until %3 is %4 from %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 left until the %3 joint limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 left until the reach limit or a singularity</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::VariableList</name>
    <message>
        <source>Program variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The variable list changed during editing, so the value was not applied. Enter the value again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::VariableModel</name>
    <message>
        <source>%1 (changing…)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::VectorEditor</name>
    <message>
        <source>%1. Press Return to apply the value. The robot does not move.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ViewCard</name>
    <message>
        <source>Collapse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view is too small to expand this card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expand</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::WaypointDetails</name>
    <message>
        <source>Selected waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoint frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>used in %n steps</source>
        <translation>
            <numerusform>used in %n step</numerusform>
            <numerusform>used in %n steps</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the current pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>joints have priority</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pose has priority</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the waypoint frame. Press Return to apply the values. Only the waypoint changes; the robot does not move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cell of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>corner of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>home position “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run route</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the route controls instead of the values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the values instead of the route controls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP at the flange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference frame of the waypoint. Changing the frame does not move the waypoint. “—” means no frame: the joint positions have priority.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::WaypointDialogs</name>
    <message>
        <source>Select waypoints to change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Change the properties of %n waypoints</source>
        <translation>
            <numerusform>Change the properties of %n waypoint</numerusform>
            <numerusform>Change the properties of %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>Select waypoints to move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the pattern “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create the pattern “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convert the pattern “%1” to waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a waypoint that belongs to a pattern.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the pattern “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a waypoint to see its history.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore an earlier version of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoint files (*.csv *.txt *.json *.tiller);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV file (*.csv);;JSON file (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is too large. The maximum size of a waypoint file is 64 MB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Import %n waypoints</source>
        <translation>
            <numerusform>Import %n waypoint</numerusform>
            <numerusform>Import %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>The project contains no waypoints to export. Teach a waypoint first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints exported to %1</source>
        <translation>
            <numerusform>%n waypoint exported to %1</numerusform>
            <numerusform>%n waypoints exported to %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the waypoints to add actions to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Change the actions at %n waypoints</source>
        <translation>
            <numerusform>Change the actions at %n waypoint</numerusform>
            <numerusform>Change the actions at %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>Teach three waypoints at the corners of the pattern first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The earlier version cannot be restored because its frame was deleted from the project. Select a different version.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>Offset, rotate or mirror %n waypoint</numerusform>
            <numerusform>Offset, rotate or mirror %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 contains no waypoints. Choose a different file.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::WaypointEditing</name>
    <message>
        <source>Duplicate “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n waypoints</source>
        <translation>
            <numerusform>Duplicate %n waypoint</numerusform>
            <numerusform>Duplicate %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clipboard contains no waypoints. Copy waypoints first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Paste %n waypoints</source>
        <translation>
            <numerusform>Paste %n waypoint</numerusform>
            <numerusform>Paste %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::WaypointHistoryDialog</name>
    <message>
        <source>History of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes, newest first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  %2  (%3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore the version before this change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name: “%1” → “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position: moved by %1 (%2, base frame)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints: largest change %2 (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none (joints have priority)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a deleted frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame: %1 → %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move: MoveL → MoveJ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move: MoveJ → MoveL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MoveJ speed: %1 → %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MoveL speed: %1 → %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend: %1 → %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP: taught with a different TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group: “%1” → “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour: %1 → %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note: “%1” → “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions: changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No changes have been recorded for this waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The version before this change is identical to the current version.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes from the version before this change to the current version:</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::WaypointModel</name>
    <message>
        <source>✕ joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of reach. Touch up the waypoint closer to the base.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MoveJ: all joints start and stop together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MoveL: the TCP moves along a straight line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints have priority: the arm returns to the same configuration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pose has priority: the waypoint moves with its frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Within reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a name for the waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change “%1” to MoveJ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change “%1” to MoveL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use joint positions for “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the frame of “%1” to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the blend of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the speed of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name %1, next waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n actions</source>
        <translation>
            <numerusform>%n action</numerusform>
            <numerusform>%n actions</numerusform>
        </translation>
    </message>
    <message>
        <source>✕ model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is out of range. Enter a value from %2 to %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm cannot reach this pose, so “%1” was not changed. Enter a different pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A joint would exceed its limit. Touch up the waypoint with a different arm configuration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frame of the waypoint is not in this project. Choose a different frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The straight line from the current position leaves the reach of the arm. Use MoveJ, or start from a different position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoint %2 is already named “%1”. Choose a different name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has no frame named “%1”. Choose a different frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project was taught with a different robot model. Use “Adapt project to this robot…” first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::WaypointProperties</name>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the selected properties are changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Properties of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Properties of %n waypoints</source>
        <translation>
            <numerusform>Properties of %n waypoint</numerusform>
            <numerusform>Properties of %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MoveJ speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MoveL speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::WaypointSearch</name>
    <message>
        <source>Find waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find waypoints by name, group or note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name, group or note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n found</numerusform>
            <numerusform>%n found</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::WaypointShift</name>
    <message>
        <source>Transformation type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool of each waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset X, Y, Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation axis or mirror normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm cannot reach these waypoints after the move: %1. Choose a different offset, rotation or mirror plane. No waypoint will be moved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n of the moved waypoints will be out of reach. They will be kept and marked.</source>
        <translation>
            <numerusform>%n of the moved waypoints will be out of reach. It will be kept and marked.</numerusform>
            <numerusform>%n of the moved waypoints will be out of reach. They will be kept and marked.</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirrors across the plane through the origin that is perpendicular to the axis. The tool approaches from the mirrored side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All waypoints remain within reach.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>Offset, rotate or mirror %n waypoint</numerusform>
            <numerusform>Offset, rotate or mirror %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>The frame of a selected waypoint is not in the project. Choose a different frame for the waypoint first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::WaypointTable</name>
    <message>
        <source>Waypoints</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::WaypointsTab</name>
    <message>
        <source>Waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach here  T</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up  U</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No waypoints yet.
Jog the arm to a position and press “Teach here” (T).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a waypoint to go to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the current position after the selection (T)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace the selected waypoint with the current position (U)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a waypoint to touch up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The current position is %1 away (%2, base frame). Largest joint change: %3 %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import waypoints…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export waypoints…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group, colour, note, speeds…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset, rotate or mirror…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convert pattern to waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete pattern and its waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import and export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taught “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create or edit pattern…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frame of “%1” is not in this project. Choose a different frame first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a command or keyword</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not available now</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::ConnectDialog</name>
    <message>
        <source>Enter the robot&apos;s address, as shown on the teach pendant under About.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An IP address consists of four numbers from 0 to 255, e.g. 192.168.0.10.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A host name contains only letters, digits, dots and hyphens.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try the simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A simulated UR5e that runs in Tiller. All functions are available without risk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the simulated robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to a robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address or host name of the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Display name of the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recently connected robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before you move a real arm: keep everyone out of its reach, keep the emergency stop within reach, check the payload and the TCP, and start slowly. STOP in this window is not an emergency stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens a project without a robot, to view and edit waypoints and programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes the selected robot from this list (Delete). The robot itself is not affected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts the simulated robot and opens a project with taught waypoints.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::Demonstration</name>
    <message>
        <source>Cannot create the folder %1. Choose a folder that you have permission to write to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>power on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>release the brakes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>teach the first waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog X+ in Base for 50 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>release the jog button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>teach the second waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move to the first waypoint (button held)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>release the “Go to” button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>digital output 0 on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>digital output 0 off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>take the screenshots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot write the screenshots to %1. Check the permissions of the folder and the free disk space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stop recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not completed within %2 s (%3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot reported no reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pressed again        %1 times: the motion had stopped before the button was released</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jogged               </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>release to standstill </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>packets              </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> received, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> late, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> lost
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded             </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> rows, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>files                </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the window has no button “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::DeviceSettings</name>
    <message>
        <source>Jog device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test device…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SpaceMouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 dead zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deflection below which the device does not move the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exponent </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1: linear. Higher values: finer near the centre, faster at full deflection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: dominant axis only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device moves the arm only while the hold-to-run button is held. The selection is not stored: after a restart, no device moves the arm.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::DockStage</name>
    <message>
        <source>No panels are shown. Select a perspective at the lower right, or show a panel from the View menu.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::HelpPage</name>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jogging and keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h2&gt;The manual is not installed on this PC&lt;/h2&gt;&lt;p&gt;The Debian package of Tiller contains the manual. To add the manual to your own build, install the package python3-sphinx:&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;Then build again. You can also read the pages as text in the folder packaging/manual of the source code. The page “Jogging and keys” of this window contains the jogging rules and all shortcuts.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h2&gt;Moving the arm&lt;/h2&gt;&lt;p&gt;The arm moves while you hold a jog button, and stops when you release it. It also stops when&lt;/p&gt;&lt;ul&gt;&lt;li&gt;the pointer leaves the button, a different mouse button is pressed, or a second input device is used;&lt;/li&gt;&lt;li&gt;a modifier or an opposite key is pressed while a keyboard key is held;&lt;/li&gt;&lt;li&gt;the window loses focus, a dialog or menu opens, or the frame, speed, step or tab changes;&lt;/li&gt;&lt;li&gt;data from the robot are late, Tiller hangs, or the robot mode, the safety mode or Remote control changes;&lt;/li&gt;&lt;li&gt;the screen is locked, the PC goes to sleep, or the input device is unplugged or stops sending data;&lt;/li&gt;&lt;li&gt;the key-state check fails: on X11, Tiller checks every 10 ms with the display server that the button or key is still pressed. If the button or key is not pressed, or if the server does not respond for 100 ms, the motion ends. If the check is not available, the header and Settings show a note;&lt;/li&gt;&lt;li&gt;the maximum hold time is reached: %1 s for a jog (Settings), five minutes for Freedrive, the duration of the move plus 5 s for a move to a position. The last 3 s are counted down.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;After a stop, press the button or key again to move the arm. While Tiller is in control, &lt;b&gt;Space&lt;/b&gt; and &lt;b&gt;Esc&lt;/b&gt; stop the arm from every window, dialog and text field. When Tiller is not in control, they act on the focused element; click &lt;b&gt;STOP&lt;/b&gt; to stop a program from another client. This is a software stop, not an emergency stop: keep the emergency stop within reach.&lt;/p&gt;&lt;p&gt;Hold &lt;b&gt;Ctrl&lt;/b&gt; for one-tenth of the speed, or &lt;b&gt;Shift&lt;/b&gt; for three times the speed, up to the speed cap. On a keyboard without Latin letters, the letters below refer to key positions on a US keyboard.&lt;/p&gt;&lt;h2&gt;Commands&lt;/h2&gt;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::ImportDialog</name>
    <message>
        <source>Colours, sizes and units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed cap and maximum hold time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots and their grippers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I/O names and scales</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1 (written by Tiller %2):</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: identical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 in Tiller, %3 in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The replaced settings are saved to a separate file, which can be imported again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All settings in the file match the current settings.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::MainWindow</name>
    <message>
        <source>Tiller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard jogging armed: arrow keys move along X and Y, PgUp and PgDn along Z; with Alt, they rotate the tool. Hold 1 to 6 and press + or − to move a joint. Space and Esc stop the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard jogging disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I/O</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 disconnected. The arm was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stopped sending data while it was moving the arm. The arm was stopped. Release the device; if the problem persists, reconnect it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recent project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens a project file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves the project to a different file, and saves all further changes to that file automatically.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show I/O</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows this tab.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes the colour theme. The setting is stored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds a command by name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes the theme, sizes, units, speed cap, devices and keyboard shortcuts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the arm, ends the connection and closes the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the program on the robot, as shown on the teach pendant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the program on the robot, e.g. pick.urp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed cap set to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens a copy of a sample project to try on the simulated robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the Gripper page of the I/O tab.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restores the panel layout of the current perspective.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero the force in the plots, or show the measured force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Subtracts the current TCP force in the plots. Press again to show the measured force.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves all settings to one file, for another computer or as a backup.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows which settings a file will replace, then imports them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recording is running. Stop the recording first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>The cell has more boxes or planes than the simulated robot supports: %n are ignored.</source>
        <translation>
            <numerusform>The cell has more boxes or planes than the simulated robot supports: %n is ignored.</numerusform>
            <numerusform>The cell has more boxes or planes than the simulated robot supports: %n are ignored.</numerusform>
        </translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows versions, log and settings, then saves them to one file for support.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller closed unexpectedly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller saved a crash log. You can attach it to a problem report.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens the manual page for the focused control, the list of commands and shortcuts, and the jogging rules.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The settings could not be saved. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adapt project to this robot…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program is paused on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program is running on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program “%1” is paused on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program “%1” is running on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking control stops the program. The program cannot be resumed, only restarted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop program and take control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoints, Program, Frames, Tools, I/O, Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Powering off stops the program. The program cannot be resumed, only restarted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop program and power off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A path is being recorded. Stop the path recording first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recording is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New project…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts an empty project in a new file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The change takes effect immediately and may disturb the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change while a program is active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change connection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not ask again during this program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program is loaded on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program “%1” is loaded on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pausing stops the arm until the program is resumed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program cannot be resumed, only restarted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm may move immediately. Make sure that no one is within reach of the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This activity stops when you close the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This activity stops when you change the connection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop and continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves the project now. Tiller also saves all changes automatically. If another window or program has changed the file, Tiller asks whether to reload the file or keep both versions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard jogging was disarmed, because an input field has the focus: the keys now edit the field. Arm the keyboard again to jog.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>robot, address</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — Tiller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Converts a project for a different robot model, keeping either the poses or the joint positions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program is running. Stop the program before you open a different project.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::PanelDock</name>
    <message>
        <source>Dock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves this panel back to the main window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes this panel. Use the View menu to show it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move, float or close %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to move, float or close this panel. Drag to move it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::PerspectiveActions</name>
    <message>
        <source>Save perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves the current panel layout to the current perspective.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save perspective as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves the current panel layout under a new name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save perspective as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename perspective…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Renames the current perspective.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be renamed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete perspective…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deletes the current perspective. The panel layout does not change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be deleted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspective %1. Select a panel layout, or save the current layout.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspective name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the perspective “%1”? This cannot be undone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This perspective is built in. Save it under a different name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::Perspectives</name>
    <message>
        <source>Teach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the view, the waypoints next to it and the plots below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows inputs and outputs, a smaller view next to them and taller plots below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows only the plots, as large as possible.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the panels as you saved them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The perspective “%1” cannot be shown because the stored layout is damaged. Arrange the panels and save the perspective again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name is too long. Enter a shorter name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The maximum number of perspectives has been reached. Delete a perspective first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the layout of the earlier version is not compatible. Arrange the panels again. The new layout is saved automatically.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the stored layout is damaged or from another version. Arrange the panels again. The new layout is saved automatically.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A perspective with this name already exists. Choose a different name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::RecordingSettings</name>
    <message>
        <source>Folder for recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder for recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File name pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{date}, {time}, {robot} and {number} are replaced when a recording starts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packets/row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals in a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Example: %1. {date}, {time}, {robot}, {number} are placeholders. Existing files are never overwritten.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n packet(s) per row: %1 rows per second from a robot that sends 500 packets per second.</source>
        <translation>
            <numerusform>%n packet per row: %1 rows per second from a robot that sends 500 packets per second.</numerusform>
            <numerusform>%n packets per row: %1 rows per second from a robot that sends 500 packets per second.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free disk space to keep, in megabytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording stops, and the file is saved, before the free disk space falls below this value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum duration of a file, in minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum size of a file, in megabytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded time before the trigger, in seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded time after the trigger, in seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A longer recording continues in a new file without losing packets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When to enter metadata</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use for each recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask before each recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: recording starts at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Combine conditions with “and” and “or”, for example:
norm(actual_TCP_force_0, actual_TCP_force_1) &gt; 20 and robot_mode = 7
actual_digital_input_bits:3 = 1
runtime_state changes
program starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New file after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>Metadata (%n field)…</numerusform>
            <numerusform>Metadata (%n fields)…</numerusform>
        </translation>
    </message>
    <message>
        <source>With a trigger, Tiller records only while the condition is true, in numbered files.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::ReportDialog</name>
    <message>
        <source>Include names and addresses of robots, inputs, outputs and files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report a problem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What happened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What did you do? What did you expect? What happened?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File content</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report is one file with the information that support needs. The complete content is listed below. You choose where to save the file. Tiller does not send it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller report %1.zip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zip archives (*.zip)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::SampleDialog</name>
    <message>
        <source>Open sample project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each project was taught with a UR5e and runs on the simulated robot. You work on a copy. To keep your changes, save the project to a new file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Appearance and motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll, pitch, yaw in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation vector in radians, as in scripts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller speed cap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units for displaying and entering lengths, TCP speeds and orientations. The units in plots and files do not change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed cap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum speed of the TCP and elbow for all motion commanded by Tiller. A change takes effect immediately and stops any motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore default shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcut for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is reserved for stopping the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is assigned to “%2”. Remove that shortcut first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum hold time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After this time, a jog stops and its button must be pressed again. Freedrive has a limit of five minutes. A move to a position has a limit of its duration plus 5 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save all settings to one file, for another computer or as a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show which settings a file will replace, then import them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interface size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch: large enough for fingers. In windows less than %1 px high, joint buttons, tabs and title bars remain smaller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scales text, controls, plots and the view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted, limited to %1 % on this screen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>System language: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reopen window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the arm, gives control back and reconnects. The plots restart. The project is saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language of the window and of the connection check. Files and scripts are not affected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monitor only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For PCs that only monitor: this window does not take control, set outputs or start programs. STOP still works.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monitor only (set on the command line)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the new shortcut in the field, or Backspace to remove the shortcut. While Tiller is in control, Space and Esc always stop the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted or the window is reopened. The plots then restart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Above %1. Manual mode and the enabling device of the teach pendant do not limit jogging from a PC. The header shows a warning. The cap is reset when Tiller is closed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsTransfer</name>
    <message>
        <source>Tiller settings (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings exported to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings imported from %1. The previous settings were saved to %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::Tutorial</name>
    <message>
        <source>First steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows a checklist in the view, from powering on to recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Five tasks on the simulated robot. Each task checks the result.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice works only with the built-in simulated robot. The current robot is “%1”. Connect to the simulated robot first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice: add “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
