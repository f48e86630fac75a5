<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ActionStep</name>
    <message>
        <source>This robot has no gripper here. Choose it in I/O, Gripper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 did not go on within %2 s. Look at what it waits for, and press again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 did not go off within %2 s. Look at what it waits for, and press again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not done. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper did not come to rest within %1 s.</source>
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
        <source>Program Tiller</source>
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
        <source>Wait for %1 on, at most %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for %1 off, at most %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for %1 on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for %1 off</source>
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
        <source>Wait a while</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BackTrack</name>
    <message>
        <source>go back: nothing left to undo</source>
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
        <source>Run the scripted demonstration on the simulated robot, leave its files in this folder, exit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open this project file (.tiller).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours: light or dark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>see tiller --help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--theme takes light or dark, not &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--robot and --simulator exclude each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--demo runs on the simulated robot only, not with --robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--demo needs a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--robot needs an address, as in --robot 192.168.0.10</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only one project can be opened, not &quot;%1&quot; too</source>
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
        <source>%1: not compared, the recording has no %2; record all signals, to MCAP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: never beyond %2, at most %3 at %4 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: beyond %2 from %3 s on (%4), at most %5 at %6 s</source>
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
        <source>Arm and model part at %1 s: %2 is %3 off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and model part at %1 s: the TCP is %2 off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and model part at %1 s: %2 needs %3 more or less than it should</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and model part at %1 s: a force of %2 pushes the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm did what the model of a %1 does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing could be compared: the arm had no power all the time, or was led by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They never were together: check the payload that the robot was told of, the model, and what touches the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From there on something pushed or held the arm, its load was another one, or a joint did not follow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: it lacks what the joints were told, or where they were. Record all signals, to MCAP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: its rows are too far apart. Record every packet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not compared with the model of the arm.</source>
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
        <source>A joint came close to the end of its range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog the joint back, and plan the move away from the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near a tool orientation limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool turned close to the limit set in the safety configuration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the tool back, or change the waypoint.</source>
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
        <source>The arm is not where the controller sent it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look for an obstacle; check payload, centre of gravity and mounting; lower the acceleration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Singularity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The straight move leads through a singular position of the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog single joints out of it; use MoveJ through this region.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot hold its position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm sagged or was pushed while it stood.</source>
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
        <source>The forces do not fit the payload, or something pushed the arm when Freedrive began.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct payload and mounting, let go of the arm, and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collision noticed by a joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A joint needed more torque than the motion explains.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the obstacle; if there was none, check the payload.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collision noticed by the tool force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force at the tool exceeded what is allowed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A joint left its commanded position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look for an obstacle and check payload and mounting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many protective stops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One joint had more than fifty protective stops in eight hours.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find the cause of the stops before going on; then restart the controller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sudden change of target position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program asked for a jump in position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the program begin where the arm is, and keep its servo steps small.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sudden change of target speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program asked for a jump in speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower the acceleration, or smooth the path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protective stop by a program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The running program itself asked for the stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See the program&apos;s own messages before it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A script was sent, but the robot listens to its pendant only.</source>
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
        <source>The controller reported this number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look C%1 up in the manufacturer&apos;s error code directory.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Derivation</name>
    <message>
        <source>compute a signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no signal “%1”. The list of signals shows the names.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no signal in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are too many signals in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It must give one number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The text is too long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write it as a name, an equals sign and an expression: |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is one equals sign too many; a comparison has two: ==</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stretch of time is between 0.001 and 60 seconds.</source>
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
        <source>Axes of the device</source>
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
        <source>the RTDE port takes connections but does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what answers on port %1 does not speak RTDE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too many RTDE clients, or a controller that hangs: close other programs, then restart the controller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the address: this is another device, or another program took the port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>protocol version %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another program holds %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the other program that controls this robot (another window, ROS, ur_rtde).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this software has no registers 24 to 47</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update the robot&apos;s software to 3.9 or 5.3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>24 to 47 are free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a fieldbus adapter or another program holds %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to do for jogging. To use these registers, switch EtherNet/IP, PROFINET or MODBUS off in the robot&apos;s installation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 to 23 are free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This software is too old. Update the robot to %1.%2 or newer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some values and the registers for control are missing. Update the robot to %1.%2 or newer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the arm, remove the cause, then recover: Recover… in the header, or on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power on and release the brakes: the header&apos;s button leads the way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot takes the subscription but sends no data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close other RTDE programs, then restart the robot&apos;s controller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 packages a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packages are missing: use a cable, not a radio link; close other programs that load the robot or this PC.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>priority %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the system grants this user no real-time priority</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP %1 mm from the flange, payload %2 kg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If a tool is mounted, set TCP and payload in the robot&apos;s installation: a wrong payload causes protective stops and lets the arm sag in Freedrive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no address, and no host of that name is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter the four numbers shown on the teach pendant under About, or ask who runs the network for the name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no way to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the robot is switched on and the cable is plugged in, and that no firewall stands between.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give this PC an address in the robot&apos;s network (the same first three numbers), and check the cable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 answers, but none of a robot&apos;s services is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that this is the robot&apos;s own address. A robot that has just been switched on needs another minute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 answers</source>
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
        <source>port %1 does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch this interface on at the robot: Settings, Security, Services.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A firewall swallows this port: allow TCP port %1 to the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the robot to Remote control on the teach pendant, at the top right. Without that, Tiller only watches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the dashboard takes connections but does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what answers on port %1 is not a dashboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart the robot&apos;s controller; if it stays like this, see its log.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the address, and that no other program uses this port.</source>
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
        <source>neither the dashboard (port %1) nor the Robot API (port %2) is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the Dashboard Server on at the robot: Settings, Security, Services. PolyScope X needs 10.11 or newer for the Robot API.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot API %1, port %2; popups are closed on the tablet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the primary interface does not describe the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that this is the robot&apos;s own address, and restart its controller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot type %1 is newer than this program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watching works. Limits and previews use the dimensions the robot reports; jog slowly at first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address resolves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Host answers</source>
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
        <source>RTDE is understood</source>
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
        <source>Registers for control free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No fieldbus holds registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Real-time privilege of this PC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP and payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>permitted, and asked for by loops with priority</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>processors may sleep deeply, loops begin later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fast wake-ups of this PC</source>
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
        <source>Plane X Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the arm come to rest before freedrive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm feels %1 with a payload of %2 kg: it would move by itself. Let go of the tool, or correct payload and TCP.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Gamepad</name>
    <message>
        <source>left shoulder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left stick X and Y, right stick Z and turn. Right shoulder: the sticks turn.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HoldWitness</name>
    <message>
        <source>No second witness on this screen (%1): whether a key is still held is known from the window&apos;s events alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The display server is asked every 10 ms whether the button or key is still down.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The display server cannot be asked a second time: whether a key is still held is known from the window&apos;s events alone.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>InterfaceSize</name>
    <message>
        <source>This screen has small pixels. &quot;Size of everything&quot; in Settings makes text, keys and plots larger.</source>
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
        <source>Arm or disarm the keyboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed, the arrow keys move the arm; a frame stands around the window. Ends by itself after half a minute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What each device says now, and which way it will go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counts the way of the TCP from where it is now; once more: since the press again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the arm; the next press has this speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves by this much, only while the key is held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves by this much at each press.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog until contact, %1 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A held key moves slowly and ends when the tool meets this force.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog speed, other…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks for the speed of the TCP; turns and joints in proportion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog step, other…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog until contact, other force…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks for the force in N at which the motion ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freedrive: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the hand can move while Freedrive is held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks for the length of a step; the angle of turns stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog turn, other…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks for the angle of a step that turns the tool or a joint; the length stays.</source>
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
    <name>LimiterAdvice</name>
    <message>
        <source>Elbow almost straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elbow almost straight: %1 of the speed</source>
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
        <source>Wrist above the base axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist above the base axis: %1 of the speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move outwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog %1 or turn the base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°: %1 of the speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn wrist 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog %1 or turn wrist 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2° from its limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jog %1 or turn %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP at its speed cap: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the cap is in the settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elbow at its speed cap: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move less sideways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turning at its cap: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at its top speed: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose a slower class</source>
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
        <source>The robot confirms that the arm moves.</source>
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
        <source>monitoring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packets come late or not at all: jogging may stop by itself and plots have gaps. Use a cable, not a radio link, and close other programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands take longer than 20 ms: the arm follows the key noticeably late. Jog slowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: the arm follows the key at once, and a cut link stops it within a quarter of a second.</source>
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
        <source>Choose the simulator or the address of a robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Powers the arm. Brakes stay engaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what stopped the arm, the last five seconds, and the way back. Nothing moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts the control program on the robot, which stops any other program.</source>
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
        <source>Late is a packet that comes more than half a period after its time.</source>
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
        <source>The arm follows the hand that moves it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freedrive</source>
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
        <source>Arm off line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The controller has no connection to the arm. See the teach pendant.</source>
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
        <source>The arm is off. Power it on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm has power and is getting ready. Wait a moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Idle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The brakes are on. Release them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is moved by hand past its brakes. Let go of the Freedrive button.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brakes are released. The arm stands still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Updating firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The joints&apos; firmware is being updated. Keep the power on until it is done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No safety function is active.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot keeps to its reduced limits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The controller stopped the arm. Find out what stopped it, then unlock (after 5 s).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is outside a safety limit. Move it back within its limits on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A safeguard is open. Close it; where a reset is configured, press it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cell&apos;s emergency stop is pressed. Release it, then power on and release the brakes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s emergency stop is pressed. Pull the button out, then power on and release the brakes.</source>
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
        <source>A joint was exchanged. Validate the joints on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undefined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The controller does not tell its safety mode. Look at the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic safeguard stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The safeguard of automatic mode is open. Close it, or change to manual mode.</source>
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
        <source>The pendant&apos;s enabling key is not held. Hold it in its middle position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IMMI emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The moulding machine&apos;s emergency stop is pressed. Release it, then power on and release the brakes.</source>
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
        <source>The robot waits for its PROFIsafe controller. Check the fieldbus and its parameters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PROFIsafe automatic stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PROFIsafe controller holds the safeguard of automatic mode open. Close it there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PROFIsafe safeguard stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PROFIsafe controller holds a safeguard open. Close it there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PROFIsafe emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The PROFIsafe controller asks for an emergency stop. Release it there, then power on and release the brakes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety API stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program stops the arm through the safety interface. End the stop in that program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I/O plane stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool crossed a safety plane that an input switched on. Move it out on the teach pendant, or switch the input off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program stopping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program on the robot is ending.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program runs on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program runs on the robot and may move the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program pausing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program is coming to a halt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play goes on with the interrupted motion; stop the program to drop it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program resuming</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program is going on: the arm may move.</source>
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
</context>
<context>
    <name>OutputGripper</name>
    <message>
        <source>The robot did not confirm the outputs. Another program or the installation may own them.</source>
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
        <source>told to open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>told to close</source>
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
        <source>Choose two different outputs: one closes, the other opens.</source>
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
        <source>Writes every packet of the robot to a CSV file, until it is stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recording runs already.</source>
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
        <source>Ends the recording; its file is complete.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is recorded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause or resume the plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds the plots still; data and recording go on. Once more: back to the newest samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the plots…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves the shown range as a picture, a drawing, a page or values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots show %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much time the plots show.</source>
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
        <source>Rename the chosen input or output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The row of the tab I/O that has the focus.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the chosen output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The output of the tab I/O that has the focus: on, or off again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulse the chosen output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The output of the tab I/O that has the focus: on for half a second, then off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows only the lines with these words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log: show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log: show warnings and worse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log: show errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chooses which lines of the log are shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the selected lines, or all that are shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the log…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the lines that are shown to a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search signals for the plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens the list of everything the robot tells: onto a plot by dragging, double click or Return.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New page of plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An empty page behind the others; all pages show the same time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all of the plots&apos; history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that is in memory, each plot at its best scale.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlotMenu</name>
    <message>
        <source>Take the lane %1 away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note here…</source>
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
        <source>Let the cursors read %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1 to a plot of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarm when %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No alarm when %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate of change of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving mean of %1 over half a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Norm of the curves of this plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New plot below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New plot beside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take this plot away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the curves decide about the scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Practice</name>
    <message>
        <source>Waiting for the stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is in a protective stop. Press Recover in the header.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlocked. The arm does not run yet: follow the recovery page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlocked. Take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm runs and is under your control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No new frame yet. Three points is in the tab Frames.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” lies as it was asked for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”: its Z is %2° off the base&apos;s. The third point lies on the side of +Y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”: its X is %2° off the base&apos;s Y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was not taken with the arm: the TCP has not been at its origin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The waypoint is not there any more. Start puts a new one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is where it was. The arm is %2 along X from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has moved by %2, and is %3 from where it should be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is at the place, but the tool was turned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is at the part again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is at the place, but the arm is not there. Touch up with the arm at the part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slowed down to %1. Go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No limit yet. The line below the pad will name it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is the limit. Now back: %1 of %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found it, and out of it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording: %1 s of %2 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That recording is too short. Record again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recording yet. Record is above the plots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded. Enter the force that the plot shows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not what was recorded. Look at the curve Fz.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right: it was %1.</source>
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
        <source>Start makes the simulated arm collide, and it goes into a protective stop. Look at what stopped it, wait for the five seconds, unlock it and take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach a frame from three points in the tab Frames. Its X shall go along the base&apos;s Y+, its Z up: take the origin, then a point further along Y+, then one further along X−.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start puts a waypoint “part” where the arm stands. The part has since moved by %1 along the base&apos;s X+. Jog there, select the waypoint and touch it up (U).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog away from the base, outwards, until a limit slows the arm down to half. The line below the pad names it and the way out. Then jog %1 back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start makes a hand press on the tool from above. Record for at least three seconds and stop. Read in the plots how large the force Fz is, and enter it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>part</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ProblemReport</name>
    <message>
        <source>write %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>No robot connected. Choose one at the top left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot data is late. Waiting for it to come back.</source>
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
</context>
<context>
    <name>RecordingChoice</name>
    <message>
        <source>A file needs a name that does not begin with a point.</source>
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
</context>
<context>
    <name>RecoveryGuide</name>
    <message>
        <source>Safety is normal again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm can be moved. What was armed before the stop does not move it: every motion needs a new press.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is ready. Take control to move it, or go on on the teach pendant.</source>
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
        <source>Waiting for the connection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I looked at the arm: nobody touches it, nothing is caught.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What stopped it is known and removed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Payload and TCP are those of the tool that is mounted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Possible in %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I looked at the arm and at the robot&apos;s log: the cause is known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cause is removed, and nobody is in the arm&apos;s reach.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to press here: it ends when its cause is gone.</source>
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
        <source>at %1 s of %2</source>
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
        <source>No program runs on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A program runs already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the simulator, a robot or a project.</source>
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
        <source>Looks at everything between this PC and the robot, each with its fix.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a robot first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends the connection; a motion of ours stops first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Powers the arm. Brakes stay engaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm has power, or is getting it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engages the brakes and takes the arm&apos;s power away; programs stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what stopped the arm, and the way back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No stop of the safety system.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After a violation or a fault, once its cause is found. The arm stays off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only after a violation or a fault.</source>
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
        <source>Starts the control program on the robot, which stops any other program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In control already.</source>
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
        <source>Software stop of whatever moves. Not an emergency stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load program…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads a program of the robot&apos;s own by its name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts the loaded program, or goes on with a paused one: the arm may move at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pauses the program that runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the robot&apos;s own program.</source>
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
        <source>Input register %1: %2</source>
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
        <source>The program on the robot was stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program on the robot was not stopped: stop it on the teach pendant. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot was switched to Local control: motion was stopped and control given back. Switch it to Remote control on the teach pendant, then take control again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RobotTooling</name>
    <message>
        <source>The arm is not under control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP and payload are set while the arm stands still. Let it come to rest.</source>
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
        <source>A part is taken from a feeder and put into one of six places of a tray. The places are given in the frame of the tray and move with it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gluing along a path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A seam around a lid with rounded corners, slow and in straight lines. Blends keep the nozzle moving through the corners.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A probe touches a part from above and from four sides, each from an approach point and with the tool tilted.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SceneActions</name>
    <message>
        <source>Look from the first side, in perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From between front and side, a little above, with everything in the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X of the base to the right, Z up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y of the base to the right, Z up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X of the base to the right, Y up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit everything into the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm, target and waypoints into the picture, from the side it is looked from now.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SessionRecording</name>
    <message>
        <source>Nothing is recorded: connect to a robot first.</source>
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
</context>
<context>
    <name>SettingsFile</name>
    <message>
        <source>write %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value of &quot;%1&quot; is none that settings can have.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is too large for settings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is damaged at byte %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds no settings of Tiller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file was written by a newer Tiller. Update Tiller to import it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file does not say which version it has.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has no list of values, or one that is too long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name of a setting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read %1</source>
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
        <source>More</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Registers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force at the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque at the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation vector of the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation speed of the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration of the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target position of the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target rotation vector of the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target speed of the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target rotation speed of the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw force of the sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw torque of the sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force at the TCP, norm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accelerometer in the flange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the elbow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the elbow</source>
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
        <source>Allowed deviation of the currents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position deviation over its limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collision measure over its limit</source>
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
        <source>Current of the I/O</source>
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
        <source>Time of a control step</source>
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
        <source>Stopped by safety</source>
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
        <source>Output registers, numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input registers, numbers</source>
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
</context>
<context>
    <name>SpaceMouse</name>
    <message>
        <source>left key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cap moves and turns as the tool shall.</source>
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
        <source>There are fewer than %1 samples: choose a longer range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values are missing in this range: choose one without a gap.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is too little memory.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StartProject</name>
    <message>
        <source>The project worked in last is not there any more: %1</source>
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
        <source>Idle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Check the address: four numbers as in 192.168.0.10, or a name the network knows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and this PC is in the same network.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the interface on at the robot: Settings, Security, Services. A robot that has just been started may need another minute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot ended the connection: it may be restarting, or was switched between Local and Remote.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot does not answer. Check the cable and that the address is the robot&apos;s own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data stopped coming. Check the cable; the connection comes back by itself, motion does not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What answers there does not speak RTDE as it should. Check address and port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s software is too old for this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s software does not have this value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program or a fieldbus on the robot owns these registers: close the other program, or switch the fieldbus off in the installation.</source>
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
        <source>Bring the robot to Running and its safety to Normal first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the robot to Remote control on the teach pendant, at the top right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a target inside the arm&apos;s range and a speed within the cap.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm cannot reach this pose: move the point nearer or turn the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot could not run the program it was sent. See the log for its own words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the file exists and may be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder you may write to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file was left as it is. Open a backup, or repair the named place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The disk is full: what was recorded so far is kept. Free some space and record anew.</source>
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
        <source>Connection ended by the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not understood</source>
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
        <source>Not possible in this state</source>
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
        <source>Not a valid value</source>
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
        <source>File cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File cannot be written</source>
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
        <source>released</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pointer left the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>focus lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>window no longer active</source>
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
        <source>selection changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>second button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>input device lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot data too old</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot or safety mode changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not refreshed in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PC going to sleep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link lost</source>
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
        <source>contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>target cannot be reached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>target too far away for one step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no sign that it was still held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held for the longest time; press again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PolyScope X before 10.11 takes no such commands over the network: use the tablet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PolyScope X has no command for closing popups over the network: use the tablet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only watching. Take control to move the arm.</source>
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
        <source>The control program was stopped on the robot. Take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The control program does not answer. Take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link was lost. Take control again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A script of your own is running. Control comes back when it ends.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WaypointClipboard</name>
    <message>
        <source>is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is outside %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is neither J nor L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is neither joints nor pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no frame “%1” in this project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not a table of waypoints. Copy one from the list to see its columns, or paste the six figures of a pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no colour of a waypoint</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WaypointExchange</name>
    <message>
        <source>Line %1: a quotation mark is not closed</source>
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
        <source>Done in this order when “Go through” has brought the arm there, and only while its key is held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These waypoints have different actions. “Change” gives all of them the ones below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions in their order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an action after the chosen one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do the chosen action earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do the chosen action later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which terminal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seconds</source>
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
        <source>At most, seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then it ends and says so. 0: as long as the key is held, at most an hour</source>
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
        <source>%1: %2
Right click or F2 to rename and scale.</source>
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
        <source>Scale of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bar; empty: not scaled</source>
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
        <source>Arrows move X and Y, PgUp and PgDn move Z, with Alt they turn, 1 to 6 with + and − turn a joint. Space and Esc stop. Click, or wait half a minute: the keyboard is disarmed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then the arrow keys move the arm while they are held; a frame stands around the window.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonBand</name>
    <message>
        <source>Comparison with the model of the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare this recording with the model of its arm, with other limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare no further</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put cursor A where arm and model part</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonDialog</name>
    <message>
        <source>Compare with the model of the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the joints were told is given to the simulated arm, and what that does is compared with what was recorded. Nothing touches the simulated arm, and it knows no friction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model of the arm</source>
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
        <source>For longer than</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What has a limit of 0 is not compared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::DeviceTrainer</name>
    <message>
        <source>Moves the arm (until the program ends)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the axis that is out furthest</source>
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
        <source>Which way the arm would go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dead-man</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Would move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard, while armed (Ctrl+J): arrows X and Y, PgUp and PgDn Z, with Alt they turn, 1 to 6 with + and − a joint, Home, End align, Backspace back, F freedrive. Ctrl slower, Shift faster. Space and Esc stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gamepad and no SpaceMouse is there. Plug one in: it appears by itself.</source>
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
        <source>nothing: neutral</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::FigureBox</name>
    <message>
        <source>“%1” was not taken: %2 to %3. Nothing was changed.</source>
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
        <source>Take control, hold a pad key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach here (T)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog away, hold Go to (G)</source>
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
        <source>The list does not come again by itself. The command “First steps” brings it back.</source>
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
        <source>no waypoint uses it</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints move with it</source>
        <translation>
            <numerusform>%n waypoint moves with it</numerusform>
            <numerusform>%n waypoints move with it</numerusform>
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
        <source>In Base. Return applies it; nothing moves but the frame.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::FrameEditing</name>
    <message>
        <source>No waypoint moved with it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints moved with it.</source>
        <translation>
            <numerusform>%n waypoint moved with it.</numerusform>
            <numerusform>%n waypoints moved with it.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them are out of reach there.</source>
        <translation>
            <numerusform>%n of them is out of reach there.</numerusform>
            <numerusform>%n of them are out of reach there.</numerusform>
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
        <source>It moves by %1 (%2, base frame).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No waypoint is given in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints move with it.</source>
        <translation>
            <numerusform>%n waypoint moves with it.</numerusform>
            <numerusform>%n waypoints move with it.</numerusform>
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
        <source>“%1” is touched up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the place of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is set in figures. %2</source>
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
        <source>%n waypoints are given in it. They stay where they are, given in Base.</source>
        <translation>
            <numerusform>%n waypoint is given in it. It stays where it is, given in Base.</numerusform>
            <numerusform>%n waypoints are given in it. They stay where they are, given in Base.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::FrameModel</name>
    <message>
        <source>A frame needs a name.</source>
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
        <source>“%1” is a frame every robot has. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is taken by another frame. Choose another name.</source>
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
        <source>Rotation rad</source>
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
        <source>Waypoints that move with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the TCP, %1</source>
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
        <source>Cancel the frame</source>
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
        <source>Take the origin here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the point on +X here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the point towards +Y here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot sent no valid place. Take the point again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The point on +X is only %1 from the origin. Take it again at least %2 away: the further, the truer the axes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The third point is only %1 from the origin. Take it again at least %2 away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The three points lie in a line: the third is only %1 beside the X axis. Take it again at least %2 to the side of +Y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready: the point on +X is %1 away, the third lies %2 beside the X axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog the tip to where the frame begins, and take it (P).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now to a point on +X: %1 from the origin, %2 is the least.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now to the side of +Y: %1 beside the X axis, %2 is the least.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take  P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Again</source>
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
        <source>More about frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No frames yet.
Jog the tip to a corner of the tray or table. Press From TCP, or 3 points to take origin, +X and +Y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s data are old. Wait until they come again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is connected. Connect one, or try the simulator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A frame where the TCP is, with the tool&apos;s axes (Shift+T)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin, a point on +X, a point towards +Y (Ctrl+Shift+T)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected frame goes to where the TCP is (Shift+U)</source>
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
        <source>Take the next point of the frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the frame of the points taken</source>
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
        <source>Set frame in figures</source>
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
        <source>Make frame</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::GoThrough</name>
    <message>
        <source>There are no waypoints to go through. Teach some, or select them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no waypoint before this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A waypoint of the way is not in this project any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A loop of one waypoint leads nowhere. Choose more waypoints, or go without the loop.</source>
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
        <source>Go through the waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go through (hold)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go through, hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One waypoint back, hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes back to the waypoint before while the key is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One waypoint on, hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes to the coming waypoint while the key is held, and stops there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which waypoints to go through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which waypoints to go through, in the order of the list</source>
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
        <source>In a loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After the last waypoint comes the first again, for as long as the key is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is not under control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coming one: %1 of %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done. The next press begins at the first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes from waypoint to waypoint while the key is held, no faster than the jog speed, and does at each what is to be done there. Let go to pause; the next press goes on to the coming waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At %1: %2</source>
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
        <source>Moves the arm to the selected waypoint while the key is held (G), no faster than the jog speed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::GripperPanel</name>
    <message>
        <source>State of the gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the gripper is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the gripper holds</source>
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
        <source>Move the fingers to this opening</source>
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
        <source>Gripper: to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which gripper</source>
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
        <source>One output: on closes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two outputs: open, close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output that closes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output that opens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening wanted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the fingers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force of the fingers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to do about the gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens</source>
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
        <source>Holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to</source>
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
        <source>How far the fingers shall open, 0 to %1. “Move” sends them there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the next motion. 0 % is about %1, 100 % about %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the next grip. 0 % is about %1, 100 % about %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper of this robot: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (speed %2, force %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to a robot first: each robot remembers its gripper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data from the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One moment…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose what is at the wrist. It is remembered with this robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>being activated…</source>
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
        <source>active, standing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown while it moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object, from outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object, from inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With this port offset no gripper can be reached.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Being activated: the fingers open and close once.</source>
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
        <source>A stop of the arm leaves the gripper as it is: it goes on holding.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fingers open and close once; what they hold falls. Keep fingers out of the gripper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens the gripper; what it holds is let go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes the gripper. Keep fingers out of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sends the fingers to this opening.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its speed or its force is no figure it takes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper did not take the command.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gripper: stop</source>
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
        <source>State of the robot</source>
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
        <source>From the stop to standstill, measured. Cause: %1</source>
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
        <source>The arm may get faster than %1. Lower the cap in Settings; it ends with the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data ended while the arm moved: how it stopped is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LAST STOP · no witness</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::HoldButton</name>
    <message>
        <source>hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold this key: it moves the arm only as long as it is held.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::HoldRules</name>
    <message>
        <source>The window was not the active one. Press again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click into the window first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A dialog or a menu is open. Close it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another key is held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The display server does not answer: nobody could tell when the key is let go.</source>
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
        <source>Everything from %1 s before it is in %2. Double-click this line to open it.</source>
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
        <source>%1, old data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Cannot be switched while no data come from the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Click to switch it %1. P: pulse. Right click: pulse, rename.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (held by another)</source>
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
        <source>Part of I/O</source>
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
        <source>Registers of the robot&apos;s programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data from the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to a row of the tab I/O with the key Tab first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot did not confirm %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program or the installation may own it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a replay: go back to live first.</source>
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
        <source>Shown below the pad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm has not moved yet.</source>
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
        <source>Moves every joint to the home position while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns the tool to the nearest axis of the chosen frame while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes back the way the arm came while held</source>
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
        <source>Another key is held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last stop: %1, standstill after %2 ms, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm follows the hand while held: %1. Right click: other axes</source>
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
        <source>Check the payload first (until the next connection)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>let go and press again</source>
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
        <source>Last stop: not seen, data ended while the arm moved</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::JogKey</name>
    <message>
        <source>%1 left this way</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::JogPad</name>
    <message>
        <source>Jog keys</source>
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
        <source>Moves while the key is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes of the picture: X right, Y away from you, Z up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Needs the 3D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No frame taught yet. Teach one in the tab Frames.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One step a press: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>≤ %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slowly until the tool touches something with %1 N, while held. Click again for other steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One step a press: %1. Click again for other steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · turns %2 · joints %3 · Ctrl × 0.1, Shift × 3</source>
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
        <source>Until contact, other force…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other speed…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the TCP in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force that ends the motion, in N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns while the key is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One turn a press, of the tool or a joint: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One turn a press, of the tool or a joint: %1. Click again for other turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other turn…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn in degrees</source>
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
        <source>the operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · from %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times from %2 to %3 · from %4</source>
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
        <source>What happened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(×%1 until %2) %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the recording of this incident, at the moment of the stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the recording at this moment</source>
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
        <source>Show from severity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter the log by words</source>
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
        <source>Copy the selected lines, or all that are shown (Ctrl+C)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the lines that are shown to a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected line in full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
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
        <source>Open the recording of the selected line: incidents have one</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::MoveWords</name>
    <message>
        <source>%1 touches %2 of the arm already here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 meets %2 of the arm after %3 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 touches the floor already here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 meets the floor after %2 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 touches “%2” already here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 meets “%2” after %3 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line runs into the wrist singularity after %1 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slow near the wrist singularity at %1 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line runs into the stretched elbow after %1 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slow near the stretched elbow at %1 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line runs into the axis of the base after %1 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slow near the axis of the base at %1 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A joint would have to turn at once after %1 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 leaves its range after %2 of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line leaves the arm&apos;s reach after %1 of the way</source>
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
</context>
<context>
    <name>tiller::NothingFound</name>
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
    <name>tiller::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept</source>
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
        <source>%n waypoints written as a path to %1</source>
        <translation>
            <numerusform>%n waypoint written as a path to %1</numerusform>
            <numerusform>%n waypoints written as a path to %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Tolerance of recorded paths</source>
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
        <source>Import demonstration (CSV)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording of the path ended by itself: the data stopped, or it lasted ten minutes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was recorded until then is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the recording of the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path is being thinned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data come from the robot: there is nothing to record.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends the recording and keeps the path as waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records where the arm is led, by Freedrive or by jogging, until it is pressed again, and keeps the path as waypoints. It moves nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the waypoints of the path, at least two.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path was not written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a demonstration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>○ Path</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PathRecorder</name>
    <message numerus="yes">
        <source>%n packets did not arrive.</source>
        <translation>
            <numerusform>%n packet did not arrive.</numerusform>
            <numerusform>%n packets did not arrive.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 has no column “%2”. It needs timestamp and actual_q_0 to actual_q_5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data come from the robot: there is nothing to record.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was read: a path is being recorded. End that first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The demonstration could not be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>path %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm did not move: no path was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”: %2 s in %3 waypoints. Every recorded place is within %4 and %5 of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the waypoints of the path, at least two.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot be reached. Touch it up, or leave it out.</source>
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
        <source>First place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End of the first row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beginning of the last row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose a waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it was taught</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places in a row</source>
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
        <source>Height of a layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From one layer to the next, against the direction of the tool.</source>
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
        <source>Meander</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A pattern needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a pattern of that name. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the waypoint of each corner. Teach the three corners first where there are none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two corners are the same place. Choose another waypoint for one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The height of a layer is no figure it can be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers need a height.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 places are more than the %2 a pattern can have.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every place is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints.</source>
        <translation>
            <numerusform>%n waypoint.</numerusform>
            <numerusform>%n waypoints.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 All can be reached.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n of them are out of reach; they are marked.</source>
        <translation>
            <numerusform>%n of them is out of reach; it is marked.</numerusform>
            <numerusform>%n of them are out of reach; they are marked.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::PatternGrid</name>
    <message>
        <source>Places of the pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a place to leave it out, or to take it in again. The first corner is at the lower left.</source>
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
        <source>Find the payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find the payload by weighing it in several poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next pose, hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns the wrist to the next pose while the key is held, no faster than the jog speed. Look that the tool has room to turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel finding the payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is not under control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm moved. Let it come to rest, touch nothing, and take the pose again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot sends no forces. Enter mass and centre in figures instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weighing… let nothing touch the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kg, centre at %2 from the flange. The poses agree within %3 and %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 That is poor: pose %2 fits least. Remove it and take another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool is turned too little between the poses. Take one more, turned to another side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kg: too light for the sensor to tell where its centre is. Enter it in figures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the arm come to rest, touch nothing, and take the pose. Then turn the wrist, by jogging or with Next pose, and take three more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Turn the wrist to another side and take the pose. Still needed: %n</source>
        <translation>
            <numerusform>Turn the wrist to another side and take the pose. Still needed: %n</numerusform>
            <numerusform>Turn the wrist to another side and take the pose. Still needed: %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Take pose %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the worst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose %1  %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  ◀ fits least</source>
        <translation type="unfinished"></translation>
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
        <source>A payload needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is taken by another payload. Choose another name.</source>
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
        <source>No payload yet.
Press From robot to keep the one it has, or Weigh… to find it with the arm.</source>
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
        <source>Mass of the payload</source>
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
        <source>Return applies it to the project; the robot keeps its own.</source>
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
        <source>Weigh…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find the payload with the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is it true?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check whether the payload is true</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the payload the robot has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New payload in figures</source>
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
        <source>No robot is connected. Connect one, or try the simulator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a payload to set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the payload “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is not under control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the payload “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weighing… let nothing touch the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm moved. Let it come to rest, touch nothing, and check again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot sends no forces: its payload cannot be checked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With %1 kg the arm feels %2 and %3 at rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The payload is true. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The payload is true</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About %1 kg more hang there than it was told of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About %1 kg less hang there than it was told of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its centre is elsewhere, or something touches the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 Weigh it, or choose another payload. Zeroing the force sensor hides a wrong payload until the tool turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The payload is not true. %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The payload is not true</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, as the robot has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; the robot was told %2 kg, centre %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot has another payload than “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the robot: %1 kg, centre %2. In the project: %3 kg, centre %4. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
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
        <source>over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind of analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over this signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a signal onto the plots first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no samples in this range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples are missing in this range: place the cursors A and B so that there is no gap between them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hann window of %1 samples · %2 Hz a line · mean of %3 · %4 … %5 s</source>
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
    <message numerus="yes">
        <source>%n sample(s), one in %1</source>
        <translation>
            <numerusform>%n sample, one in %1</numerusform>
            <numerusform>%n samples, one in %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 … %3 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These two are not of the same recording: place the cursors A and B around a shorter range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the recording: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PlotComparison</name>
    <message>
        <source>Not compared with the model of the arm: which arm this is of is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and model part: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing the arm with its model: %1</source>
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
        <source>export to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>export: there are no samples in this range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cursor read-out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause the plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the shown range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save what is shown as a picture (PNG) or as values (CSV)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record to a CSV file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused · %1 s back</source>
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
        <source>Hold the plots still; data and recording go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the newest samples</source>
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
        <source>Exported the shown range to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was exported: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>controller time %1 … %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing (*.svg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name the file .png, .svg or .pdf for a picture, .csv for values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click in the plots to place the cursors A and B; drag them, or use the keys A, B and the arrows. Click a name in a legend to hide its curve, with Ctrl to read that signal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much time the plots show. The wheel over the plots zooms; over the values at the left, or with Ctrl, it zooms them, and a double click there lets the curves decide again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero the force shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record what the robot sends to a CSV file; the key beside it says what and where</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force was not zeroed: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the force as the robot measures it again. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Count the force from what it is now. Only what the plots show: the robot, recordings and exported values keep what was measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows, signals, folder and file name of the next recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A row for every packet</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>A row for every %n packet(s)</source>
        <translation>
            <numerusform>A row for every packet</numerusform>
            <numerusform>A row for every %n packets</numerusform>
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
        <source>File name %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the folder</source>
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
        <source>%1, at %2 s of the plots&apos; time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What happened at this moment?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plots are in the clipboard as a picture.</source>
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
        <source>Take this page away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the plots as a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save this arrangement…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open an arrangement…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory for the history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>save the arrangement to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open the arrangement %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened the recording %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (*.mcap *.csv *.h5 *.hdf5);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the arrangement of the plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrangement of plots (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open an arrangement of plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List of signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything the robot tells: drag it onto a plot, to its edge for a plot of its own, or double click</source>
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
        <source>What every signal has at the cursors A and B, and what lies between them: smallest, largest, mean, RMS, deviation, slope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages and arrangement of the plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout ▾</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read an arrangement of plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the shown range…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before the newest sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of the day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are as many pages of plots as there may be: take one away first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record to an MCAP file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record what the robot sends to an MCAP file; the key beside it says what and where</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 · %2 a second · %3 free · %n packet(s) lost</source>
        <translation>
            <numerusform>%1 · %2 a second · %3 free · %n packet lost</numerusform>
            <numerusform>%1 · %2 a second · %3 free · %n packets lost</numerusform>
        </translation>
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
        <source>Compare with the model of the arm…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PlotMarks</name>
    <message>
        <source>%1 above %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 below %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::PlotPages</name>
    <message>
        <source>Pages of plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the page</source>
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
        <source>Double click: another name</source>
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
        <source>Slope per s</source>
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
        <source>Click into the plots to place A, then B: what lies between them is summed up here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · summing up: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not all of the range could be summed up: %1</source>
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
        <source>No samples yet: connect to a robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (zeroed)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale held · double click the axis to let it go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zeroed: %1 %2 taken off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A and B place the cursors, the arrow keys move them, up and down choose the signal they read; H hides its curve, Ctrl+Delete takes it away; plus and minus change the time window, with Ctrl the scale of the values, Ctrl+0 lets the curves decide about it again; N writes a note; F shows all; End goes back to the newest samples</source>
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
        <source>orientation as chosen in Settings. Δ₀: way since zero. Click: way since the press</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orientation as chosen in Settings. Δ: way since the press. Click: zero here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP in the frame of the flange: %1</source>
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
        <source>A position needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is taken by another position. Choose another name.</source>
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
Jog the arm to a place and press Set home here, or Add here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safe height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Return applies it; nothing moves but the position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above it, in the base frame, nothing stands: there the TCP may go sideways.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The safe height is where the TCP is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set home here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the position the arm has</source>
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
        <source>Touch up the position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the usual home again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the usual home</source>
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
        <source>The robot&apos;s data are old. Wait until they come again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is connected. Connect one, or try the simulator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set “%1” to where the arm stands?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The key Home goes there from now on.</source>
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
        <source>No safe height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The key Home goes to the usual home: upright, clear of itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the key Home goes there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2 %3 from here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::Practice</name>
    <message>
        <source>Start the simulated robot first: it is in the robot menu.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power the arm on and release the brakes first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is in a stop. Recover from it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done. Start does it once more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Start.</source>
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
        <source>figure, then Return</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fz [N]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The task before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice · %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begins the task, or begins it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes on to the next task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Possible once the check above says so</source>
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
        <source>Look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not looked at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before you connect to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look again</source>
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
        <source>Keep everybody out of the arm&apos;s reach.
Keep the emergency stop at hand: STOP in this window is a software stop.
Begin slowly: the first speed is %1.
Watch the arm, not the screen, while a key is held.
Let go of the key and the arm stops.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking at %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something is in the way</source>
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
        <source>Connected anyway, the window shows what data there are. What is red above may keep it from taking control, or end a motion while it runs.</source>
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
        <source>Change the order</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFiles</name>
    <message>
        <source>The damaged project file was kept as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project could not be saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Update Tiller to open it. The file was left as it is.</source>
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
        <source>%1. Waypoints that can be read: %2, that cannot: %3. The damaged file is kept.</source>
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
        <source>Opened a copy of “%1”. Save it to a file to keep changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is a copy and has changes that are in no file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop the changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ProjectStore</name>
    <message>
        <source>project not saved to a file</source>
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
        <source>no file chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — a copy, not saved to a file</source>
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
        <source>Force at the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At X %1, Y %2, Z %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suspected joint: %1, whose current left its target furthest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (%1 s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick what you have looked at.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asked; waiting for the robot…</source>
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
        <source>Number %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Int</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind of input register</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the input register</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value for the input register</source>
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
        <source>Show what the robot does now; a recording stays open in the plots</source>
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
        <source>It could not be closed from here: close it on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data from the robot: close it on the teach pendant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n more on the robot.</source>
        <translation>
            <numerusform>%n more on the robot.</numerusform>
            <numerusform>%n more on the robot.</numerusform>
        </translation>
    </message>
    <message>
        <source>A program that waits for it goes on once it is closed: keep clear of the arm.</source>
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
        <source>Safety is normal again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program error in line %1, column %2: %3</source>
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
        <source>No data from the robot. Reconnecting by itself; motion does not resume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data from the robot are late.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking control was ended by a stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program on the robot waits for an answer on the teach pendant: %1</source>
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
        <source>The gripper gives no values. Power the arm on; if it stays so, check the gripper&apos;s cable at the wrist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper answers again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper is active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper did not become active. See that nothing blocks its fingers, then press Activate again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper holds an object (%1 open)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper lost the object it held</source>
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
        <source>Nobody answers for the gripper at %1:%2. Install Robotiq&apos;s URCap on the robot and choose the gripper in its Installation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper does not answer. Check its cable at the wrist and its page in the robot&apos;s Installation; restart the robot if it stays so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection to the gripper was ended by the robot, which may be restarting. It comes back by itself; the gripper goes on holding.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper did not take it. Activate it; if it is active, look at its page in the robot&apos;s Installation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper is being activated: what was asked for is done afterwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper was sent somewhere before it was active. Press Activate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper is too hot. Let it cool down, then press Activate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper heard nothing for a second. Check its cable at the wrist, then press Activate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper has too little voltage. Set the tool&apos;s voltage to 24 V, then press Activate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper&apos;s automatic release is under way. Wait until it ends, then press Activate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper&apos;s automatic release has ended. Press Activate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper has an internal fault. Press Activate; if it comes again, ask Robotiq.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The activation failed. See that nothing blocks the fingers, then press Activate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper draws too much current. See that nothing blocks the fingers, then press Activate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gripper reports fault %1. Press Activate; if it comes again, see its manual.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::SceneDock</name>
    <message>
        <source>View</source>
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
        <source>Look from the first side, in perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the front: X of the base to the right, Z up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from the side: Y of the base to the right, Z up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from above: X of the base to the right, Y up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm, target and waypoints into the picture</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::SceneView</name>
    <message>
        <source>View of the arm</source>
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
        <source>ghost “%1” · reachable · largest turn %2 %3 · %4 s at %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag or use the arrow keys to look from another side, with Shift or the right button to move the picture, the wheel or plus and minus to come nearer, double click or Home for the first view. Nothing here moves the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 name hidden: come nearer</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n names hidden: come nearer</source>
        <translation>
            <numerusform>%n name hidden: come nearer</numerusform>
            <numerusform>%n names hidden: come nearer</numerusform>
        </translation>
    </message>
    <message>
        <source>ghost “%1” · reachable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ghost “%1” · %2 · largest turn %3 %4 · %5 s at %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” as it will be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>REPLAY</source>
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
        <source>%1 does not come in the same packets as the others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Derived</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These signals are more than a robot sends at once: take others away first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no row in this recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is too little memory for the history to show %1: choose more in the menu Layout.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be computed to its end: %2</source>
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
        <source>Signals of the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New: |F| [N] = norm(…)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal computed from others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A name, a unit in brackets if you like, and an expression over signals: drag them here for their names. norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), + − * / ^ and the usual functions. Return makes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: this robot does not send it.</source>
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
        <source>This robot is simulated. Nothing moves but pixels.</source>
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
        <source>Speed slider of the robot, 2 to 100 %</source>
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
        <source>Recording, session and last message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not saved</source>
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
        <source>Recording ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not recording</source>
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
        <source>Space / Esc
not an e-stop</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::StopPlot</name>
    <message>
        <source>Highest value %1 in the last five seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max %1</source>
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
        <source>A TCP needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is taken by another TCP. Choose another name.</source>
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
        <source>No TCP yet.
Press From robot to keep the one it has, or Teach… to find it with the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the flange. Return applies it to the project; the robot keeps its own.</source>
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
        <source>Keep the TCP the robot has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach the selected TCP again…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New TCP in figures</source>
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
        <source>No robot is connected. Connect one, or try the simulator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is the TCP the robot has.</source>
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
        <source>Select a TCP to set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the TCP “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is not under control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the TCP “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, from the flange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, as the robot has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 from the one the robot has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot has another TCP than “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the robot: %1. In the project: %2. They are %3 apart. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::TcpTeacher</name>
    <message>
        <source>Take pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the worst again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take</source>
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
        <source>Take a pose of the rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation of the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation from one pose: tool straight down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation from three poses: along +Z, towards +X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tip at %1. The poses agree within %2 (rms); pose %3 fits least, by %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool is turned too little between the poses. Take one more, tilted by 30° or more to another side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot sent no valid place. Take the poses again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jog the tip to a fixed, sharp point and take the pose. Then four times in all: the tip on the same point, the tool tilted each time to another side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Tilt the tool to another side, bring the tip to the same point again, and take the pose. Still needed: %n</source>
        <translation>
            <numerusform>Tilt the tool to another side, bring the tip to the same point again, and take the pose. Still needed: %n</numerusform>
            <numerusform>Tilt the tool to another side, bring the tip to the same point again, and take the pose. Still needed: %n</numerusform>
        </translation>
    </message>
    <message>
        <source>The tool keeps the rotation it has now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the tool until it points straight down and its X lies along X of the base; take it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation taken. Take it again to replace it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the tool where it stands now. From here on it must not turn: jog X, Y and Z only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the tool along its own +Z, away from the flange, at least %1, and take it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now to the side of its +X, at least %1, and take it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation taken: %1 along +Z, %2 beside it; the flange turned by %3 meanwhile, most at pose %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The flange turned by %1 on the way, most at pose %2. Take the three again without turning the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The way along +Z is only %1. Take the three again, at least %2 apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The way towards +X is only %1. Take the three again, at least %2 apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The three poses lie in a line: the third is only %1 beside it. Take the three again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot sent no valid place. Take the three again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the last again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take pose %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  ◀ fits least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poses can be taken while the robot sends data.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::TickLine</name>
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
        <source>TCP, payload or positions</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::TravelWatch</name>
    <message>
        <source>%1: %2 left, then %3 is at its limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 left, then the end of the reach or a singularity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 left to the plane the base stands on</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::ViewCard</name>
    <message>
        <source>Fold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view is too small to unfold this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unfold</source>
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
        <source>Frame of the waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frame it is given in and moves with. The place stays where it is. —: the joints rule</source>
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
        <source>%1 from the live pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>joints rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pose rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the waypoint&apos;s frame. Return applies it; nothing moves but the waypoint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>corner of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>home, “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the keys of Go through in place of the figures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the figures in place of the keys of Go through.</source>
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
    <message numerus="yes">
        <source>Move %n waypoints</source>
        <translation>
            <numerusform>Move %n waypoint</numerusform>
            <numerusform>Move %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>Change the pattern “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teach the three corners of the pattern first, and select them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the pattern “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dissolve the pattern “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a place of a pattern.</source>
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
        <source>The frame it was given in then is not in the project any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take an earlier “%1” back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoints (*.csv *.txt *.json *.tiller);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comma separated (*.csv);;JSON (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is too large for a list of waypoints.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no waypoints in %1.</source>
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
        <source>There are no waypoints to export.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was exported</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints written to %1</source>
        <translation>
            <numerusform>%n waypoint written to %1</numerusform>
            <numerusform>%n waypoints written to %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Select waypoints where something is to be done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Change the actions at %n waypoints</source>
        <translation>
            <numerusform>Change the actions at %n waypoint</numerusform>
            <numerusform>Change the actions at %n waypoints</numerusform>
        </translation>
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
        <source>Nothing was pasted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no waypoints on the clipboard.</source>
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
        <source>Changes, the newest first</source>
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
        <source>Go back to before this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name: “%1”, now “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place: it has moved by %1 (%2, base frame)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints: %1 turned most, by %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the joints rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a frame that is no more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame: %1, now %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move: MoveL, now MoveJ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move: MoveJ, now MoveL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of MoveJ: %1, now %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of MoveL: %1, now %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend: %1, now %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP: taught with another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group: “%1”, now “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour: %1, now %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note: “%1”, now “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions: others than now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was not changed since it was taught.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before this it was as it is now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before this it was:</source>
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
        <source>A joint would leave its range. Touch the waypoint up from another arm posture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its frame is not in this project. Choose another frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The straight line from here leaves the arm&apos;s reach. Use MoveJ, or start elsewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of reach. Touch it up nearer to the base.</source>
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
        <source>MoveL: the TCP goes along a straight line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The joints rule: the arm comes back in the same posture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pose rules: it moves with its frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Can be reached</source>
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
        <source>A waypoint needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is taken by waypoint %2. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make “%1” a MoveJ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make “%1” a MoveL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use joint positions for “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no frame “%1” in this project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give “%1” in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is outside %2 to %3.</source>
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
        <source>The arm cannot get there. “%1” stays as it was.</source>
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
        <source>Name %1, the coming one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done there: %1</source>
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
        <source>Only what is ticked is changed.</source>
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
        <source>Speed of MoveJ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of MoveL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
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
    <message numerus="yes">
        <source>Move %n waypoints</source>
        <translation>
            <numerusform>Move %n waypoint</numerusform>
            <numerusform>Move %n waypoints</numerusform>
        </translation>
    </message>
    <message>
        <source>Kind of move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
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
        <source>Tool, each its own</source>
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
        <source>By X, Y, Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About or along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm cannot get there: %1. Nothing would be moved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A frame is missing. Choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n of them would be out of reach; they are kept, and marked.</source>
        <translation>
            <numerusform>%n of them would be out of reach; it is kept, and marked.</numerusform>
            <numerusform>%n of them would be out of reach; they are kept, and marked.</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirrored at the plane through the origin that the axis stands upon. The tool approaches from the mirrored side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All stay in reach.</source>
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
Jog the arm to a place and press Teach here (T).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s data are old. Wait until they come again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is connected. Connect one, or try the simulator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a waypoint to go to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm is not under control. Take control first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the place where the arm stands, after the selection (T)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace the selected place by where the arm stands (U)</source>
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
        <source>The frame of “%1” is not in this project. Choose another frame first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The live place is %1 away (%2, base frame). Largest joint change: %3 %4.</source>
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
        <source>Offset, turn or mirror…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the pattern&apos;s places ordinary waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the pattern and its waypoints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions there…</source>
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
</context>
<context>
    <name>tiller::app::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search a command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not possible now</source>
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
        <source>An address has four numbers of 0 to 255, as in 192.168.0.10.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A host name has letters, digits, dots and hyphens only.</source>
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
        <source>A simulated UR5e inside this program. Everything works, nothing can be hurt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the simulated robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect a robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address or host name of the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name shown for the robot</source>
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
        <source>Robots connected to before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before you move a real arm: keep everybody out of its reach, have the emergency stop at hand, check payload and TCP, start slowly. The STOP of this window is not an emergency stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoints from a file, without a robot: everything but moving works.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the selected robot off this list (Delete). Nothing is changed on the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With a sample project…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts the simulated robot, and opens a project that is taught already.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::Demonstration</name>
    <message>
        <source>make the folder %1: choose one that may be written to</source>
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
        <source>let go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>teach the second waypoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the first waypoint (held)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>let go of Go to</source>
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
        <source>write the screenshots to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stop recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: did not happen within %2 s (%3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot reports no reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pressed anew         %1 times: the motion had stopped before the key was let go</source>
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
        <source>there is no key &quot;%1&quot; in the window</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::DeviceSettings</name>
    <message>
        <source>Device that moves the arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try it out…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What each device says now, and which way it will go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the arm</source>
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
        <source>Dead zone of the %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So far a stick may be out without moving anything.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve of the %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exponent </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1: even. Higher: gentle near the middle, fast at the end of the way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the axis that is out furthest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: only the axis that is out furthest</source>
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
        <source>No gamepad and no SpaceMouse is there. Plug one in: it appears by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only while its dead-man is held. It is not remembered: after a start no device moves the arm.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::DockStage</name>
    <message>
        <source>No panel is here. Choose a perspective at the lower right, or show a panel with the menu View.</source>
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
        <source>&lt;h2&gt;Moving the arm&lt;/h2&gt;&lt;p&gt;The arm moves while a key of the pad is held, and stops when it is let go. It also stops when&lt;/p&gt;&lt;ul&gt;&lt;li&gt;the pointer leaves the key, a second button is pressed, or another hand joins in;&lt;/li&gt;&lt;li&gt;a modifier, or a key that contradicts, goes down beside a held key of the keyboard;&lt;/li&gt;&lt;li&gt;the window loses the focus, anything opens over it, or another frame, speed, step or tab is chosen;&lt;/li&gt;&lt;li&gt;data from the robot are late, this program hangs, the robot leaves Running, or its safety mode or Remote control;&lt;/li&gt;&lt;li&gt;the screen is locked, the PC goes to sleep, or the device is unplugged or falls silent;&lt;/li&gt;&lt;li&gt;nobody can prove that the key is still held: on X11 the display server is asked a hundred times a second whether the button or key is down, and a “no”, or no answer for 100 ms, ends the motion. Where nobody can be asked, header and Settings say so;&lt;/li&gt;&lt;li&gt;it has been held for long: a jog for %1 s (Settings), Freedrive for five minutes, a move to a place for 5 s more than it takes. The last 3 s are counted down.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;A stopped motion needs a new press. &lt;b&gt;Space&lt;/b&gt; and &lt;b&gt;Esc&lt;/b&gt; stop from everywhere, programs of others too. This is a software stop, not an emergency stop: keep the emergency stop within reach.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; makes a press ten times finer, &lt;b&gt;Shift&lt;/b&gt; three times faster, never above the cap. On a keyboard without Latin letters a letter below means its place on a US keyboard.&lt;/p&gt;&lt;h2&gt;Commands&lt;/h2&gt;</source>
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
        <source>&lt;h2&gt;The manual is not on this computer&lt;/h2&gt;&lt;p&gt;It comes with the Debian package of Tiller. A Tiller that you built yourself has it when the package python3-sphinx is installed:&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;Then build again. Until then its pages can be read as text in the folder packaging/manual of the sources. The rules of jogging and all keys are on the other page of this window.&lt;/p&gt;</source>
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
        <source>Speed cap and longest hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys of the commands</source>
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
        <source>Names and scales of inputs and outputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything else</source>
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
        <source>What is ticked is replaced by what %1 holds:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is ticked is replaced by what %1, written by Tiller %2, holds:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the same already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: none in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 here, %3 in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is replaced is kept in a file of its own, which can be imported again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing in the file that is not here already.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::Lessons</name>
    <message>
        <source>First steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A checklist in the view: from power on to a recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Five tasks on the simulated robot, each with a check.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice is for the simulated robot of this program alone. This is “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Practice: put “%1”</source>
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
        <source>Keyboard jogging armed: arrows move X and Y, PgUp and PgDn move Z, with Alt they turn, 1 to 6 with + and − turn a joint. Space and Esc stop.</source>
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
        <source>%1 has gone silent while it moved the arm, which was stopped. Let go of it; if it stays silent, plug it in again.</source>
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
        <source>Opens waypoints and frames from a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves to this file now, and every change from now on.</source>
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
        <source>Brings this tab to the front.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes it a window of its own, for a second screen, or puts it back.</source>
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
        <source>Changes the colours at once and remembers it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds a command by its name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours, sizes, units, the speed cap, devices, and the key of every command.</source>
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
        <source>Name of the program on the robot, as the tablet shows it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the program on the robot, as in pick.urp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed cap %1</source>
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
        <source>A copy of one of three projects, to try on the simulated robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show gripper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brings the gripper&apos;s page of I/O to the front.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All panels back to where the current perspective has them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero the force in the plots, or show it as measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counts the TCP force from what it is now; once more: as the robot measures it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One file with everything that is remembered, for another computer or as a copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes over what such a file holds; says first what it replaces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves this panel to that side of the others.</source>
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
        <source>A recording is running. End it first: nothing of it shall be missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waypoints, Frames, Tools, I/O, Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n boxes or planes of the cell are not known to the simulated robot: it has no room for more.</source>
        <translation>
            <numerusform>%n box or plane of the cell is not known to the simulated robot: it has no room for more.</numerusform>
            <numerusform>%n boxes or planes of the cell are not known to the simulated robot: it has no room for more.</numerusform>
        </translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One file with versions, log and settings for whoever helps; shows first what is in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiller ended unexpectedly the last time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it was doing then was kept. Save it as a report for whoever helps you.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The manual at the page of what has the focus, all commands with their keys, and the rules of jogging.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::PanelDock</name>
    <message>
        <source>Put back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back into the main window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes this panel. The menu View brings it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move, float or close %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: move, float or close this panel. Drag: take it elsewhere.</source>
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
        <source>The panels as they stand now, into the current perspective.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This perspective is built in. Save it under a name of your own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save perspective as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The panels as they stand now, under a name of your own.</source>
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
        <source>Gives the current perspective another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This perspective is built in and keeps its name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete perspective…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forgets the current perspective. The panels stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This perspective is built in and stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspective %1. Choose how the panels stand, or save how they stand now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the perspective</source>
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
        <source>Keep it</source>
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
        <source>Shows the view, the waypoints beside it and the plots below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows inputs and outputs, a smaller view beside them and higher plots below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the plots alone, as large as the window allows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the panels as you saved them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The perspective “%1” cannot be shown: its layout in the settings is damaged. Arrange the panels and save it anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name is too long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are as many perspectives as can be kept. Delete one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a perspective of this name. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The panels stand as in the perspective “%1”: the layout of the earlier version does not fit this one. Arrange them anew; it is remembered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The panels stand as in the perspective “%1”: the layout in the settings is damaged or of another version. Arrange them anew; it is remembered.</source>
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
        <source>Pattern of the file name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{date}, {time}, {robot} and {number} are filled in when a recording begins.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One row every so many packets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
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
        <source>One row every</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For example %1. {date}, {time}, {robot} and {number} are filled in; a file that is there is never replaced.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n packet(s) a row: %1 rows a second from a robot that sends 500 packets a second.</source>
        <translation>
            <numerusform>%n packet a row: %1 rows a second from a robot that sends 500 packets a second.</numerusform>
            <numerusform>%n packets a row: %1 rows a second from a robot that sends 500 packets a second.</numerusform>
        </translation>
    </message>
    <message>
        <source>Format of a recording</source>
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
        <source>Megabytes of the disk that stay free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recording ends in order, and is whole, before less of the disk is free.</source>
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
</context>
<context>
    <name>tiller::app::ReportDialog</name>
    <message>
        <source>With names and addresses of robots, inputs, outputs and files</source>
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
        <source>What did you do, what did you expect, what happened?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files of the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What this file says</source>
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
        <source>One file with what somebody who helps you needs to know. Below is all that will be in it. It is saved where you choose; Tiller sends it nowhere.</source>
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
        <source>Each is taught for a UR5e and can be gone through with the simulated robot. You work on a copy: saving asks for a file of your own.</source>
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
        <source>Look and motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
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
        <source>Size of keys and rows</source>
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
        <source>Lengths</source>
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
        <source>Rotations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll, pitch, yaw in degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation vector in radians, as scripts write it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed cap of this program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How lengths, speeds of the TCP and orientations are shown and typed. Plots and files keep metres, millimetres and degrees.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed cap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Above %1. Nothing else limits a jog from a PC: neither manual mode nor the enabling device of the pendant. The header says so, and it ends with the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No motion of this program gets above it, at the TCP and at the elbow. It holds at once and stops what moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys of the commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore default shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the new key in the field; Backspace takes it away. Space and Esc always stop the arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stops the arm and nothing else.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 belongs to &quot;%2&quot;. Take it away there first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After this time a jog ends and its key has to be pressed again. Freedrive has five minutes, a move to a place the time it takes and 5 s.</source>
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
        <source>One file with everything that is remembered, for another computer or as a copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes over what such a file holds; says first what it replaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch: as high as a finger needs. In a window lower than %1 px the keys of joints, tabs and title bars stay smaller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text, keys, rows, plots and the view, all alike.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds at the next start of Tiller. The screen has room for %1 % only, which it will have there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds at the next start of Tiller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the window anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the arm, gives control back and connects again; what the plots show begins anew. The project is saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the window and of the checks. Files and scripts are the same in all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds at the next start of Tiller, or once the window is opened anew.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsTransfer</name>
    <message>
        <source>Settings of Tiller (*.json)</source>
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
        <source>Settings imported from %1. What was here before is in %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
