<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>ActionStep</name>
    <message>
        <source>No gripper is configured for this robot. Select a gripper under I/O &gt; Gripper.</source>
        <translation>此机器人未配置夹爪。请在“I/O &gt; 夹爪”中选择。</translation>
    </message>
    <message>
        <source>Run route</source>
        <translation>运行路线</translation>
    </message>
    <message>
        <source>%1 did not turn on within %2 s. Check the connected device, then try again.</source>
        <translation>%1 未在 %2 s 内接通。请检查所连接的设备，然后重试。</translation>
    </message>
    <message>
        <source>%1 did not turn off within %2 s. Check the connected device, then try again.</source>
        <translation>%1 未在 %2 s 内断开。请检查所连接的设备，然后重试。</translation>
    </message>
    <message>
        <source>The action “%1” was not completed. %2</source>
        <translation>动作“%1”未完成。%2</translation>
    </message>
    <message>
        <source>The gripper did not stop moving within %1 s. Check the gripper, then try again.</source>
        <translation>夹爪未在 %1 s 内停下。请检查夹爪，然后重试。</translation>
    </message>
</context>
<context>
    <name>ActionTable</name>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Power and safety</source>
        <translation>电源与安全</translation>
    </message>
    <message>
        <source>Control and programs</source>
        <translation>控制与程序</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>路点</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>I/O</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Perspectives</source>
        <translation>视角布局</translation>
    </message>
    <message>
        <source>Move panels</source>
        <translation>移动面板</translation>
    </message>
    <message>
        <source>Application</source>
        <translation>应用程序</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Program steps</source>
        <translation>程序步骤</translation>
    </message>
</context>
<context>
    <name>ActionWords</name>
    <message>
        <source>%1 on</source>
        <translation>%1 接通</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1 断开</translation>
    </message>
    <message>
        <source>%1 on for %2 s</source>
        <translation>%1 接通 %2 s</translation>
    </message>
    <message>
        <source>%1 off for %2 s</source>
        <translation>%1 断开 %2 s</translation>
    </message>
    <message>
        <source>Wait until %1 is on (max. %2 s)</source>
        <translation>等待 %1 接通（最长 %2 s）</translation>
    </message>
    <message>
        <source>Wait until %1 is off (max. %2 s)</source>
        <translation>等待 %1 断开（最长 %2 s）</translation>
    </message>
    <message>
        <source>Wait until %1 is on</source>
        <translation>等待 %1 接通</translation>
    </message>
    <message>
        <source>Wait until %1 is off</source>
        <translation>等待 %1 断开</translation>
    </message>
    <message>
        <source>Wait %1 s</source>
        <translation>等待 %1 s</translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation>打开夹爪</translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation>关闭夹爪</translation>
    </message>
    <message>
        <source>Set an output</source>
        <translation>设置输出</translation>
    </message>
    <message>
        <source>Pulse an output</source>
        <translation>输出脉冲</translation>
    </message>
    <message>
        <source>Wait for an input</source>
        <translation>等待输入</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>等待</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Jog, teach, run and monitor a Universal Robots arm from a PC.</source>
        <translation>从 PC 点动、示教、运行和监视优傲机器人的机械臂。</translation>
    </message>
    <message>
        <source>Start with the built-in simulated UR5e.</source>
        <translation>以内置的模拟 UR5e 启动。</translation>
    </message>
    <message>
        <source>Connect to the robot at this address or host name.</source>
        <translation>连接此地址或主机名的机器人。</translation>
    </message>
    <message>
        <source>Run the scripted demonstration on the simulated robot, write its files to this folder, and exit.</source>
        <translation>在模拟机器人上运行演示脚本，将文件写入此文件夹，然后退出。</translation>
    </message>
    <message>
        <source>Open this project file (.tiller).</source>
        <translation>打开此项目文件 (.tiller)。</translation>
    </message>
    <message>
        <source>Colour theme: light or dark.</source>
        <translation>配色：light（浅色）或 dark（深色）。</translation>
    </message>
    <message>
        <source>see tiller --help</source>
        <translation>见 tiller --help</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>意外的参数 &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--theme must be light or dark, not &quot;%1&quot;</source>
        <translation>--theme 只接受 light 或 dark，而不是 &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--robot and --simulator cannot be combined</source>
        <translation>--robot 与 --simulator 不能同时使用</translation>
    </message>
    <message>
        <source>--demo works only on the simulated robot and cannot be combined with --robot</source>
        <translation>--demo 只能在模拟机器人上运行，不能与 --robot 一起使用</translation>
    </message>
    <message>
        <source>--demo requires a folder</source>
        <translation>--demo 需要一个文件夹</translation>
    </message>
    <message>
        <source>--robot requires an address, e.g. --robot 192.168.0.10</source>
        <translation>--robot 需要一个地址，例如 --robot 192.168.0.10</translation>
    </message>
    <message>
        <source>only one project can be opened; remove &quot;%1&quot;</source>
        <translation>只能打开一个项目，不能再打开 &quot;%1&quot;</translation>
    </message>
    <message>
        <source>Monitor only: do not change anything on the robot; STOP still works. Cannot be turned off in Settings.</source>
        <translation>仅监视：不更改机器人的任何状态，STOP 仍然有效。无法在设置中关闭。</translation>
    </message>
    <message>
        <source>--demo moves the simulated robot and cannot be combined with --monitor-only</source>
        <translation>--demo 会移动模拟机器人，不能与 --monitor-only 同时使用</translation>
    </message>
    <message>
        <source>Open these recordings in the plots.</source>
        <translation>在曲线图中打开这些录制。</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>Joint positions</source>
        <translation>关节位置</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>TCP 位置</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>关节电流</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>TCP 力</translation>
    </message>
    <message>
        <source>%1: not compared</source>
        <translation>%1：未比较</translation>
    </message>
    <message>
        <source>%1: no values</source>
        <translation>%1：没有数值</translation>
    </message>
    <message>
        <source>%1: within %2 at all times, maximum %3 at %4 s</source>
        <translation>%1：始终在 %2 之内，最大 %3（%4 s）</translation>
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
        <translation>机械臂与模型在 %1 s 出现偏差：%2 偏差 %3</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the TCP deviates by %2</source>
        <translation>机械臂与模型在 %1 s 出现偏差：TCP 偏差 %2</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the current of %2 deviates by %3</source>
        <translation>机械臂与模型在 %1 s 出现偏差：%2 的电流偏差 %3</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: a force of %2 acts on the TCP</source>
        <translation>机械臂与模型在 %1 s 出现偏差：有 %2 的力作用在 TCP 上</translation>
    </message>
    <message>
        <source>The motion matches the model of a %1</source>
        <translation>运动与 %1 的模型一致</translation>
    </message>
    <message>
        <source>Nothing to compare: the arm was powered off or guided by hand for the whole recording.</source>
        <translation>无可比较内容：整个录制期间机械臂未上电或被手动引导。</translation>
    </message>
    <message>
        <source>The arm deviates from the model from the start of the recording. Check the payload and the robot model, and check whether something was touching the arm.</source>
        <translation>机械臂与模型从录制开始就不一致。请检查有效负载、机器人型号以及当时是否有东西触碰机械臂。</translation>
    </message>
    <message>
        <source>From this time on, the arm was pushed or held, its payload differed, or a joint did not follow its target.</source>
        <translation>从该时刻起，机械臂被推动或挡住，有效负载不同，或某个关节没有跟随目标。</translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: its sampling interval is too long. Record every packet.</source>
        <translation>此记录无法与模型比较：行间隔过大。请记录每个数据包。</translation>
    </message>
    <message>
        <source>Not compared with the arm model.</source>
        <translation>未与机械臂模型比较。</translation>
    </message>
    <message>
        <source>The compared values match the model of a %1; other values were not recorded</source>
        <translation>所比较的数值与 %1 的模型一致；其他数值未记录</translation>
    </message>
    <message>
        <source>The recorded arm is a %1, but it was compared with the model of a %2</source>
        <translation>记录的手臂是 %1，但与 %2 的模型进行了比较</translation>
    </message>
    <message>
        <source>No deviation from the model of a %1, but the recorded values may fit other models too</source>
        <translation>与 %1 的模型没有偏差，但记录的值也可能符合其他型号</translation>
    </message>
    <message>
        <source>Compare the recording with the model of a %1.</source>
        <translation>请将记录与 %1 的模型进行比较。</translation>
    </message>
    <message>
        <source>%1: not compared because the recording has no %2; record all signals to an MCAP file</source>
        <translation>%1：未比较，记录中没有 %2；请将所有信号记录为 MCAP</translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: target or actual joint positions are missing. Record all signals to an MCAP file.</source>
        <translation>此记录无法与模型比较：缺少关节的指令或位置。请将所有信号记录为 MCAP。</translation>
    </message>
    <message>
        <source>%1: exceeds %2 starting at %3 s (%4), maximum %5 at %6 s</source>
        <translation>%1：自 %3 s 起超过 %2（%4），最大 %5（%6 s）</translation>
    </message>
</context>
<context>
    <name>ControllerCodes</name>
    <message>
        <source>Near a joint limit</source>
        <translation>接近关节极限</translation>
    </message>
    <message>
        <source>A joint came close to its limit.</source>
        <translation>某个关节接近其范围的末端。</translation>
    </message>
    <message>
        <source>Jog the joint away from the limit, or change the waypoint.</source>
        <translation>将关节点动离开极限，或更改路点。</translation>
    </message>
    <message>
        <source>Near a tool orientation limit</source>
        <translation>接近工具方向极限</translation>
    </message>
    <message>
        <source>The tool orientation came close to the limit set in the safety configuration.</source>
        <translation>工具转到了安全配置所设极限附近。</translation>
    </message>
    <message>
        <source>Rotate the tool away from the limit, or change the waypoint.</source>
        <translation>把工具转回来，或更改路点。</translation>
    </message>
    <message>
        <source>Near a safety plane</source>
        <translation>接近安全平面</translation>
    </message>
    <message>
        <source>The arm came close to a safety plane.</source>
        <translation>机械臂接近了安全平面。</translation>
    </message>
    <message>
        <source>Jog away from the plane, or change the waypoint.</source>
        <translation>点动离开该平面，或更改路点。</translation>
    </message>
    <message>
        <source>Position deviates from path</source>
        <translation>位置偏离路径</translation>
    </message>
    <message>
        <source>The arm is not at the commanded position.</source>
        <translation>机械臂不在指令位置。</translation>
    </message>
    <message>
        <source>Check for obstacles; check payload, centre of gravity and mounting; reduce the acceleration.</source>
        <translation>检查是否有障碍物；检查有效负载、重心和安装；降低加速度。</translation>
    </message>
    <message>
        <source>Singularity</source>
        <translation>奇异点</translation>
    </message>
    <message>
        <source>The linear move passes through a singularity of the arm.</source>
        <translation>直线动作经过机械臂的奇异位置。</translation>
    </message>
    <message>
        <source>Jog individual joints away from the singularity. Use MoveJ to pass through the region.</source>
        <translation>逐个点动关节离开奇异点；在此区域使用 MoveJ。</translation>
    </message>
    <message>
        <source>Cannot hold position</source>
        <translation>无法保持位置</translation>
    </message>
    <message>
        <source>The arm sagged or was pushed while at standstill.</source>
        <translation>机械臂静止时下沉或被推动。</translation>
    </message>
    <message>
        <source>Check payload, centre of gravity and mounting.</source>
        <translation>检查有效负载、重心和安装。</translation>
    </message>
    <message>
        <source>Wrong payload or mounting</source>
        <translation>有效负载或安装错误</translation>
    </message>
    <message>
        <source>The measured forces do not match the payload, or the arm was pushed when Freedrive started.</source>
        <translation>测得的力与有效负载不符，或自由驱动开始时机械臂被推动。</translation>
    </message>
    <message>
        <source>Collision detected by a joint</source>
        <translation>关节检测到碰撞</translation>
    </message>
    <message>
        <source>A joint required more torque than expected for the motion.</source>
        <translation>某个关节所需的力矩超出运动所需。</translation>
    </message>
    <message>
        <source>Remove the obstacle. If the arm did not touch anything, check the payload.</source>
        <translation>移除障碍物；若没有障碍物，检查有效负载。</translation>
    </message>
    <message>
        <source>Collision detected at the tool</source>
        <translation>检测到工具处碰撞</translation>
    </message>
    <message>
        <source>The force at the tool exceeded the limit.</source>
        <translation>工具处的力超过允许值。</translation>
    </message>
    <message>
        <source>Position deviation</source>
        <translation>位置偏差</translation>
    </message>
    <message>
        <source>A joint deviated from its commanded position.</source>
        <translation>某个关节离开了指令位置。</translation>
    </message>
    <message>
        <source>Check for obstacles, and check payload and mounting.</source>
        <translation>检查障碍物，并检查有效负载和安装。</translation>
    </message>
    <message>
        <source>Too many protective stops</source>
        <translation>保护性停止过多</translation>
    </message>
    <message>
        <source>One joint had fifty protective stops within eight hours.</source>
        <translation>一个关节在八小时内发生了五十次保护性停止。</translation>
    </message>
    <message>
        <source>Find and correct the cause of the stops, then restart the controller.</source>
        <translation>请查明并排除停止的原因，然后重新启动控制器。</translation>
    </message>
    <message>
        <source>Sudden change in target position</source>
        <translation>目标位置突变</translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in position.</source>
        <translation>程序指令了位置跳变。</translation>
    </message>
    <message>
        <source>Start the program at the current position of the arm, and send servo targets in small steps.</source>
        <translation>请从机械臂的当前位置启动程序，并保持较小的伺服步长。</translation>
    </message>
    <message>
        <source>Sudden change in target speed</source>
        <translation>目标速度突变</translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in speed.</source>
        <translation>程序指令了速度跳变。</translation>
    </message>
    <message>
        <source>Reduce the acceleration, or smooth the path.</source>
        <translation>降低加速度，或使路径平滑。</translation>
    </message>
    <message>
        <source>Protective stop requested by a program</source>
        <translation>程序请求的保护性停止</translation>
    </message>
    <message>
        <source>The running program requested the stop.</source>
        <translation>正在运行的程序请求了停止。</translation>
    </message>
    <message>
        <source>See the preceding program messages in the log.</source>
        <translation>请在日志中查看程序此前的消息。</translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation>机器人处于本地控制</translation>
    </message>
    <message>
        <source>A script was sent, but the robot accepts commands only from its teach pendant.</source>
        <translation>已发送脚本，但机器人只接受来自示教器的命令。</translation>
    </message>
    <message>
        <source>Switch to Remote control on the teach pendant.</source>
        <translation>在示教器上切换到远程控制。</translation>
    </message>
    <message>
        <source>Controller message C%1</source>
        <translation>控制器消息 C%1</translation>
    </message>
    <message>
        <source>Tiller has no description of this message code.</source>
        <translation>Tiller 没有此消息代码的说明。</translation>
    </message>
    <message>
        <source>Look up C%1 in the manufacturer&apos;s error code directory.</source>
        <translation>在制造商的错误代码目录中查找 C%1。</translation>
    </message>
    <message>
        <source>Correct the payload and the mounting, and do not push the arm when Freedrive starts.</source>
        <translation>更正有效负载和安装，并且在自由驱动开始时不要推动机械臂。</translation>
    </message>
</context>
<context>
    <name>DerivedSignal</name>
    <message>
        <source>compute a signal</source>
        <translation>计算信号</translation>
    </message>
    <message>
        <source>The signal “%1” does not exist. See the signal list for the names.</source>
        <translation>没有信号“%1”。名称见信号列表。</translation>
    </message>
    <message>
        <source>The expression contains no signal. Add the name of a signal.</source>
        <translation>表达式不包含信号。请添加信号名称。</translation>
    </message>
    <message>
        <source>The expression contains too many signals. Use fewer signals.</source>
        <translation>表达式包含的信号过多。请减少信号。</translation>
    </message>
    <message>
        <source>The expression must evaluate to one number.</source>
        <translation>表达式的结果必须是一个数。</translation>
    </message>
    <message>
        <source>The text is too long. Use a shorter name or expression.</source>
        <translation>文本过长。请使用更短的名称或表达式。</translation>
    </message>
    <message>
        <source>Enter a name, an equals sign and an expression, for example |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</source>
        <translation>请输入名称、等号和表达式，例如 |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</translation>
    </message>
    <message>
        <source>Too many equals signs. Use == to compare values.</source>
        <translation>等号过多。比较请使用 ==</translation>
    </message>
    <message>
        <source>The functions are nested too deeply. Use at most %1 levels.</source>
        <translation>函数嵌套过深。最多使用 %1 层。</translation>
    </message>
    <message>
        <source>The closing parenthesis of “%1” is missing.</source>
        <translation>“%1”缺少右括号。</translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression, a cut-off frequency in Hz and optionally the order (1 to 8), for example %1(actual_q_0, 10, 2).</source>
        <translation>“%1”需要一个信号或表达式、以 Hz 为单位的截止频率，以及可选的阶数（1 至 8），例如 %1(actual_q_0, 10, 2)。</translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression and a time window in seconds, for example %1(actual_q_0, 0.5).</source>
        <translation>“%1”需要一个信号或表达式，以及以秒为单位的时间窗口，例如 %1(actual_q_0, 0.5)。</translation>
    </message>
    <message>
        <source>The cut-off frequency of “%1” must be between %2 and %3 Hz.</source>
        <translation>“%1”的截止频率必须在 %2 至 %3 Hz 之间。</translation>
    </message>
    <message>
        <source>The time window of “%1” must be between 0.001 and 60 seconds.</source>
        <translation>“%1”的时间窗口必须在 0.001 至 60 秒之间。</translation>
    </message>
    <message>
        <source>The function “%1” does not exist.</source>
        <translation>函数“%1”不存在。</translation>
    </message>
    <message>
        <source>“%1” contains a decimal comma. Write decimal numbers with a point: %2</source>
        <translation>“%1”包含小数逗号。请用小数点书写小数：%2</translation>
    </message>
</context>
<context>
    <name>DeviceTrainer</name>
    <message>
        <source>%1 in %2</source>
        <translation>%2 中的 %1</translation>
    </message>
    <message>
        <source>Device axes</source>
        <translation>设备的轴</translation>
    </message>
</context>
<context>
    <name>Doctor</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 以及另外 %2</translation>
    </message>
    <message>
        <source>The robot&apos;s software is too old. Update the software to %1.%2 or newer.</source>
        <translation>机器人的软件版本过旧。请更新到 %1.%2 或更高版本。</translation>
    </message>
    <message>
        <source>Some values and the control registers are missing. Update the robot&apos;s software to %1.%2 or newer.</source>
        <translation>缺少一些数值和用于控制的寄存器。请将机器人更新到 %1.%2 或更新版本。</translation>
    </message>
    <message>
        <source>Inspect the arm and remove the cause. Then press “Recover…” in the Tiller header, or use the teach pendant.</source>
        <translation>检查机械臂，消除原因，然后恢复：按页眉中的“恢复…”，或使用示教器。</translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes, with the button in the Tiller header or on the teach pendant.</source>
        <translation>用 Tiller 页眉中的按钮或在示教器上给机械臂上电并松开制动器。</translation>
    </message>
    <message>
        <source>the RTDE port accepts connections but does not respond</source>
        <translation>RTDE 端口接受连接但不应答</translation>
    </message>
    <message>
        <source>the service on port %1 does not use RTDE</source>
        <translation>端口 %1 上的服务不使用 RTDE</translation>
    </message>
    <message>
        <source>Too many RTDE clients are connected, or the controller has stopped responding. Close other programs, then restart the controller.</source>
        <translation>RTDE 客户端过多，或控制器没有响应：请关闭其他程序，然后重启控制器。</translation>
    </message>
    <message>
        <source>Check the address. The address may belong to another device, or another program may be using the port.</source>
        <translation>检查地址：这是另一台设备，或端口被其他程序占用。</translation>
    </message>
    <message>
        <source>protocol version %1</source>
        <translation>协议版本 %1</translation>
    </message>
    <message>
        <source>another program uses %1</source>
        <translation>另一个程序正在使用 %1</translation>
    </message>
    <message>
        <source>Close the other program that controls this robot (another Tiller window, ROS, ur_rtde).</source>
        <translation>结束控制此机器人的另一个程序（另一个窗口、ROS、ur_rtde）。</translation>
    </message>
    <message>
        <source>this software version has no registers 24 to 47</source>
        <translation>此软件版本没有寄存器 24 至 47</translation>
    </message>
    <message>
        <source>Update the robot&apos;s software to 3.9, 5.3 or newer.</source>
        <translation>将机器人软件更新到 3.9、5.3 或更高版本。</translation>
    </message>
    <message>
        <source>registers 24 to 47 are free</source>
        <translation>寄存器 24 至 47 空闲</translation>
    </message>
    <message>
        <source>a fieldbus adapter or another program uses %1</source>
        <translation>现场总线适配器或另一个程序占用 %1</translation>
    </message>
    <message>
        <source>No action needed for jogging. To use these registers, disable EtherNet/IP, PROFINET or MODBUS in the robot&apos;s installation.</source>
        <translation>点动无需处理。要使用这些寄存器，请在机器人的安装设置中关闭 EtherNet/IP、PROFINET 或 MODBUS。</translation>
    </message>
    <message>
        <source>registers 0 to 23 are free</source>
        <translation>寄存器 0 至 23 空闲</translation>
    </message>
    <message>
        <source>the robot accepts the subscription but sends no data</source>
        <translation>机器人接受订阅但不发送数据</translation>
    </message>
    <message>
        <source>Close other RTDE programs, then restart the robot&apos;s controller.</source>
        <translation>关闭其他 RTDE 程序，然后重启机器人的控制器。</translation>
    </message>
    <message>
        <source>%1 of %2 packets per second</source>
        <translation>每秒 %1 / %2 个数据包</translation>
    </message>
    <message>
        <source>Packets are missing. Use a cable instead of a wireless link, and close other programs that put load on the robot or this PC.</source>
        <translation>缺少数据包。请使用网线而不是无线，并关闭给机器人或本 PC 造成负载的其他程序。</translation>
    </message>
    <message>
        <source>priority %1</source>
        <translation>优先级 %1</translation>
    </message>
    <message>
        <source>the system does not grant this user real-time priority</source>
        <translation>系统未授予此用户实时优先级</translation>
    </message>
    <message>
        <source>CPUs may enter deep sleep states, which delay real-time loops</source>
        <translation>CPU 可能进入深度睡眠状态，使实时循环延迟</translation>
    </message>
    <message>
        <source>TCP %1 mm from the flange, payload %2 kg</source>
        <translation>TCP 距法兰 %1 mm，有效负载 %2 kg</translation>
    </message>
    <message>
        <source>If a tool is mounted, set the TCP and the payload in the robot&apos;s installation: a wrong payload causes protective stops and makes the arm drift in Freedrive.</source>
        <translation>如果装有工具，请在机器人的安装设置中设定 TCP 和有效负载：错误的有效负载会引起保护性停止，并使机械臂在自由驱动时漂移。</translation>
    </message>
    <message>
        <source>“%1” is not a valid address, and no host with this name was found</source>
        <translation>&quot;%1&quot; 不是有效地址，也未找到同名主机</translation>
    </message>
    <message>
        <source>Enter the IP address shown on the teach pendant under About, or ask your network administrator for the host name.</source>
        <translation>输入示教器“关于”中显示的 IP 地址，或向网络管理员询问主机名。</translation>
    </message>
    <message>
        <source>%1 does not respond</source>
        <translation>%1 不应答</translation>
    </message>
    <message>
        <source>no network route to %1</source>
        <translation>没有到 %1 的网络路由</translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and no firewall blocks the connection.</source>
        <translation>检查机器人是否已开机、网线是否插好，以及防火墙是否阻止连接。</translation>
    </message>
    <message>
        <source>Assign this PC an address in the robot&apos;s network (the same first three numbers), and check the cable.</source>
        <translation>给本 PC 设置机器人网络中的地址（前三个数字相同），并检查网线。</translation>
    </message>
    <message>
        <source>%1 responds, but provides no robot services</source>
        <translation>%1 有应答，但不提供机器人服务</translation>
    </message>
    <message>
        <source>Check that this is the address of the robot. A robot that has just been switched on may need another minute.</source>
        <translation>检查这是否为机器人的地址。刚开机的机器人可能还需要一分钟。</translation>
    </message>
    <message>
        <source>%1 responds</source>
        <translation>%1 应答</translation>
    </message>
    <message>
        <source>dashboard, port %1</source>
        <translation>仪表板，端口 %1</translation>
    </message>
    <message>
        <source>port %1</source>
        <translation>端口 %1</translation>
    </message>
    <message>
        <source>port %1 is closed</source>
        <translation>端口 %1 已关闭</translation>
    </message>
    <message>
        <source>port %1 does not respond</source>
        <translation>端口 %1 不应答</translation>
    </message>
    <message>
        <source>Enable this interface on the robot under Settings &gt; Security &gt; Services.</source>
        <translation>在机器人的“设置 &gt; 安全 &gt; 服务”中打开此接口。</translation>
    </message>
    <message>
        <source>A firewall may be blocking this port. Allow TCP port %1 to the robot.</source>
        <translation>防火墙可能阻止了此端口。请允许到机器人的 TCP 端口 %1。</translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant. Until then, Tiller can only monitor.</source>
        <translation>在示教器右上角把机器人切换到远程控制。在此之前 Tiller 只能监视。</translation>
    </message>
    <message>
        <source>the dashboard accepts connections but does not respond</source>
        <translation>仪表板接受连接但不应答</translation>
    </message>
    <message>
        <source>the service on port %1 is not a dashboard server</source>
        <translation>端口 %1 上的服务不是仪表板服务器</translation>
    </message>
    <message>
        <source>Restart the robot&apos;s controller. If the problem persists, see the controller log.</source>
        <translation>重启机器人的控制器；若问题仍存在，请查看其日志。</translation>
    </message>
    <message>
        <source>Check the address, and check that no other program is using this port.</source>
        <translation>检查地址，并确认没有其他程序使用此端口。</translation>
    </message>
    <message>
        <source>this series has no Local/Remote switch</source>
        <translation>此系列没有本地/远程开关</translation>
    </message>
    <message>
        <source>Remote</source>
        <translation>远程</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>本地</translation>
    </message>
    <message>
        <source>neither the dashboard (port %1) nor the Robot API (port %2) is available</source>
        <translation>仪表板（端口 %1）和 Robot API（端口 %2）均不可用</translation>
    </message>
    <message>
        <source>the primary interface sends no data about the arm</source>
        <translation>主接口没有提供机械臂的信息</translation>
    </message>
    <message>
        <source>Check that this is the address of the robot, and restart its controller.</source>
        <translation>检查这是否为机器人的地址，并重启其控制器。</translation>
    </message>
    <message>
        <source>robot type %1 is not known to this version of Tiller</source>
        <translation>此版本的 Tiller 不支持机器人型号 %1</translation>
    </message>
    <message>
        <source>Monitoring works. Limits and previews use the dimensions that the robot reports; jog slowly at first.</source>
        <translation>可以监视。极限和预览使用机器人报告的尺寸；开始时请慢速点动。</translation>
    </message>
    <message>
        <source>Address resolves</source>
        <translation>地址解析</translation>
    </message>
    <message>
        <source>Host responds</source>
        <translation>主机应答</translation>
    </message>
    <message>
        <source>RTDE port</source>
        <translation>RTDE 端口</translation>
    </message>
    <message>
        <source>Primary port</source>
        <translation>主端口</translation>
    </message>
    <message>
        <source>Secondary port</source>
        <translation>副端口</translation>
    </message>
    <message>
        <source>Real-time port</source>
        <translation>实时端口</translation>
    </message>
    <message>
        <source>Dashboard or Robot API</source>
        <translation>仪表板或 Robot API</translation>
    </message>
    <message>
        <source>RTDE protocol</source>
        <translation>RTDE 协议</translation>
    </message>
    <message>
        <source>Controller software</source>
        <translation>控制器软件</translation>
    </message>
    <message>
        <source>Robot model</source>
        <translation>机器人型号</translation>
    </message>
    <message>
        <source>Remote control</source>
        <translation>远程控制</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>安全</translation>
    </message>
    <message>
        <source>Power and brakes</source>
        <translation>电源与制动器</translation>
    </message>
    <message>
        <source>Control registers free</source>
        <translation>控制寄存器空闲</translation>
    </message>
    <message>
        <source>Data rate</source>
        <translation>数据速率</translation>
    </message>
    <message>
        <source>Real-time priority on this PC</source>
        <translation>本 PC 的实时优先级</translation>
    </message>
    <message>
        <source>TCP and payload</source>
        <translation>TCP 与有效负载</translation>
    </message>
    <message>
        <source>real-time loops can keep the CPUs out of deep sleep states</source>
        <translation>实时循环可以阻止 CPU 进入深度睡眠状态</translation>
    </message>
    <message>
        <source>Enable the dashboard server on the robot under Settings &gt; Security &gt; Services. On PolyScope X, the Robot API requires version 10.11 or newer.</source>
        <translation>在机器人的“设置 &gt; 安全 &gt; 服务”中打开 Dashboard Server。PolyScope X 的 Robot API 需要 10.11 或更新版本。</translation>
    </message>
    <message>
        <source>Robot API %1, port %2; popups can be closed only on the teach pendant</source>
        <translation>Robot API %1，端口 %2；弹窗只能在示教器上关闭</translation>
    </message>
    <message>
        <source>Fieldbus registers free</source>
        <translation>现场总线寄存器空闲</translation>
    </message>
    <message>
        <source>Wake-up latency on this PC</source>
        <translation>本 PC 的唤醒延迟</translation>
    </message>
</context>
<context>
    <name>Freedrive</name>
    <message>
        <source>All axes</source>
        <translation>所有轴</translation>
    </message>
    <message>
        <source>Position only</source>
        <translation>仅位置</translation>
    </message>
    <message>
        <source>Orientation only</source>
        <translation>仅方向</translation>
    </message>
    <message>
        <source>XY plane</source>
        <translation>XY 平面</translation>
    </message>
    <message>
        <source>Z only</source>
        <translation>仅 Z</translation>
    </message>
    <message>
        <source>Wait for standstill before you start Freedrive.</source>
        <translation>请等待静止后再启动自由驱动。</translation>
    </message>
    <message>
        <source>The arm would drift: the robot measures %1 with a payload of %2 kg. Do not touch the tool, or correct the payload and the TCP.</source>
        <translation>机械臂会漂移：有效负载为 %2 kg 时测得 %1。请松开工具，或更正有效负载和 TCP。</translation>
    </message>
</context>
<context>
    <name>Gamepad</name>
    <message>
        <source>left bumper</source>
        <translation>左肩键</translation>
    </message>
    <message>
        <source>Left stick: X and Y. Right stick: Z and rotation. Hold the right bumper to rotate with both sticks.</source>
        <translation>左摇杆：X 和 Y。右摇杆：Z 和旋转。按住右肩键可用两个摇杆旋转。</translation>
    </message>
</context>
<context>
    <name>InterfaceSize</name>
    <message>
        <source>This screen has a high resolution. Increase “Interface size” in Settings to enlarge text, controls and plots.</source>
        <translation>此屏幕分辨率较高。增大设置中的“界面大小”可放大文字、控件和曲线图。</translation>
    </message>
</context>
<context>
    <name>JogActions</name>
    <message>
        <source>Jog speed %1</source>
        <translation>点动速度 %1</translation>
    </message>
    <message>
        <source>Jog step %1, %2°</source>
        <translation>点动步长 %1，%2°</translation>
    </message>
    <message>
        <source>Arm or disarm keyboard jogging</source>
        <translation>启用或停用键盘点动</translation>
    </message>
    <message>
        <source>While the keyboard is armed, the arrow keys move the arm and a border surrounds the window. The keyboard is disarmed after 30 s without use.</source>
        <translation>键盘启用后，方向键移动机械臂，窗口四周出现边框。30 秒未使用后停用。</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse…</source>
        <translation>手柄与 SpaceMouse…</translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation>显示各设备的当前数值，以及机械臂将移动的方向。</translation>
    </message>
    <message>
        <source>Zero here</source>
        <translation>此处归零</translation>
    </message>
    <message>
        <source>Shows the TCP displacement from the current position. Press again to show the displacement since the start of the last motion.</source>
        <translation>显示从当前位置起的 TCP 位移。再次按下则显示自上次运动开始起的位移。</translation>
    </message>
    <message>
        <source>Stops the arm. The next press uses this speed.</source>
        <translation>停止机械臂；下次按下使用此速度。</translation>
    </message>
    <message>
        <source>Moves the arm by this distance while the button is held.</source>
        <translation>按住按钮时将机械臂移动此距离。</translation>
    </message>
    <message>
        <source>Each press moves the arm by this distance.</source>
        <translation>每次按下使机械臂移动此距离。</translation>
    </message>
    <message>
        <source>Jog until contact (%1 N)</source>
        <translation>点动直到接触（%1 N）</translation>
    </message>
    <message>
        <source>Moves slowly while the button is held and stops when the contact force reaches this value.</source>
        <translation>按住按钮时缓慢移动，接触力达到此值时停止。</translation>
    </message>
    <message>
        <source>Other jog speed…</source>
        <translation>其他点动速度…</translation>
    </message>
    <message>
        <source>Sets the TCP speed. Rotation and joint speeds change in proportion.</source>
        <translation>设置 TCP 速度。旋转和关节速度按比例变化。</translation>
    </message>
    <message>
        <source>Other jog step…</source>
        <translation>其他点动步长…</translation>
    </message>
    <message>
        <source>Sets the step length. The step angle does not change.</source>
        <translation>设置步长。步进角度不变。</translation>
    </message>
    <message>
        <source>Other jog angle…</source>
        <translation>其他旋转步长…</translation>
    </message>
    <message>
        <source>Sets the step angle of tool and joint rotations. The step length does not change.</source>
        <translation>设置工具和关节旋转的步进角度。步长不变。</translation>
    </message>
    <message>
        <source>Other contact force for jogging…</source>
        <translation>点动的其他接触力…</translation>
    </message>
    <message>
        <source>Sets the contact force in N that ends the motion.</source>
        <translation>设置结束运动的接触力（N）。</translation>
    </message>
    <message>
        <source>Freedrive: %1</source>
        <translation>自由驱动：%1</translation>
    </message>
    <message>
        <source>Selects the axes that can be moved by hand during Freedrive.</source>
        <translation>选择自由驱动时可用手移动的轴。</translation>
    </message>
</context>
<context>
    <name>JogColumn</name>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
</context>
<context>
    <name>JointNames</name>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>肩部</translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation>肘部</translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation>手腕 1</translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation>手腕 2</translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation>手腕 3</translation>
    </message>
</context>
<context>
    <name>KeyStateProbe</name>
    <message>
        <source>Key-state check unavailable on this platform (%1): Tiller relies on window events to detect key releases.</source>
        <translation>此平台无法进行按键状态检查（%1）：Tiller 依靠窗口事件检测按键松开。</translation>
    </message>
    <message>
        <source>Key-state check active: Tiller checks with the display server every 10 ms whether the button or key is still pressed.</source>
        <translation>按键状态检查已启用：Tiller 每 10 ms 向显示服务器检查按钮或按键是否仍被按下。</translation>
    </message>
    <message>
        <source>Key-state check unavailable: Tiller could not open a second connection to the display server. Tiller relies on window events to detect key releases.</source>
        <translation>无法进行按键状态检查：没有到显示服务器的第二个连接。Tiller 依靠窗口事件检测按键松开。</translation>
    </message>
</context>
<context>
    <name>LimiterAdvice</name>
    <message>
        <source>Elbow almost straight</source>
        <translation>肘部几乎伸直</translation>
    </message>
    <message>
        <source>Elbow almost straight: %1 speed</source>
        <translation>肘部几乎伸直：速度的 %1</translation>
    </message>
    <message>
        <source>bend the elbow</source>
        <translation>弯曲肘部</translation>
    </message>
    <message>
        <source>jog %1 or bend the elbow</source>
        <translation>点动 %1 或弯曲肘部</translation>
    </message>
    <message>
        <source>Wrist near the base axis</source>
        <translation>手腕靠近基座轴</translation>
    </message>
    <message>
        <source>Wrist near the base axis: %1 speed</source>
        <translation>手腕靠近基座轴：速度的 %1</translation>
    </message>
    <message>
        <source>move outwards</source>
        <translation>向外移动</translation>
    </message>
    <message>
        <source>jog %1 or rotate the base</source>
        <translation>点动 %1 或转动基座</translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°</source>
        <translation>手腕 2 接近 0° 或 180°</translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°: %1 speed</source>
        <translation>手腕 2 接近 0° 或 180°：速度的 %1</translation>
    </message>
    <message>
        <source>rotate wrist 2</source>
        <translation>转动手腕 2</translation>
    </message>
    <message>
        <source>jog %1 or rotate wrist 2</source>
        <translation>点动 %1 或转动手腕 2</translation>
    </message>
    <message>
        <source>%1 %2° from its limit</source>
        <translation>%1 距极限 %2°</translation>
    </message>
    <message>
        <source>rotate %1 %2</source>
        <translation>转动 %1 %2</translation>
    </message>
    <message>
        <source>jog %1 or rotate %2 %3</source>
        <translation>点动 %1 或转动 %2 %3</translation>
    </message>
    <message>
        <source>TCP at the speed cap: %1 speed</source>
        <translation>TCP 达到速度上限：速度的 %1</translation>
    </message>
    <message>
        <source>change the cap in Settings</source>
        <translation>请在设置中更改上限</translation>
    </message>
    <message>
        <source>Elbow at the speed cap: %1 speed</source>
        <translation>肘部达到速度上限：速度的 %1</translation>
    </message>
    <message>
        <source>Rotation at the speed cap: %1 speed</source>
        <translation>旋转达到速度上限：速度的 %1</translation>
    </message>
    <message>
        <source>%1 at its maximum speed: %2 speed</source>
        <translation>%1 达到最高速度：速度的 %2</translation>
    </message>
    <message>
        <source>choose a lower speed</source>
        <translation>选择较慢的速度</translation>
    </message>
    <message>
        <source>move away</source>
        <translation>远离它</translation>
    </message>
    <message>
        <source>jog %1</source>
        <translation>点动 %1</translation>
    </message>
    <message>
        <source>%1 is %2 from %3: %4 speed</source>
        <translation>%1 距 %3 %2：速度的 %4</translation>
    </message>
    <message>
        <source>%1 is %2 from %3</source>
        <translation>%1 距 %3 %2</translation>
    </message>
</context>
<context>
    <name>LocalSimulator</name>
    <message>
        <source>Simulated UR5e</source>
        <translation>模拟 UR5e</translation>
    </message>
</context>
<context>
    <name>ModeLook</name>
    <message>
        <source>FREEDRIVE</source>
        <translation>自由驱动</translation>
    </message>
    <message>
        <source>The arm can be moved by hand.</source>
        <translation>可以用手移动机械臂。</translation>
    </message>
    <message>
        <source>MOVING</source>
        <translation>运动中</translation>
    </message>
    <message>
        <source>The robot reports that the arm is moving.</source>
        <translation>机器人报告机械臂正在移动。</translation>
    </message>
    <message>
        <source>Remote</source>
        <translation>远程</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>本地</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>正在获取控制…</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>自由驱动</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>In control</source>
        <translation>已控制</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation>未控制</translation>
    </message>
    <message>
        <source>Commands take longer than 20 ms: the arm responds with a delay. Jog slowly.</source>
        <translation>命令耗时超过 20 ms：机械臂响应有延迟。请慢速点动。</translation>
    </message>
    <message>
        <source>Good: the arm responds immediately and stops within 250 ms if the link fails.</source>
        <translation>良好：机械臂立即响应，连接中断时在 250 ms 内停止。</translation>
    </message>
    <message>
        <source>Last 10 s: %1 packets, %2 late, %3 lost</source>
        <translation>最近 10 s：%1 个数据包，%2 延迟，%3 丢失</translation>
    </message>
    <message>
        <source>Since connecting: %1 packets, %2 late, %3 lost</source>
        <translation>连接以来：%1 个数据包，%2 延迟，%3 丢失</translation>
    </message>
    <message>
        <source>A packet counts as late when it arrives more than half a period after its expected time.</source>
        <translation>数据包比预期时间晚半个周期以上到达时计为延迟。</translation>
    </message>
    <message>
        <source>No robot connected</source>
        <translation>未连接机器人</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>正在连接…</translation>
    </message>
    <message>
        <source>Late: %1 s</source>
        <translation>延迟：%1 s</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source> · %1 late</source>
        <translation> · %1 延迟</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · %1 丢失</translation>
    </message>
    <message>
        <source>LINK · JOG STOPS</source>
        <translation>链路 · 点动会停</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>LINK · JOG MAY STOP</source>
        <translation>链路 · 点动可能停</translation>
    </message>
    <message>
        <source>LINK · ARM LAGS</source>
        <translation>链路 · 机械臂滞后</translation>
    </message>
    <message>
        <source>LINK · GOOD</source>
        <translation>链路 · 良好</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>连接…</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>上电</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>松开制动器</translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation>恢复…</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>获取控制</translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation>给机械臂上电。制动器保持抱紧。</translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation>机械臂可能下沉几毫米。请保持距离。</translation>
    </message>
    <message>
        <source>Shows the cause of the stop, the five seconds before it, and the recovery steps. The arm does not move.</source>
        <translation>显示停止的原因、停止前的五秒和恢复步骤。机械臂不会移动。</translation>
    </message>
    <message>
        <source>Data late</source>
        <translation>数据延迟</translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation>在机器人上启动控制程序。停止其他程序前会先询问。</translation>
    </message>
    <message>
        <source>Monitoring</source>
        <translation>监视中</translation>
    </message>
    <message>
        <source>Select the simulator or enter the address of a robot.</source>
        <translation>选择模拟器或输入机器人的地址。</translation>
    </message>
    <message>
        <source>Packets are late or lost: jogging may stop and plots may have gaps. Use a cable instead of a wireless link, and close other programs.</source>
        <translation>数据包延迟或丢失：点动可能停止，曲线图会有空缺。请使用网线代替无线连接，并关闭其他程序。</translation>
    </message>
</context>
<context>
    <name>ModeWords</name>
    <message>
        <source>No controller</source>
        <translation>无控制器</translation>
    </message>
    <message>
        <source>The robot&apos;s controller is not running. Restart the control box.</source>
        <translation>机器人的控制器没有运行。请重启控制箱。</translation>
    </message>
    <message>
        <source>Arm disconnected</source>
        <translation>机械臂未连接</translation>
    </message>
    <message>
        <source>The controller has no connection to the arm. See the teach pendant for the cause.</source>
        <translation>控制器与机械臂没有连接。请查看示教器。</translation>
    </message>
    <message>
        <source>Confirm safety</source>
        <translation>确认安全</translation>
    </message>
    <message>
        <source>Confirm the safety configuration on the teach pendant.</source>
        <translation>在示教器上确认安全配置。</translation>
    </message>
    <message>
        <source>Booting</source>
        <translation>启动中</translation>
    </message>
    <message>
        <source>The arm is starting. Wait a few seconds.</source>
        <translation>机械臂正在启动。请等待几秒。</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>断电</translation>
    </message>
    <message>
        <source>The arm is powered off. Power on the arm.</source>
        <translation>机械臂已断电。请上电。</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>上电</translation>
    </message>
    <message>
        <source>The arm is powered on and initializing. Wait a moment.</source>
        <translation>机械臂已上电，正在初始化。请稍候。</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>The brakes are engaged. Release the brakes.</source>
        <translation>制动器已抱紧。请松开。</translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation>反向驱动</translation>
    </message>
    <message>
        <source>The arm is being moved by hand with its brakes released. Release the Freedrive button.</source>
        <translation>制动器已松开，正在用手移动机械臂。请松开自由驱动按钮。</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Updating firmware</source>
        <translation>更新固件</translation>
    </message>
    <message>
        <source>The joints&apos; firmware is being updated. Do not switch off the power until the update is complete.</source>
        <translation>正在更新关节固件。更新完成前请勿断电。</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>No safety stop is active.</source>
        <translation>没有安全停止处于激活状态。</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>缩减</translation>
    </message>
    <message>
        <source>The reduced safety limits are active.</source>
        <translation>缩减的安全极限已生效。</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>保护性停止</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>The arm is outside a safety limit. Use the teach pendant to move the arm back within the limits.</source>
        <translation>机械臂超出安全极限。用示教器把它移回极限之内。</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>防护停止</translation>
    </message>
    <message>
        <source>A safeguard is open. Close it and, if a reset is configured, press the reset button.</source>
        <translation>安全防护已打开。请关闭；若配置了复位，请按复位按钮。</translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation>系统紧急停止</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>紧急停止</translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation>安全违规</translation>
    </message>
    <message>
        <source>A safety limit was exceeded and power was cut. Check the cause, then restart the safety system.</source>
        <translation>超出安全极限，电源已切断。检查原因，然后重启安全系统。</translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation>安全故障</translation>
    </message>
    <message>
        <source>The safety system found a fault. Check the robot&apos;s log, then restart the safety system.</source>
        <translation>安全系统发现故障。检查机器人的日志，然后重启安全系统。</translation>
    </message>
    <message>
        <source>Validate joints</source>
        <translation>验证关节</translation>
    </message>
    <message>
        <source>A joint was replaced. Validate the joints on the teach pendant.</source>
        <translation>更换了关节。请在示教器上验证关节。</translation>
    </message>
    <message>
        <source>Undefined</source>
        <translation>未定义</translation>
    </message>
    <message>
        <source>The controller does not report its safety mode. Check the teach pendant.</source>
        <translation>控制器没有报告其安全模式。请查看示教器。</translation>
    </message>
    <message>
        <source>Automatic safeguard stop</source>
        <translation>自动防护停止</translation>
    </message>
    <message>
        <source>The automatic mode safeguard is open. Close it, or switch to manual mode.</source>
        <translation>自动模式的防护装置打开。请关闭，或切换到手动模式。</translation>
    </message>
    <message>
        <source>Enabling device stop</source>
        <translation>使能装置停止</translation>
    </message>
    <message>
        <source>The enabling device is not held. Hold it in its middle position.</source>
        <translation>未按住使能装置。请保持在中间位置。</translation>
    </message>
    <message>
        <source>Pendant enabling stop</source>
        <translation>示教器使能停止</translation>
    </message>
    <message>
        <source>IMMI emergency stop</source>
        <translation>IMMI 紧急停止</translation>
    </message>
    <message>
        <source>IMMI safeguard stop</source>
        <translation>IMMI 防护停止</translation>
    </message>
    <message>
        <source>The moulding machine&apos;s safeguard is open. Close it.</source>
        <translation>注塑机的防护装置打开。请关闭。</translation>
    </message>
    <message>
        <source>PROFIsafe waiting</source>
        <translation>PROFIsafe 等待中</translation>
    </message>
    <message>
        <source>The robot is waiting for the PROFIsafe controller. Check the fieldbus and the PROFIsafe parameters.</source>
        <translation>机器人在等待 PROFIsafe 控制器。检查现场总线和 PROFIsafe 参数。</translation>
    </message>
    <message>
        <source>PROFIsafe automatic stop</source>
        <translation>PROFIsafe 自动停止</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an automatic mode safeguard stop. Clear the request on that controller.</source>
        <translation>PROFIsafe 控制器请求自动模式的防护停止。请在该控制器上解除请求。</translation>
    </message>
    <message>
        <source>PROFIsafe safeguard stop</source>
        <translation>PROFIsafe 防护停止</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests a safeguard stop. Clear the request on that controller.</source>
        <translation>PROFIsafe 控制器请求防护停止。请在该控制器上解除请求。</translation>
    </message>
    <message>
        <source>PROFIsafe emergency stop</source>
        <translation>PROFIsafe 紧急停止</translation>
    </message>
    <message>
        <source>Safety API stop</source>
        <translation>Safety API 停止</translation>
    </message>
    <message>
        <source>A program requests a safeguard stop through the safety API. Clear the request in that program.</source>
        <translation>某个程序通过安全 API 请求防护停止。请在该程序中解除请求。</translation>
    </message>
    <message>
        <source>I/O plane stop</source>
        <translation>I/O 平面停止</translation>
    </message>
    <message>
        <source>The tool crossed a safety plane that is enabled by an input. Move the tool back with the teach pendant, or turn the input off.</source>
        <translation>工具越过了由输入启用的安全平面。用示教器将其移回，或关闭该输入。</translation>
    </message>
    <message>
        <source>Program stopping</source>
        <translation>程序停止中</translation>
    </message>
    <message>
        <source>The program on the robot is stopping.</source>
        <translation>机器人上的程序正在停止。</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>无程序</translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation>机器人上没有程序运行。</translation>
    </message>
    <message>
        <source>Program running</source>
        <translation>程序运行</translation>
    </message>
    <message>
        <source>A program is running on the robot and may move the arm.</source>
        <translation>机器人上有程序运行，可能移动机械臂。</translation>
    </message>
    <message>
        <source>Program pausing</source>
        <translation>程序暂停中</translation>
    </message>
    <message>
        <source>The program is pausing.</source>
        <translation>程序正在暂停。</translation>
    </message>
    <message>
        <source>Program paused</source>
        <translation>程序已暂停</translation>
    </message>
    <message>
        <source>Press “Play” to continue the interrupted motion, or stop the program to discard it.</source>
        <translation>按“播放”继续被中断的动作，或停止程序以放弃它。</translation>
    </message>
    <message>
        <source>Program resuming</source>
        <translation>程序恢复中</translation>
    </message>
    <message>
        <source>The program is resuming, and the arm may move.</source>
        <translation>程序正在恢复：机械臂可能移动。</translation>
    </message>
    <message>
        <source>Unknown robot mode %1. See the teach pendant.</source>
        <translation>未知机器人模式 %1。请查看示教器。</translation>
    </message>
    <message>
        <source>Unknown safety mode %1. See the teach pendant.</source>
        <translation>未知安全模式 %1。请查看示教器。</translation>
    </message>
    <message>
        <source>Unknown program state %1. See the teach pendant.</source>
        <translation>未知程序状态 %1。请查看示教器。</translation>
    </message>
    <message>
        <source>The brakes are released. The arm is at standstill.</source>
        <translation>制动器已松开。机械臂静止。</translation>
    </message>
    <message>
        <source>The controller stopped the arm. Find the cause, wait 5 s, then unlock the protective stop.</source>
        <translation>控制器停止了机械臂。找出原因，等待 5 s，然后解锁保护性停止。</translation>
    </message>
    <message>
        <source>The cell&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation>单元的紧急停止被按下。松开它，然后上电并松开制动器。</translation>
    </message>
    <message>
        <source>The emergency stop button of the robot is pressed. Twist it clockwise to release it, then power on the arm and release the brakes.</source>
        <translation>机器人的紧急停止按钮被按下。顺时针旋转以松开，然后上电并松开制动器。</translation>
    </message>
    <message>
        <source>The moulding machine&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation>注塑机的紧急停止被按下。松开它，然后上电并松开制动器。</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an emergency stop. Clear the request on that controller, then power on the arm and release the brakes.</source>
        <translation>PROFIsafe 控制器请求紧急停止。请在该控制器上解除请求，然后上电并松开制动器。</translation>
    </message>
    <message>
        <source>The enabling button of the teach pendant is not held. Hold it in its middle position.</source>
        <translation>未按住示教器的使能按钮。请保持在中间位置。</translation>
    </message>
</context>
<context>
    <name>OutputGripper</name>
    <message>
        <source>The robot did not confirm the outputs. Another program or the installation may control them.</source>
        <translation>机器人没有确认输出。它们可能由其他程序或安装设置控制。</translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation>夹爪：关闭</translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation>夹爪：打开</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>等待中…</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>open requested</source>
        <translation>已请求打开</translation>
    </message>
    <message>
        <source>close requested</source>
        <translation>已请求关闭</translation>
    </message>
    <message>
        <source>both outputs off</source>
        <translation>两个输出都关</translation>
    </message>
    <message>
        <source>both outputs on</source>
        <translation>两个输出都开</translation>
    </message>
    <message>
        <source>Choose different outputs for closing and opening.</source>
        <translation>选择两个不同的输出：一个关闭，另一个打开。</translation>
    </message>
</context>
<context>
    <name>PanelActions</name>
    <message>
        <source>Record</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Records the robot data to a file until you stop the recording.</source>
        <translation>将机器人数据录制到文件，直到停止录制。</translation>
    </message>
    <message>
        <source>A recording is already running.</source>
        <translation>录制已在进行。</translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation>请先连接机器人。</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>停止录制</translation>
    </message>
    <message>
        <source>Stops the recording and completes its file.</source>
        <translation>停止录制并完成文件。</translation>
    </message>
    <message>
        <source>No recording is running.</source>
        <translation>没有正在进行的录制。</translation>
    </message>
    <message>
        <source>Pause or resume the plots</source>
        <translation>暂停或继续曲线图</translation>
    </message>
    <message>
        <source>Freezes the plots while data and recording continue. Press again to return to the newest samples.</source>
        <translation>冻结曲线图，数据和录制继续。再次按下返回最新样本。</translation>
    </message>
    <message>
        <source>Export the plots…</source>
        <translation>导出曲线图…</translation>
    </message>
    <message>
        <source>Saves the visible range as an image, PDF page or table of values.</source>
        <translation>将显示的范围保存为图片、PDF 页面或数值表。</translation>
    </message>
    <message>
        <source>Plots: last %1</source>
        <translation>曲线图：最近 %1</translation>
    </message>
    <message>
        <source>Sets the time range of the plots.</source>
        <translation>设置曲线图的时间范围。</translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation>搜索输入和输出</translation>
    </message>
    <message>
        <source>Finds a terminal or a register by its number or name.</source>
        <translation>按编号或名称查找端子或寄存器。</translation>
    </message>
    <message>
        <source>Rename selected input or output</source>
        <translation>重命名所选输入或输出</translation>
    </message>
    <message>
        <source>Renames the input or output in the selected row of the I/O tab.</source>
        <translation>重命名 I/O 选项卡中选定行的输入或输出。</translation>
    </message>
    <message>
        <source>Switch selected output</source>
        <translation>切换所选输出</translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on or off.</source>
        <translation>打开或关闭 I/O 选项卡中选定的输出。</translation>
    </message>
    <message>
        <source>Pulse selected output</source>
        <translation>所选输出脉冲</translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on for 0.5 s, then off.</source>
        <translation>将 I/O 选项卡中选定的输出打开 0.5 s，然后关闭。</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>搜索日志</translation>
    </message>
    <message>
        <source>Shows only entries that contain the search text.</source>
        <translation>只显示包含搜索文字的条目。</translation>
    </message>
    <message>
        <source>Log: show all</source>
        <translation>日志：全部显示</translation>
    </message>
    <message>
        <source>Log: show warnings and errors</source>
        <translation>日志：显示警告和错误</translation>
    </message>
    <message>
        <source>Log: show errors only</source>
        <translation>日志：显示错误</translation>
    </message>
    <message>
        <source>Selects which log entries are shown.</source>
        <translation>选择显示哪些日志条目。</translation>
    </message>
    <message>
        <source>Copy the log</source>
        <translation>复制日志</translation>
    </message>
    <message>
        <source>Copies the selected entries. If no entry is selected, copies all visible entries.</source>
        <translation>复制所选条目，或所有可见条目。</translation>
    </message>
    <message>
        <source>Export the log…</source>
        <translation>导出日志…</translation>
    </message>
    <message>
        <source>Writes the visible entries to a file.</source>
        <translation>将可见条目写入文件。</translation>
    </message>
    <message>
        <source>Search plot signals</source>
        <translation>搜索曲线图的信号</translation>
    </message>
    <message>
        <source>Opens the list of all signals. To add a signal to a plot, drag it, double-click it or press Return.</source>
        <translation>打开所有信号的列表。拖动、双击或按回车可将信号加到曲线图。</translation>
    </message>
    <message>
        <source>New plot page</source>
        <translation>新建曲线图页</translation>
    </message>
    <message>
        <source>Adds an empty page at the end. All pages share the time axis.</source>
        <translation>在末尾添加空白页。所有页共用时间轴。</translation>
    </message>
    <message>
        <source>Show the entire history</source>
        <translation>显示全部历史</translation>
    </message>
    <message>
        <source>Shows all data in memory and scales each plot automatically.</source>
        <translation>显示内存中的全部数据，并自动缩放每个图。</translation>
    </message>
    <message>
        <source>Add note…</source>
        <translation>添加备注…</translation>
    </message>
    <message>
        <source>Adds a note at the selected cursor if it is visible, otherwise at the end of the plots.</source>
        <translation>如果所选光标可见，则在其位置添加备注，否则添加在图表末尾。</translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation>显示或隐藏 %1</translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation>浮动 %1</translation>
    </message>
    <message>
        <source>Moves the panel to a separate window, e.g. on a second screen, or back to the main window.</source>
        <translation>将面板移到独立窗口（例如用于第二屏幕），或移回。</translation>
    </message>
    <message>
        <source>Moves the panel to this side of the main window.</source>
        <translation>将面板移到主窗口的这一侧。</translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation>显示标准曲线图</translation>
    </message>
    <message>
        <source>Replaces the pages of live data with the standard page. Pages with recordings are kept.</source>
        <translation>用标准页替换实时数据页。录制页保留。</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>打开录制…</translation>
    </message>
    <message>
        <source>Shows a recording or a table of another program on its own page.</source>
        <translation>在单独的页面上显示录制文件或其他程序的表格。</translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation>关闭录制文件</translation>
    </message>
    <message>
        <source>Removes all opened recordings from the plots. The files are kept.</source>
        <translation>从曲线图中移除所有打开的录制。文件保留。</translation>
    </message>
    <message>
        <source>No recording is open.</source>
        <translation>没有打开的录制。</translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation>与机械臂模型比较…</translation>
    </message>
    <message>
        <source>Compares the displayed recording with the model of its arm.</source>
        <translation>将显示的录制与其机械臂的模型比较。</translation>
    </message>
    <message>
        <source>Show the page of a recording first.</source>
        <translation>请先显示录制的页面。</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>游标处的值</translation>
    </message>
    <message>
        <source>Shows or hides the table of values at the cursors and between them.</source>
        <translation>显示或隐藏游标处及其之间的数值表。</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>频谱和 XY</translation>
    </message>
    <message>
        <source>Shows or hides the spectrum and the XY plot of two signals.</source>
        <translation>显示或隐藏频谱和两个信号的 XY 图。</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>将 %1 移到左侧</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>将 %1 移到右侧</translation>
    </message>
    <message>
        <source>%1 to the top</source>
        <translation>将 %1 移到顶部</translation>
    </message>
    <message>
        <source>%1 to the bottom</source>
        <translation>将 %1 移到底部</translation>
    </message>
    <message>
        <source>Plots: start or stop playback</source>
        <translation>曲线图：开始或停止播放</translation>
    </message>
    <message>
        <source>Moves cursor A in real time through the recording or the paused plots. The Layout menu contains other speeds.</source>
        <translation>使光标 A 在记录或暂停的曲线中实时移动。“布局”菜单中有其他速度。</translation>
    </message>
</context>
<context>
    <name>PlotMenu</name>
    <message>
        <source>Remove lane %1</source>
        <translation>移除通道 %1</translation>
    </message>
    <message>
        <source>Add note here…</source>
        <translation>在此添加备注…</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>显示 %1</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>隐藏 %1</translation>
    </message>
    <message>
        <source>Show values of %1 at the cursors</source>
        <translation>在游标处显示 %1 的值</translation>
    </message>
    <message>
        <source>Move %1 to a separate plot</source>
        <translation>把 %1 移到单独的图</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Warn when %1</source>
        <translation>当 %1 时警告</translation>
    </message>
    <message>
        <source>Do not warn when %1</source>
        <translation>当 %1 时不警告</translation>
    </message>
    <message>
        <source>Rate of change of %1</source>
        <translation>%1 的变化率</translation>
    </message>
    <message>
        <source>Moving mean of %1 over 0.5 s</source>
        <translation>%1 的 0.5 秒移动平均</translation>
    </message>
    <message>
        <source>Mean %1</source>
        <translation>平均 %1</translation>
    </message>
    <message>
        <source>Norm of the curves in this plot</source>
        <translation>此图各曲线的模</translation>
    </message>
    <message>
        <source>New plot below</source>
        <translation>在下方新建图</translation>
    </message>
    <message>
        <source>New plot to the right</source>
        <translation>在右侧新建曲线图</translation>
    </message>
    <message>
        <source>Remove this plot</source>
        <translation>移除此曲线图</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Low-pass filter of %1 at 10 Hz</source>
        <translation>%1 的 10 Hz 低通滤波</translation>
    </message>
    <message>
        <source>Filtered %1</source>
        <translation>滤波后的 %1</translation>
    </message>
    <message>
        <source>Left axis</source>
        <translation>左轴</translation>
    </message>
    <message>
        <source>Right axis</source>
        <translation>右轴</translation>
    </message>
    <message>
        <source>Edit %1…</source>
        <translation>编辑 %1…</translation>
    </message>
    <message>
        <source>Axis limits…</source>
        <translation>坐标轴范围…</translation>
    </message>
    <message>
        <source>Scale to curves</source>
        <translation>按曲线缩放</translation>
    </message>
</context>
<context>
    <name>PlotPane</name>
    <message>
        <source>%1 (right)</source>
        <translation>%1（右）</translation>
    </message>
</context>
<context>
    <name>Practice</name>
    <message>
        <source>Waiting for the protective stop.</source>
        <translation>等待保护性停止。</translation>
    </message>
    <message>
        <source>The arm is in a protective stop. Press “Recover…” in the header.</source>
        <translation>机械臂处于保护性停止。请按页眉中的“恢复…”。</translation>
    </message>
    <message>
        <source>Unlocked. The arm is not running yet: follow the steps on the recovery page.</source>
        <translation>已解锁。机械臂尚未运行：请按恢复页面上的步骤操作。</translation>
    </message>
    <message>
        <source>Unlocked. Take control again.</source>
        <translation>已解锁。请再次获取控制。</translation>
    </message>
    <message>
        <source>The arm is running and under your control again.</source>
        <translation>机械臂在运行，并再次受您控制。</translation>
    </message>
    <message>
        <source>No new frame yet. Use “3 points” in the Frames tab.</source>
        <translation>还没有新坐标系。请使用坐标系选项卡中的“三点”。</translation>
    </message>
    <message>
        <source>“%1” meets the requirements.</source>
        <translation>“%1”符合要求。</translation>
    </message>
    <message>
        <source>The Z axis of “%1” differs from the base Z axis by %2°. The third point must be on the +Y side.</source>
        <translation>“%1”的 Z 轴与基座 Z 轴相差 %2°。第三点必须位于 +Y 一侧。</translation>
    </message>
    <message>
        <source>The X axis of “%1” differs from the base Y axis by %2°.</source>
        <translation>“%1”的 X 轴与基座 Y 轴相差 %2°。</translation>
    </message>
    <message>
        <source>“%1” was not taught with the arm: the TCP was never at its origin.</source>
        <translation>“%1”不是用机械臂示教的：TCP 从未到过其原点。</translation>
    </message>
    <message>
        <source>The waypoint was deleted. Press “Start” to add a new waypoint.</source>
        <translation>路点已删除。按“开始”添加一个新的。</translation>
    </message>
    <message>
        <source>“%1” has not changed. The arm is %2 away from the waypoint along X.</source>
        <translation>“%1”没有改变。机械臂沿 X 距其 %2。</translation>
    </message>
    <message>
        <source>“%1” has moved by %2 and is %3 from the expected position.</source>
        <translation>“%1”移动了 %2，距预期位置 %3。</translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the tool orientation changed.</source>
        <translation>“%1”在预期位置，但工具方向改变了。</translation>
    </message>
    <message>
        <source>“%1” matches the part again.</source>
        <translation>“%1”再次与工件位置一致。</translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the arm is not. Touch up the waypoint with the arm at the part.</source>
        <translation>“%1”在预期位置，但机械臂不在。请将机械臂移到工件处再修正示教路点。</translation>
    </message>
    <message>
        <source>Slowed down to %1. Continue.</source>
        <translation>已减速到 %1。继续。</translation>
    </message>
    <message>
        <source>No limit reached yet. The line below the pad will show the limit.</source>
        <translation>尚未达到极限。操作盘下方的行会显示它。</translation>
    </message>
    <message>
        <source>Limit reached. Now jog back: %1 of %2.</source>
        <translation>已到达极限。现在点动返回：%1 / %2。</translation>
    </message>
    <message>
        <source>You reached the limit and moved back.</source>
        <translation>您已到达极限并返回。</translation>
    </message>
    <message>
        <source>Recording: %1 s of %2 s.</source>
        <translation>录制中：%1 s / %2 s。</translation>
    </message>
    <message>
        <source>The recording is too short. Record for at least three seconds.</source>
        <translation>录制太短。请至少录制三秒。</translation>
    </message>
    <message>
        <source>No recording yet. Press “Record” above the plots.</source>
        <translation>还没有录制。请按曲线图上方的“录制”。</translation>
    </message>
    <message>
        <source>Recorded. Enter the force shown in the plot.</source>
        <translation>已录制。请输入曲线图中显示的力。</translation>
    </message>
    <message>
        <source>%1 does not match the recording. Look at the Fz curve.</source>
        <translation>%1 与录制不符。请看 Fz 曲线。</translation>
    </message>
    <message>
        <source>Correct: the force was %1.</source>
        <translation>正确：力为 %1。</translation>
    </message>
    <message>
        <source>Recover from a protective stop</source>
        <translation>从保护性停止中恢复</translation>
    </message>
    <message>
        <source>Teach a frame</source>
        <translation>示教坐标系</translation>
    </message>
    <message>
        <source>Touch up a waypoint</source>
        <translation>修正示教路点</translation>
    </message>
    <message>
        <source>Find the reach limit</source>
        <translation>找到可达极限</translation>
    </message>
    <message>
        <source>Record and measure</source>
        <translation>录制并测量</translation>
    </message>
    <message>
        <source>Press “Start” to simulate a collision that causes a protective stop. Find out what stopped the arm, wait five seconds, unlock the arm and take control again.</source>
        <translation>按“开始”模拟一次引发保护性停止的碰撞。查明机械臂停止的原因，等待五秒，解锁并再次获取控制。</translation>
    </message>
    <message>
        <source>Teach a frame from three points in the Frames tab. Its X axis must point along the base Y+ direction and its Z axis up: record the origin, then a point further along Y+, then a point further along X−.</source>
        <translation>在坐标系选项卡中用三点示教坐标系。其 X 轴须沿基座的 Y+ 方向，Z 轴向上：先取原点，再取沿 Y+ 方向的点，然后取沿 X− 方向的点。</translation>
    </message>
    <message>
        <source>Press “Start” to add a waypoint “part” at the current position of the arm. The part then moves by %1 along the base X+ direction. Jog to the part, select the waypoint and touch it up (U).</source>
        <translation>按“开始”在机械臂的当前位置添加路点“工件”。随后工件沿基座 X+ 方向移动 %1。点动到那里，选择该路点并修正示教 (U)。</translation>
    </message>
    <message>
        <source>Jog outwards, away from the base, until a limit halves the speed. The line below the pad shows the limit and how to move away from it. Then jog back by %1.</source>
        <translation>从基座向外点动，直到某个极限将速度降到一半。操作盘下方的行显示该极限和退出方法。然后点动返回 %1。</translation>
    </message>
    <message>
        <source>Press “Start” to simulate a hand pressing on the tool from above. Record for at least three seconds, then stop. Read the force Fz in the plots and enter the value.</source>
        <translation>按“开始”模拟一只手从上方按压工具。至少录制三秒后停止。在曲线图中读取力 Fz 并输入。</translation>
    </message>
    <message>
        <source>part</source>
        <translation>工件</translation>
    </message>
</context>
<context>
    <name>ProgramText</name>
    <message>
        <source>Maximum distance</source>
        <translation>最大距离</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>“%1” is %2. The value must be between %3 and %4.</source>
        <translation>“%1”为 %2；必须在 %3 至 %4 之间。</translation>
    </message>
    <message>
        <source>The group “%1” contains no waypoints. Add waypoints to the group, or select a different group.</source>
        <translation>组“%1”中没有路点。请向该组添加路点，或选择其他组。</translation>
    </message>
    <message>
        <source>“%1” refers to an item that was deleted from the project. Select a different item.</source>
        <translation>“%1”引用的项已从项目中删除。请选择其他项。</translation>
    </message>
    <message>
        <source>“%1” must come directly after “%2”.</source>
        <translation>“%1”必须紧跟在“%2”之后。</translation>
    </message>
    <message>
        <source>“%1” must be inside “%2”.</source>
        <translation>“%1”必须位于“%2”之内。</translation>
    </message>
    <message>
        <source>Steps in “Watch in parallel” cannot move the arm. Move this step out of the section.</source>
        <translation>并行步骤不能移动机械臂。请将此步骤移出该段。</translation>
    </message>
    <message>
        <source>This version of Tiller does not support the step “%1”. Update Tiller, or delete the step.</source>
        <translation>此版本的 Tiller 不支持步骤“%1”。请更新 Tiller 或删除该步骤。</translation>
    </message>
    <message>
        <source>A program can start only at a top-level step, and not at a branch such as Else. Select a different step.</source>
        <translation>程序只能从顶层步骤开始，不能从“否则”等分支开始。请选择其他步骤。</translation>
    </message>
    <message>
        <source>The project does not contain this program. Select a different program.</source>
        <translation>项目不包含此程序。请选择其他程序。</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a %2. Use “Adapt project to this robot…” first.</source>
        <translation>项目用 %1 示教，而机器人是 %2。请先使用“使项目适应此机器人…”。</translation>
    </message>
    <message>
        <source>A program with parameters cannot be started directly. Use a “Call program” step in another program.</source>
        <translation>带参数的程序不能直接启动。请在另一个程序中用步骤调用它。</translation>
    </message>
    <message>
        <source>The program has no steps. Add steps first.</source>
        <translation>程序没有步骤。请先添加步骤。</translation>
    </message>
    <message>
        <source>The variable “%1” has a different type elsewhere in the program. Use the same type or a different name.</source>
        <translation>变量“%1”在程序的其他位置类型不同。请使用相同的类型或其他名称。</translation>
    </message>
    <message>
        <source>Program calls are nested too deeply. Use fewer levels of calls.</source>
        <translation>程序调用嵌套过深。请减少调用层数。</translation>
    </message>
    <message>
        <source>“%1” was taught with a different TCP than the waypoints before it. Set the active TCP, or put the step in a TCP section.</source>
        <translation>“%1”与之前路点使用的 TCP 不同。请设置当前 TCP，或将步骤放入 TCP 段。</translation>
    </message>
    <message>
        <source>The blend radii of this move and the previous move (%1 and %2) exceed the distance of %3 between the two targets. Reduce a blend radius.</source>
        <translation>此运动与上一运动的交融半径（%1 和 %2）超过两个目标之间的距离 %3。请减小半径。</translation>
    </message>
    <message>
        <source>The expression is empty. Enter an expression.</source>
        <translation>表达式为空。请输入表达式。</translation>
    </message>
    <message>
        <source>An expression must be a single line.</source>
        <translation>表达式只能是一行。</translation>
    </message>
    <message>
        <source>“%1” is not a valid variable name. Use letters, digits and underscores, and do not start with a digit.</source>
        <translation>“%1”不是有效的变量名。请使用字母、数字和下划线，且不要以数字开头。</translation>
    </message>
    <message>
        <source>The name “%1” is reserved. Use a different name.</source>
        <translation>名称“%1”为保留名称。请使用其他名称。</translation>
    </message>
    <message>
        <source>The arm comes too close to itself.</source>
        <translation>机械臂与自身距离过近。</translation>
    </message>
    <message>
        <source>The arm comes too close to “%1”.</source>
        <translation>机械臂与“%1”距离过近。</translation>
    </message>
    <message>
        <source>The arm comes too close to the floor.</source>
        <translation>机械臂与地面距离过近。</translation>
    </message>
    <message>
        <source>The step failed and ended the program.</source>
        <translation>步骤失败并结束了程序。</translation>
    </message>
    <message>
        <source>The program did not end within %1 s.</source>
        <translation>程序未在 %1 s 内结束。</translation>
    </message>
    <message>
        <source>The preview was cancelled.</source>
        <translation>预览已取消。</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>输入和输出</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Tool and speed</source>
        <translation>工具和速度</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>流程</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>结构</translation>
    </message>
    <message>
        <source>Set variable</source>
        <translation>设置变量</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>True or false</source>
        <translation>真或假</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Call program</source>
        <translation>调用程序</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Parameter values</source>
        <translation>参数值</translation>
    </message>
    <message>
        <source>The program “%1” requires %2 comma-separated values, but the step passes %3.</source>
        <translation>程序“%1”需要 %2 个逗号分隔的值，但该步骤传递了 %3 个。</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>情况</translation>
    </message>
    <message>
        <source>“Default” must be the last branch of a Switch.</source>
        <translation>“默认”必须是“选择”的最后一部分。</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>注释</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Else if</source>
        <translation>否则如果</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Else</source>
        <translation>否则</translation>
    </message>
    <message>
        <source>End program</source>
        <translation>结束程序</translation>
    </message>
    <message>
        <source>The program failed.</source>
        <translation>程序失败。</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>For each pattern cell</source>
        <translation>对每个阵列格位</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>阵列</translation>
    </message>
    <message>
        <source>For each waypoint</source>
        <translation>对每个路点</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Force section</source>
        <translation>力控段</translation>
    </message>
    <message>
        <source>Reference frame</source>
        <translation>参考坐标系</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Section frame</source>
        <translation>段的坐标系</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>速度限制</translation>
    </message>
    <message>
        <source>Frame section</source>
        <translation>坐标系段</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>夹爪</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation>关闭用输出</translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation>打开用输出</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Input to check</source>
        <translation>检查输入</translation>
    </message>
    <message>
        <source>If the input is off</source>
        <translation>如果输入断开</translation>
    </message>
    <message>
        <source>Select different outputs for opening and closing.</source>
        <translation>请为打开和关闭选择不同的输出。</translation>
    </message>
    <message>
        <source>The gripper is not holding an object.</source>
        <translation>夹爪未夹持物体。</translation>
    </message>
    <message>
        <source>If</source>
        <translation>如果</translation>
    </message>
    <message>
        <source>Exit loop</source>
        <translation>退出循环</translation>
    </message>
    <message>
        <source>“Exit loop” must be inside a loop.</source>
        <translation>退出循环的步骤必须位于循环内。</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Repetitions (0: endless)</source>
        <translation>重复次数（0：无限）</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>计数器</translation>
    </message>
    <message>
        <source>This loop may never end and contains no delay. Add a Wait step.</source>
        <translation>此循环可能永不结束且不含等待时间。请添加“等待”步骤。</translation>
    </message>
    <message>
        <source>A loop can have 1 to %1 positions; this loop has %2.</source>
        <translation>循环可有 1 至 %1 个位置；现有 %2 个。</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>级别</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Wait for the operator</source>
        <translation>等待操作员</translation>
    </message>
    <message>
        <source>MoveC</source>
        <translation>MoveC</translation>
    </message>
    <message>
        <source>Via</source>
        <translation>经过</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>交融</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Fixed to arc</source>
        <translation>相对圆弧固定</translation>
    </message>
    <message>
        <source>Move through a group</source>
        <translation>通过一组路点</translation>
    </message>
    <message>
        <source>Run waypoint actions</source>
        <translation>执行路点动作</translation>
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
        <translation>相对移动</translation>
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
        <translation>距离为零。请输入 X、Y 或 Z 的值。</translation>
    </message>
    <message>
        <source>The waypoint “%1” moves the gripper. In a program, use the Gripper step and turn off “Run waypoint actions”.</source>
        <translation>路点“%1”会移动夹爪。在程序中请使用“夹爪”步骤，并关闭“执行路点动作”。</translation>
    </message>
    <message>
        <source>Waypoint</source>
        <translation>路点</translation>
    </message>
    <message>
        <source>Approach distance</source>
        <translation>接近距离</translation>
    </message>
    <message>
        <source>The arm cannot reach “%1”. Change the waypoint, or select a different waypoint.</source>
        <translation>机械臂无法到达“%1”。请修改该路点，或选择其他路点。</translation>
    </message>
    <message>
        <source>Set either a waypoint or a pose, not both.</source>
        <translation>请设置路点或位姿之一，不能同时设置。</translation>
    </message>
    <message>
        <source>Set a waypoint or a pose.</source>
        <translation>请设置路点或位姿。</translation>
    </message>
    <message>
        <source>Move until</source>
        <translation>移动直到</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>直到</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Input is on</source>
        <translation>输入接通</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>If not reached</source>
        <translation>如果未到达</translation>
    </message>
    <message>
        <source>Select an input.</source>
        <translation>请选择一个输入。</translation>
    </message>
    <message>
        <source>The input did not turn on within the maximum distance. Check the sensor and its wiring.</source>
        <translation>输入未在最大距离内接通。请检查传感器及其接线。</translation>
    </message>
    <message>
        <source>No contact was detected within the maximum distance.</source>
        <translation>在最大距离内未检测到接触。</translation>
    </message>
    <message>
        <source>Write to the log</source>
        <translation>写入日志</translation>
    </message>
    <message>
        <source>On error</source>
        <translation>出错时</translation>
    </message>
    <message>
        <source>Set payload</source>
        <translation>设置有效负载</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>有效负载</translation>
    </message>
    <message>
        <source>Pulse output</source>
        <translation>输出脉冲</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>On</source>
        <translation>接通</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>提问</translation>
    </message>
    <message>
        <source>Questions require robot software 5.6 or newer.</source>
        <translation>提问需要机器人软件 5.6 或更高版本。</translation>
    </message>
    <message>
        <source>URScript</source>
        <translation>URScript</translation>
    </message>
    <message>
        <source>Names that begin with “tiller_” are reserved.</source>
        <translation>以“tiller_”开头的名称已保留。</translation>
    </message>
    <message>
        <source>Each block in the script needs an “end”.</source>
        <translation>脚本的每个块都需要自己的“end”。</translation>
    </message>
    <message>
        <source>Set analog output</source>
        <translation>设置模拟输出</translation>
    </message>
    <message>
        <source>Set output</source>
        <translation>设置输出</translation>
    </message>
    <message>
        <source>Set register</source>
        <translation>设置寄存器</translation>
    </message>
    <message>
        <source>Integer</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>浮点</translation>
    </message>
    <message>
        <source>Boolean</source>
        <translation>布尔</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>寄存器</translation>
    </message>
    <message>
        <source>Programs can set registers only up to %1.</source>
        <translation>程序可设置的寄存器最大编号为 %1。</translation>
    </message>
    <message>
        <source>Speed section</source>
        <translation>速度段</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>A Switch must contain at least one Case.</source>
        <translation>“选择”至少需要一个“情况”。</translation>
    </message>
    <message>
        <source>Only Case and Default can be placed directly in a Switch.</source>
        <translation>“选择”中只能直接包含“情况”和“默认”。</translation>
    </message>
    <message>
        <source>TCP section</source>
        <translation>TCP 段</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>尝试</translation>
    </message>
    <message>
        <source>“Try” must be followed directly by “On error”.</source>
        <translation>“尝试”之后必须紧跟“出错时”。</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Wait for condition</source>
        <translation>等待条件</translation>
    </message>
    <message>
        <source>On timeout</source>
        <translation>超时后</translation>
    </message>
    <message>
        <source>The condition did not become true before the timeout.</source>
        <translation>条件未及时变为真。</translation>
    </message>
    <message>
        <source>Wait for input</source>
        <translation>等待输入</translation>
    </message>
    <message>
        <source>%1 did not change to the expected state before the timeout.</source>
        <translation>%1 未在超时前变为预期状态。</translation>
    </message>
    <message>
        <source>Watch in parallel</source>
        <translation>并行监视</translation>
    </message>
    <message>
        <source>A parallel watch must be at the top level of the program.</source>
        <translation>并行监视必须位于程序顶层。</translation>
    </message>
    <message>
        <source>While</source>
        <translation>当</translation>
    </message>
    <message>
        <source>At %1 s: %2</source>
        <translation>在 %1 s：%2</translation>
    </message>
    <message>
        <source>Step %1 (%2) at %3 s: %4</source>
        <translation>步骤 %1（%2），在 %3 s：%4</translation>
    </message>
    <message>
        <source>“%1” must be between %2 and %3.</source>
        <translation>“%1”必须在 %2 和 %3 之间。</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>步骤 %1：%2</translation>
    </message>
    <message>
        <source>The TCP of the robot differs from the TCP of the program&apos;s waypoints. Set the active TCP of the project, or use a TCP section.</source>
        <translation>机器人的 TCP 与程序路点的 TCP 不同。请设置项目的活动 TCP，或使用 TCP 段。</translation>
    </message>
    <message>
        <source>Preview the program first.</source>
        <translation>请先预览程序。</translation>
    </message>
    <message>
        <source>The preview found problems. Fix them, then preview the program again.</source>
        <translation>预览发现问题。请修正后重新预览程序。</translation>
    </message>
    <message>
        <source>Move the arm to the start position first.</source>
        <translation>请先将机械臂移动到起始位置。</translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation>程序正在运行。请先停止程序。</translation>
    </message>
    <message>
        <source>The program ended after %1 s.</source>
        <translation>程序在 %1 秒后结束。</translation>
    </message>
    <message>
        <source>Step %1 (%2) failed and ended the program.</source>
        <translation>步骤 %1（%2）失败，程序已结束。</translation>
    </message>
    <message>
        <source>Stopped in step %1 (%2): %3</source>
        <translation>在步骤 %1（%2）停止：%3</translation>
    </message>
    <message>
        <source>Stopped before the first step: %1</source>
        <translation>在第一步之前停止：%1</translation>
    </message>
    <message>
        <source>Later steps use the variable “%1” from step %2 (%3). Start at that step or earlier.</source>
        <translation>后续步骤使用步骤 %2（%3）的变量“%1”。请从该步骤或之前开始。</translation>
    </message>
    <message>
        <source>Later steps depend on step %1 (%2). Start at that step or earlier.</source>
        <translation>后续步骤需要步骤 %1（%2）。请从该步骤或之前开始。</translation>
    </message>
    <message>
        <source>The preview does not reach this step. Select a different step.</source>
        <translation>预览未到达此步骤。请选择其他步骤。</translation>
    </message>
    <message>
        <source>The simulated program does not complete step %1 (%2).</source>
        <translation>仿真程序未完成步骤%1（%2）。</translation>
    </message>
    <message>
        <source>The arm has left the start position of step %1 (%2).</source>
        <translation>机械臂已离开步骤%1（%2）的起始位置。</translation>
    </message>
    <message>
        <source>The gripper may hold a part and would close again (%1).</source>
        <translation>夹爪可能夹有零件，并会再次闭合（%1）。</translation>
    </message>
    <message>
        <source>The gripper may have lost a part (%1).</source>
        <translation>夹爪可能已丢失零件（%1）。</translation>
    </message>
    <message>
        <source>%1 would turn on again.</source>
        <translation>%1会再次接通。</translation>
    </message>
    <message>
        <source>%1 would have a different value.</source>
        <translation>%1的值会不同。</translation>
    </message>
    <message>
        <source>The program would wait in step %1 (%2).</source>
        <translation>程序会在步骤%1（%2）处等待。</translation>
    </message>
    <message>
        <source>The program would fail in step %1 (%2).</source>
        <translation>程序会在步骤%1（%2）处失败。</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>检查已取消。</translation>
    </message>
    <message>
        <source>An analog output would have a different value.</source>
        <translation>某个模拟输出的值会不同。</translation>
    </message>
    <message>
        <source>A register would have a different value.</source>
        <translation>某个寄存器的值会不同。</translation>
    </message>
    <message>
        <source>The variable “%1” would have a different value.</source>
        <translation>变量“%1”的值会不同。</translation>
    </message>
    <message>
        <source>The TCP or the payload would differ.</source>
        <translation>TCP或有效负载会不同。</translation>
    </message>
    <message>
        <source>The program would run different steps.</source>
        <translation>程序会执行其他步骤。</translation>
    </message>
    <message>
        <source>The arm would end at a different position.</source>
        <translation>机械臂的最终位置会不同。</translation>
    </message>
    <message>
        <source>✔ Continue</source>
        <translation>✔ 继续</translation>
    </message>
    <message>
        <source>↩ Move back</source>
        <translation>↩ 移回</translation>
    </message>
    <message>
        <source>✖ Unsafe</source>
        <translation>✖ 不安全</translation>
    </message>
    <message>
        <source>Simulated, after a stop in this step:</source>
        <translation>仿真结果，在此步骤停止后：</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>未到达</translation>
    </message>
    <message>
        <source>can continue</source>
        <translation>可以继续</translation>
    </message>
    <message>
        <source>can continue after moving back</source>
        <translation>移回后可以继续</translation>
    </message>
    <message>
        <source>cannot continue safely</source>
        <translation>无法安全继续</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>保护性停止</translation>
    </message>
    <message>
        <source>Stop by the operator</source>
        <translation>操作员停止</translation>
    </message>
    <message>
        <source>Connection loss</source>
        <translation>连接中断</translation>
    </message>
    <message>
        <source>Power loss</source>
        <translation>断电</translation>
    </message>
    <message>
        <source>Simulated: the program cannot continue safely. %1</source>
        <translation>仿真：程序无法安全继续。%1</translation>
    </message>
    <message>
        <source>Simulated: the program can continue from step %1 (%2).</source>
        <translation>仿真：程序可以从步骤%1（%2）继续。</translation>
    </message>
    <message>
        <source>The stop was inside a force section, so the contact cannot be restored.</source>
        <translation>停止发生在力控段内，因此无法恢复接触。</translation>
    </message>
    <message>
        <source>The relative move is only partly complete.</source>
        <translation>相对移动只执行了一部分。</translation>
    </message>
    <message>
        <source>The URScript text was only partly executed.</source>
        <translation>URScript文本只执行了一部分。</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>严重程度</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>超时时间</translation>
    </message>
    <message>
        <source>A program cannot continue inside a section or a called program. The next run starts from the beginning.</source>
        <translation>程序无法在区段或被调用的程序内继续。下次运行从头开始。</translation>
    </message>
    <message>
        <source>A program cannot continue in the middle of this step. The next run starts from the beginning.</source>
        <translation>程序无法在此步骤的中途继续。下次运行从头开始。</translation>
    </message>
    <message>
        <source>paused on the robot</source>
        <translation>在机器人上暂停</translation>
    </message>
    <message>
        <source>the speed, acceleration or blend is not a number, or a time is set</source>
        <translation>速度、加速度或交融半径不是数字，或者设置了时间</translation>
    </message>
    <message>
        <source>not imported</source>
        <translation>未导入</translation>
    </message>
    <message>
        <source>%1, disabled</source>
        <translation>%1，已禁用</translation>
    </message>
    <message>
        <source>the program has no name</source>
        <translation>程序没有名称</translation>
    </message>
    <message>
        <source>the project already has a program &apos;%1&apos;; choose another name</source>
        <translation>项目中已有程序“%1”；请选择其他名称</translation>
    </message>
    <message>
        <source>the file is too large for a program</source>
        <translation>文件太大，不能作为程序</translation>
    </message>
    <message>
        <source>the file is not text in UTF-8</source>
        <translation>文件不是 UTF-8 文本</translation>
    </message>
    <message>
        <source>this line ends a block that was not opened</source>
        <translation>此行结束了一个未开始的块</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>the program contains a return</source>
        <translation>程序包含 return</translation>
    </message>
    <message>
        <source>the program has too many statements</source>
        <translation>程序的语句太多</translation>
    </message>
    <message>
        <source>the script of the steps does not compile</source>
        <translation>步骤的脚本无法编译</translation>
    </message>
    <message>
        <source>the program is too complex</source>
        <translation>程序过于复杂</translation>
    </message>
    <message>
        <source>the file contains no statements</source>
        <translation>文件不包含语句</translation>
    </message>
    <message>
        <source>the file contains %1 functions or parameters, but no statement that calls a function; add the call</source>
        <translation>文件包含 %1 个函数或参数，但没有调用函数的语句；请添加调用</translation>
    </message>
    <message>
        <source>the program contains no statements</source>
        <translation>程序不包含语句</translation>
    </message>
    <message>
        <source>Installation</source>
        <translation>安装设置</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>已禁用</translation>
    </message>
    <message>
        <source>In this project, programs begin with the TCP of the tool &apos;%1&apos;.</source>
        <translation>在此项目中，程序以工具“%1”的 TCP 开始。</translation>
    </message>
    <message>
        <source>The program does not set the TCP. Its waypoints require the TCP %1.</source>
        <translation>程序未设置 TCP。其路点需要 TCP %1。</translation>
    </message>
    <message>
        <source>the TCP applies until the end of the program</source>
        <translation>该 TCP 一直有效到程序结束</translation>
    </message>
    <message>
        <source>the program does not call this function</source>
        <translation>程序没有调用此函数</translation>
    </message>
    <message>
        <source>imported as a program</source>
        <translation>作为程序导入</translation>
    </message>
    <message>
        <source>part of a waypoint</source>
        <translation>路点的一部分</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a different model. Adapt the project to the robot first.</source>
        <translation>项目是用 %1 示教的，但机器人是其他型号。请先使项目适配该机器人。</translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>模拟：%1</translation>
    </message>
    <message>
        <source>Step %1 failed and ended the program.</source>
        <translation>步骤 %1 失败并结束了程序。</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>step numbers</comment>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>步骤 %1</translation>
    </message>
    <message>
        <source>steps %1</source>
        <translation>步骤 %1</translation>
    </message>
    <message>
        <source>The position of the arm is unknown because no robot data arrive. Check the connection to the robot.</source>
        <translation>未收到机器人数据，机械臂的位置未知。请检查与机器人的连接。</translation>
    </message>
    <message>
        <source>It is unknown whether the program completed, because robot data were missing at its end. Check the workpiece.</source>
        <translation>程序结束时缺少机器人数据，无法确定程序是否完成。请检查工件。</translation>
    </message>
    <message>
        <source>Last known step: %1 (%2). %3</source>
        <translation>最后已知的步骤：%1（%2）。%3</translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation>没有程序在运行。</translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation>程序已在机器人上暂停。请在示教器上恢复。</translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation>请先暂停程序。</translation>
    </message>
    <message>
        <source>Wait until the robot has confirmed the new value of “%1”.</source>
        <translation>请等待机器人确认“%1”的新值。</translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation>“%1”不是数字。请输入数字。</translation>
    </message>
    <message>
        <source>“%1” is not a whole number. Enter a number without decimals.</source>
        <translation>“%1”不是整数。请输入不带小数的数字。</translation>
    </message>
    <message>
        <source>“%1” is not True or False. Enter one of these values.</source>
        <translation>“%1”不是 True 或 False。请输入其中一个值。</translation>
    </message>
    <message>
        <source>List</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>矩阵</translation>
    </message>
    <message>
        <source>A URScript step in this program could move the arm after a change.</source>
        <translation>此程序中的 URScript 步骤可能在更改后移动机械臂。</translation>
    </message>
    <message>
        <source>Only numbers and True or False values can be changed.</source>
        <translation>只能更改数字以及 True 或 False 值。</translation>
    </message>
    <message>
        <source>The program has no variable “%1”.</source>
        <translation>程序没有变量“%1”。</translation>
    </message>
    <message>
        <source>Variable “%1”: %2 → %3</source>
        <translation>变量“%1”：%2 → %3</translation>
    </message>
    <message>
        <source>The robot did not confirm the new value of “%1”. Check the value in the list.</source>
        <translation>机器人未确认“%1”的新值。请检查列表中的值。</translation>
    </message>
    <message>
        <source>The robot does not report its variables. Wait until the connection is restored.</source>
        <translation>机器人未报告其变量。请等待连接恢复。</translation>
    </message>
    <message>
        <source>The recoverability check did not reach step %1 (%2). Check again with the inputs of the run to find out whether the program can continue.</source>
        <translation>可恢复性检查没有到达步骤 %1（%2）。请使用运行时的输入重新检查程序能否继续。</translation>
    </message>
    <message>
        <source>This variable is set by URScript text. Only variables of a “Set variable” step can be changed.</source>
        <translation>此变量由 URScript 文本设置。只能更改“设置变量”步骤的变量。</translation>
    </message>
    <message>
        <source>“%1” is not set. Select or enter a value.</source>
        <translation>未设置“%1”。请选择或输入一个值。</translation>
    </message>
    <message>
        <source>“%1” has an invalid value. Enter a different value.</source>
        <translation>“%1”的值无效。请输入其他值。</translation>
    </message>
    <message>
        <source>“%1” cannot contain steps. Move its steps to another section.</source>
        <translation>“%1”不能包含步骤。请将这些步骤移到其他区段。</translation>
    </message>
    <message>
        <source>A program cannot call itself. Select a different program.</source>
        <translation>程序不能调用自身。请选择其他程序。</translation>
    </message>
    <message>
        <source>Unexpected character “%1”. Remove this character.</source>
        <translation>意外的字符“%1”。请删除该字符。</translation>
    </message>
    <message>
        <source>“%1” cannot be part of an expression. Remove this word.</source>
        <translation>“%1”不能作为表达式的一部分。请删除该词。</translation>
    </message>
    <message>
        <source>The brackets do not match. Add or remove a bracket.</source>
        <translation>括号不匹配。请添加或删除括号。</translation>
    </message>
    <message>
        <source>a Message step cannot have this title</source>
        <translation>“消息”步骤不能使用此标题</translation>
    </message>
    <message>
        <source>the payload is not given as numbers in the permitted range</source>
        <translation>有效负载不是用允许范围内的数字给出的</translation>
    </message>
    <message>
        <source>the target cannot be stored as a waypoint or as the pose of a step</source>
        <translation>目标既不能作为路点，也不能作为步骤的位姿</translation>
    </message>
    <message>
        <source>the External Control node runs a script from another computer, which cannot be imported. Remove this node from the program.</source>
        <translation>External Control 节点运行另一台计算机的脚本，无法导入。请从程序中删除此节点。</translation>
    </message>
    <message>
        <source>the blocks are nested too deeply</source>
        <translation>块嵌套过深</translation>
    </message>
    <message>
        <source>a block extends beyond its node</source>
        <translation>某个块超出了其节点</translation>
    </message>
    <message>
        <source>the line contains several statements</source>
        <translation>同一行有多条语句</translation>
    </message>
    <message>
        <source>the block that begins on line %1 has no end</source>
        <translation>从第 %1 行开始的块没有结束</translation>
    </message>
    <message>
        <source>no step corresponds to this statement</source>
        <translation>没有步骤能生成此语句</translation>
    </message>
    <message>
        <source>The program uses output integer register 46 or 47, to which Tiller writes the number of the running step. Use different registers.</source>
        <translation>程序使用整数输出寄存器 46 或 47，而 Tiller 在其中写入正在运行的步骤编号。请使用其他寄存器。</translation>
    </message>
    <message>
        <source>a disabled node in a section that is imported as URScript text</source>
        <translation>文本部分中的已禁用节点</translation>
    </message>
    <message>
        <source>the condition cannot be used in a step</source>
        <translation>其条件不能作为步骤的条件</translation>
    </message>
    <message>
        <source>no step corresponds to a thread, or to a function with parameters or a result</source>
        <translation>带参数或返回值的函数以及线程没有对应的步骤</translation>
    </message>
    <message>
        <source>the type or the scope of the variable cannot be determined</source>
        <translation>无法确定变量的类型或作用域</translation>
    </message>
    <message>
        <source>%1. Save the program on the teach pendant and copy its .script file to the same folder, or change the program.</source>
        <translation>%1。请在示教器上保存程序，并将其 .script 文件复制到同一文件夹，或者修改程序。</translation>
    </message>
    <message>
        <source>The nodes cannot be imported: %1. The script saved by the teach pendant was imported instead.</source>
        <translation>无法转换节点：%1。已改为导入示教器保存的脚本。</translation>
    </message>
    <message>
        <source>%1. Complete the program on the teach pendant first.</source>
        <translation>%1。请先在示教器上完成程序。</translation>
    </message>
    <message>
        <source>ended on the robot (teach pendant, another client or halt)</source>
        <translation>在机器人上结束（示教器、其他客户端或 halt）</translation>
    </message>
    <message>
        <source>a program from another client has taken over</source>
        <translation>其他客户端的程序已接管机器人</translation>
    </message>
    <message>
        <source>The values of a program from another client cannot be changed.</source>
        <translation>无法更改其他客户端程序的值。</translation>
    </message>
    <message>
        <source>the statement is nested too deeply</source>
        <translation>嵌套过深</translation>
    </message>
    <message>
        <source>The program cannot pause before this step. Select a different step.</source>
        <translation>程序不能在此步骤前暂停。请选择其他步骤。</translation>
    </message>
    <message>
        <source>The move is only partly complete.</source>
        <translation>移动只执行了一部分。</translation>
    </message>
</context>
<context>
    <name>ProjectLock</name>
    <message>
        <source>%1 on %2</source>
        <translation>%2 上的 %1</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>进程 %1</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>其他程序</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>No robot connected. Choose a robot at the top left.</source>
        <translation>未连接机器人。请在左上角选择。</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>正在连接…</translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically.</source>
        <translation>没有来自机器人的数据。正在自动重连。</translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation>机器人数据延迟。正在等待新数据。</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>正在获取控制…</translation>
    </message>
    <message>
        <source>Not in control. Press “Take control” in the header.</source>
        <translation>未控制。请按页眉中的“获取控制”。</translation>
    </message>
    <message>
        <source>Robot data are out of date. Wait for new data.</source>
        <translation>机器人数据已过时。请等待新数据。</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>未连接机器人。请连接，或试用模拟器。</translation>
    </message>
    <message>
        <source>The arm is moving. Stop the arm first, then store the position.</source>
        <translation>机械臂正在运动。请先停止机械臂，再保存位置。</translation>
    </message>
</context>
<context>
    <name>RecordingChoice</name>
    <message>
        <source>A file name must not be empty or begin with a period.</source>
        <translation>文件名不能为空，也不能以点开头。</translation>
    </message>
    <message>
        <source>A file name cannot contain “%1”.</source>
        <translation>文件名不能包含“%1”。</translation>
    </message>
    <message>
        <source>This name is too long.</source>
        <translation>此名称太长。</translation>
    </message>
    <message>
        <source>Not a condition: “%1”. Examples: actual_TCP_force_2 &gt; 20, robot_mode = 7, actual_digital_input_bits:3 = 1, runtime_state changes.</source>
        <translation>“%1”不是条件。示例：actual_TCP_force_2 &gt; 20、robot_mode = 7、actual_digital_input_bits:3 = 1、runtime_state changes。</translation>
    </message>
    <message>
        <source>There is no signal “%1”. Vectors have one signal per number, such as actual_q_0.</source>
        <translation>没有信号“%1”。向量的每个数值对应一个信号，例如 actual_q_0。</translation>
    </message>
</context>
<context>
    <name>RecoveryGuide</name>
    <message>
        <source>Safety mode is Normal again</source>
        <translation>安全模式已恢复“正常”</translation>
    </message>
    <message>
        <source>The arm can be moved. Motions interrupted by the stop do not resume. Press the button again for each motion.</source>
        <translation>机械臂可以移动。停止前的运动不会恢复：每次运动都需要重新按下。</translation>
    </message>
    <message>
        <source>The arm is ready. Take control to move the arm, or continue on the teach pendant.</source>
        <translation>机械臂已就绪。获取控制以移动它，或在示教器上继续。</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>正在获取控制…</translation>
    </message>
    <message>
        <source>No data from the robot</source>
        <translation>没有来自机器人的数据</translation>
    </message>
    <message>
        <source>Waiting for the connection…</source>
        <translation>等待连接…</translation>
    </message>
    <message>
        <source>I have inspected the arm. No one is touching it, and nothing is trapped.</source>
        <translation>我已检查机械臂。没有人触碰它，也没有东西被夹住。</translation>
    </message>
    <message>
        <source>The cause of the stop is known and has been removed.</source>
        <translation>停止的原因已知并已消除。</translation>
    </message>
    <message>
        <source>Payload and TCP match the mounted tool.</source>
        <translation>有效负载和 TCP 与所装工具一致。</translation>
    </message>
    <message>
        <source>Unlocking is available in %1 s</source>
        <translation>%1 s 后可解锁</translation>
    </message>
    <message>
        <source>I have inspected the arm and the robot&apos;s log, and I know the cause.</source>
        <translation>我已检查机械臂和机器人的日志，并且知道原因。</translation>
    </message>
    <message>
        <source>The cause has been removed, and no one is within reach of the arm.</source>
        <translation>原因已消除，机械臂可达范围内没有人。</translation>
    </message>
    <message>
        <source>No action is needed in Tiller. This state ends when the cause is removed.</source>
        <translation>无需在 Tiller 中操作。原因消除后此状态即结束。</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>解锁</translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation>重启安全</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>上电</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>松开制动器</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>获取控制</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>Replay</name>
    <message>
        <source>REPLAY</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>history at %1 s</source>
        <translation>历史记录 %1 s 处</translation>
    </message>
    <message>
        <source>at %1 s in %2</source>
        <translation>%2 的 %1 s 处</translation>
    </message>
</context>
<context>
    <name>RetracePath</name>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation>没有可返回的路径。请先点动机械臂。</translation>
    </message>
</context>
<context>
    <name>RobotActions</name>
    <message>
        <source>Connect to a robot first.</source>
        <translation>请先连接机器人。</translation>
    </message>
    <message>
        <source>Give control back first.</source>
        <translation>请先交还控制。</translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation>机器人上没有程序运行。</translation>
    </message>
    <message>
        <source>A program is already running.</source>
        <translation>已有程序在运行。</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>连接…</translation>
    </message>
    <message>
        <source>Select the simulator, a robot or a project.</source>
        <translation>选择模拟器、机器人或项目。</translation>
    </message>
    <message>
        <source>Simulated robot</source>
        <translation>模拟机器人</translation>
    </message>
    <message>
        <source>Starts the simulated robot and connects to it.</source>
        <translation>启动模拟机器人并连接它。</translation>
    </message>
    <message>
        <source>Check the connection…</source>
        <translation>检查连接…</translation>
    </message>
    <message>
        <source>Select a robot first.</source>
        <translation>请先选择机器人。</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>断开</translation>
    </message>
    <message>
        <source>Stops Tiller&apos;s motion, then closes the connection.</source>
        <translation>停止 Tiller 的运动，然后关闭连接。</translation>
    </message>
    <message>
        <source>No robot is connected.</source>
        <translation>没有连接机器人。</translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation>给机械臂上电。制动器保持抱紧。</translation>
    </message>
    <message>
        <source>The arm is powered on or powering on.</source>
        <translation>机械臂已上电或正在上电。</translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation>机械臂可能下沉几毫米。请保持距离。</translation>
    </message>
    <message>
        <source>Stops programs, engages the brakes and powers the arm off.</source>
        <translation>停止程序，抱紧制动器并切断机械臂电源。</translation>
    </message>
    <message>
        <source>The arm is powered off.</source>
        <translation>机械臂已断电。</translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation>恢复…</translation>
    </message>
    <message>
        <source>Shows the cause of the stop and the recovery steps.</source>
        <translation>显示机械臂停止的原因和恢复步骤。</translation>
    </message>
    <message>
        <source>The safety system reports no stop.</source>
        <translation>安全系统没有报告停止。</translation>
    </message>
    <message>
        <source>Resets the safety system after a violation or fault. The arm stays powered off.</source>
        <translation>在违规或故障后重置安全系统。机械臂保持断电。</translation>
    </message>
    <message>
        <source>Available only after a safety violation or fault.</source>
        <translation>仅在安全违规或安全故障后可用。</translation>
    </message>
    <message>
        <source>Closes the popups on the teach pendant.</source>
        <translation>关闭示教器上的弹窗。</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>获取控制</translation>
    </message>
    <message>
        <source>Already in control.</source>
        <translation>已获取控制。</translation>
    </message>
    <message>
        <source>Give control back</source>
        <translation>交还控制</translation>
    </message>
    <message>
        <source>Ends the control program on the robot.</source>
        <translation>结束机器人上的控制程序。</translation>
    </message>
    <message>
        <source>Not in control.</source>
        <translation>未控制。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Software stop of all motion. Not an emergency stop.</source>
        <translation>所有运动的软件停止。不是紧急停止。</translation>
    </message>
    <message>
        <source>Load program…</source>
        <translation>加载程序…</translation>
    </message>
    <message>
        <source>Loads a program on the robot by name.</source>
        <translation>按名称加载机器人上的程序。</translation>
    </message>
    <message>
        <source>Starts the loaded program or resumes the paused program. The arm may move immediately.</source>
        <translation>启动已加载的程序，或继续已暂停的程序：机械臂可能立即移动。</translation>
    </message>
    <message>
        <source>Pauses the running program.</source>
        <translation>暂停正在运行的程序。</translation>
    </message>
    <message>
        <source>Stops the program on the robot.</source>
        <translation>停止机器人上的程序。</translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation>在机器人上启动控制程序。停止其他程序前会先询问。</translation>
    </message>
    <message>
        <source>Checks the connection between this PC and the robot and suggests fixes.</source>
        <translation>检查本 PC 与机器人之间的连接，并给出解决办法。</translation>
    </message>
</context>
<context>
    <name>RobotOutputs</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Output %1: %2</source>
        <translation>输出 %1：%2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>%1: on</source>
        <translation>%1：开</translation>
    </message>
    <message>
        <source>%1: off</source>
        <translation>%1：关</translation>
    </message>
    <message>
        <source>Analog output %1: %2 %3</source>
        <translation>模拟输出 %1：%2 %3</translation>
    </message>
    <message>
        <source>Input int register %1</source>
        <translation>整数输入寄存器 %1</translation>
    </message>
    <message>
        <source>Speed slider: %1 %</source>
        <translation>速度滑块：%1 %</translation>
    </message>
    <message>
        <source>%1: on for %2 s</source>
        <translation>%1：接通 %2 s</translation>
    </message>
    <message>
        <source>%1: off for %2 s</source>
        <translation>%1：断开 %2 s</translation>
    </message>
    <message>
        <source>The robot times pulses only while Tiller is in control. Take control first, or switch the output on and off manually.</source>
        <translation>仅当 Tiller 取得控制时，机器人才为脉冲计时。请先获取控制，或手动打开和关闭输出。</translation>
    </message>
    <message>
        <source>The robot did not end the pulse on %1 because the program on the robot was stopped or paused. Tiller switches the output off.</source>
        <translation>由于程序被停止或暂停，机器人未结束 %1 的脉冲。Tiller 将关闭该输出。</translation>
    </message>
    <message>
        <source>Input float register %1</source>
        <translation>浮点输入寄存器 %1</translation>
    </message>
    <message>
        <source>Input bit register %1</source>
        <translation>位输入寄存器 %1</translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation>速度滑块</translation>
    </message>
    <message>
        <source>The robot cannot time pulses while a program is running. Stop the program first, or switch the output on and off manually.</source>
        <translation>程序运行期间，机器人无法控制脉冲时间。请先停止程序，或手动打开和关闭输出。</translation>
    </message>
</context>
<context>
    <name>RobotServices</name>
    <message>
        <source>%1 failed. %2</source>
        <translation>%1 失败。%2</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>上电</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>松开制动器</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>断电</translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation>重启安全</translation>
    </message>
    <message>
        <source>Close popups</source>
        <translation>关闭弹窗</translation>
    </message>
    <message>
        <source>Play program</source>
        <translation>播放程序</translation>
    </message>
    <message>
        <source>Pause program</source>
        <translation>暂停程序</translation>
    </message>
    <message>
        <source>Stop program</source>
        <translation>停止程序</translation>
    </message>
    <message>
        <source>Protective stop unlocked by the operator</source>
        <translation>操作员已解锁保护性停止</translation>
    </message>
    <message>
        <source>Load program %1</source>
        <translation>加载程序 %1</translation>
    </message>
    <message>
        <source>The program on the robot was stopped.</source>
        <translation>机器人上的程序已停止。</translation>
    </message>
    <message>
        <source>The program on the robot could not be stopped. Stop the program on the teach pendant. %1</source>
        <translation>无法停止机器人上的程序：请在示教器上停止。%1</translation>
    </message>
    <message>
        <source>The robot was switched to Local control: the motion was stopped and control was given back. Switch the robot to Remote control on the teach pendant, then take control again.</source>
        <translation>机器人已切换到本地控制：动作已停止，控制已交还。请在示教器上切换到远程控制，然后再次获取控制。</translation>
    </message>
    <message>
        <source>Unlock protective stop</source>
        <translation>解锁保护性停止</translation>
    </message>
    <message>
        <source>The robot sends no data, so a stop may not reach the robot. Press the emergency stop if the arm must stop.</source>
        <translation>机器人没有发送数据，停止指令可能无法到达。如果必须停止机械臂，请按紧急停止按钮。</translation>
    </message>
</context>
<context>
    <name>RobotTooling</name>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller 未取得控制。请先获取控制。</translation>
    </message>
    <message>
        <source>TCP and payload can be set only at standstill. Wait until the arm has stopped.</source>
        <translation>TCP 和有效负载只能在静止时设置。请等待机械臂停止。</translation>
    </message>
    <message>
        <source>TCP set on the robot: %1</source>
        <translation>已在机器人上设定 TCP：%1</translation>
    </message>
    <message>
        <source>Payload set on the robot: %1</source>
        <translation>已在机器人上设定有效负载：%1</translation>
    </message>
</context>
<context>
    <name>SampleProjects</name>
    <message>
        <source>Pick and place</source>
        <translation>取放</translation>
    </message>
    <message>
        <source>Picks a part from a feeder and places it in one of six tray cells. The cells are defined in the frame of the tray and move with it.</source>
        <translation>从供料器取工件，放入六个料盘格位之一。格位在料盘坐标系中定义，随其移动。</translation>
    </message>
    <message>
        <source>Gluing along a path</source>
        <translation>沿路径涂胶</translation>
    </message>
    <message>
        <source>Applies a bead around a lid with rounded corners in slow, straight moves. Blends keep the nozzle moving through the corners.</source>
        <translation>沿圆角盖的周边以直线缓慢涂胶。交融使喷嘴在拐角处保持运动。</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>A probe touches a part from above and from four sides. Each touch starts at an approach waypoint with the tool tilted.</source>
        <translation>测头从上方和四个侧面接触工件。每次接触都从接近点开始，工具倾斜。</translation>
    </message>
</context>
<context>
    <name>SceneActions</name>
    <message>
        <source>Default view (perspective)</source>
        <translation>默认视图（透视）</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>从正面看</translation>
    </message>
    <message>
        <source>Base X to the right, Z up.</source>
        <translation>基座的 X 向右，Z 向上。</translation>
    </message>
    <message>
        <source>Look from the side</source>
        <translation>从侧面看</translation>
    </message>
    <message>
        <source>Base Y to the right, Z up.</source>
        <translation>基座的 Y 向右，Z 向上。</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>从上方看</translation>
    </message>
    <message>
        <source>Base X to the right, Y up.</source>
        <translation>基座的 X 向右，Y 向上。</translation>
    </message>
    <message>
        <source>Fit everything in the view</source>
        <translation>将全部纳入视图</translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view without changing the viewing direction.</source>
        <translation>不改变观察方向，将机械臂、目标和路点纳入画面。</translation>
    </message>
    <message>
        <source>Shows the arm diagonally from the front, slightly from above, and fits everything in the view.</source>
        <translation>从斜前方略高处显示机械臂，并使全部内容适合视图。</translation>
    </message>
</context>
<context>
    <name>SessionRecording</name>
    <message>
        <source>Cannot record: connect to a robot first.</source>
        <translation>无法录制：请先连接机器人。</translation>
    </message>
    <message>
        <source>Recording to %1</source>
        <translation>正在录制到 %1</translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n rows to %1</source>
        <translation>
            <numerusform>已录制 %n 行到 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording continues without notes. %1</source>
        <translation>录制继续，但不含备注。%1</translation>
    </message>
    <message>
        <source>Not recorded, because the robot does not accept a second connection: %1</source>
        <translation>未记录，因为机器人拒绝第二个连接：%1</translation>
    </message>
    <message numerus="yes">
        <source>The recording has gaps: %n packets are missing.</source>
        <translation>
            <numerusform>记录有间断：缺少 %n 个数据包。</numerusform>
        </translation>
    </message>
    <message>
        <source>The current recording does not contain %1. Start a new recording to record displayed signals.</source>
        <translation>当前记录不包含 %1。要记录显示的信号，请开始新的记录。</translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. These signals are not recorded: %1</source>
        <translation>机器人无法同时发送这么多信号。未录制的信号：%1</translation>
    </message>
    <message>
        <source>Waiting for the trigger %1 to record to %2</source>
        <translation>正在等待触发条件 %1，然后记录到 %2</translation>
    </message>
    <message>
        <source>The trigger has not occurred. No file was written.</source>
        <translation>触发条件未出现，没有写入文件。</translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n files; the last one is %1</source>
        <translation>
            <numerusform>已记录 %n 个文件；最后一个是 %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SettingsFile</name>
    <message>
        <source>Invalid value for the setting “%1”.</source>
        <translation>设置“%1”的值无效。</translation>
    </message>
    <message>
        <source>The file is too large for a settings file.</source>
        <translation>文件过大，不是设置文件。</translation>
    </message>
    <message>
        <source>The file is damaged at byte %1: %2.</source>
        <translation>文件在字节 %1 处损坏：%2。</translation>
    </message>
    <message>
        <source>The file contains no Tiller settings.</source>
        <translation>文件中没有 Tiller 设置。</translation>
    </message>
    <message>
        <source>The file was written by a newer version of Tiller. Update Tiller to import the file.</source>
        <translation>文件由更新版本的 Tiller 写入。请更新 Tiller 后再导入。</translation>
    </message>
    <message>
        <source>The file contains no version number.</source>
        <translation>文件中没有版本号。</translation>
    </message>
    <message>
        <source>The list of settings is missing or too long.</source>
        <translation>文件中没有设置列表，或列表太长。</translation>
    </message>
    <message>
        <source>“%1” is not a valid setting name.</source>
        <translation>“%1”不是有效的设置名称。</translation>
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
        <translation>关节</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>输入和输出</translation>
    </message>
    <message>
        <source>Modes and states</source>
        <translation>模式与状态</translation>
    </message>
    <message>
        <source>Power and temperature</source>
        <translation>电力与温度</translation>
    </message>
    <message>
        <source>Speed and program</source>
        <translation>速度与程序</translation>
    </message>
    <message>
        <source>Payload and tool</source>
        <translation>有效负载与工具</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>寄存器</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>TCP 处的力</translation>
    </message>
    <message>
        <source>TCP torque</source>
        <translation>TCP 处的力矩</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>TCP 位置</translation>
    </message>
    <message>
        <source>TCP rotation vector</source>
        <translation>TCP 旋转矢量</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>TCP 速度</translation>
    </message>
    <message>
        <source>TCP angular speed</source>
        <translation>TCP 旋转速度</translation>
    </message>
    <message>
        <source>TCP acceleration</source>
        <translation>TCP 加速度</translation>
    </message>
    <message>
        <source>Target TCP position</source>
        <translation>TCP 目标位置</translation>
    </message>
    <message>
        <source>Target TCP rotation vector</source>
        <translation>TCP 目标旋转矢量</translation>
    </message>
    <message>
        <source>Target TCP speed</source>
        <translation>TCP 目标速度</translation>
    </message>
    <message>
        <source>Target TCP angular speed</source>
        <translation>TCP 目标旋转速度</translation>
    </message>
    <message>
        <source>Raw sensor force</source>
        <translation>传感器原始力</translation>
    </message>
    <message>
        <source>Raw sensor torque</source>
        <translation>传感器原始力矩</translation>
    </message>
    <message>
        <source>TCP force, norm</source>
        <translation>TCP 处的力，模</translation>
    </message>
    <message>
        <source>Tool accelerometer</source>
        <translation>法兰加速度计</translation>
    </message>
    <message>
        <source>Elbow position</source>
        <translation>肘部位置</translation>
    </message>
    <message>
        <source>Elbow speed</source>
        <translation>肘部速度</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>动量</translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation>关节位置</translation>
    </message>
    <message>
        <source>Joint speeds</source>
        <translation>关节速度</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>关节电流</translation>
    </message>
    <message>
        <source>Joint temperatures</source>
        <translation>关节温度</translation>
    </message>
    <message>
        <source>Joint voltages</source>
        <translation>关节电压</translation>
    </message>
    <message>
        <source>Target joint positions</source>
        <translation>目标关节位置</translation>
    </message>
    <message>
        <source>Target joint speeds</source>
        <translation>目标关节速度</translation>
    </message>
    <message>
        <source>Target joint accelerations</source>
        <translation>目标关节加速度</translation>
    </message>
    <message>
        <source>Target joint currents</source>
        <translation>目标关节电流</translation>
    </message>
    <message>
        <source>Target joint torques</source>
        <translation>目标关节力矩</translation>
    </message>
    <message>
        <source>Joint control currents</source>
        <translation>关节控制电流</translation>
    </message>
    <message>
        <source>Allowed current deviation</source>
        <translation>电流允许偏差</translation>
    </message>
    <message>
        <source>Position deviation, ratio to limit</source>
        <translation>位置偏差与极限之比</translation>
    </message>
    <message>
        <source>Collision detection, ratio to limit</source>
        <translation>碰撞检测与极限之比</translation>
    </message>
    <message>
        <source>Joint modes</source>
        <translation>关节模式</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>数字输入</translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation>数字输出</translation>
    </message>
    <message>
        <source>Analog input 0</source>
        <translation>模拟输入 0</translation>
    </message>
    <message>
        <source>Analog input 1</source>
        <translation>模拟输入 1</translation>
    </message>
    <message>
        <source>Analog output 0</source>
        <translation>模拟输出 0</translation>
    </message>
    <message>
        <source>Analog output 1</source>
        <translation>模拟输出 1</translation>
    </message>
    <message>
        <source>Tool analog input 0</source>
        <translation>工具模拟输入 0</translation>
    </message>
    <message>
        <source>Tool analog input 1</source>
        <translation>工具模拟输入 1</translation>
    </message>
    <message>
        <source>Robot mode</source>
        <translation>机器人模式</translation>
    </message>
    <message>
        <source>Safety mode</source>
        <translation>安全模式</translation>
    </message>
    <message>
        <source>Safety status</source>
        <translation>安全状态</translation>
    </message>
    <message>
        <source>Program state</source>
        <translation>程序状态</translation>
    </message>
    <message>
        <source>Robot status</source>
        <translation>机器人状态</translation>
    </message>
    <message>
        <source>Safety bits</source>
        <translation>安全位</translation>
    </message>
    <message>
        <source>Tool mode</source>
        <translation>工具模式</translation>
    </message>
    <message>
        <source>Main voltage</source>
        <translation>主电压</translation>
    </message>
    <message>
        <source>Arm voltage</source>
        <translation>机械臂电压</translation>
    </message>
    <message>
        <source>Arm current</source>
        <translation>机械臂电流</translation>
    </message>
    <message>
        <source>I/O current</source>
        <translation>I/O 电流</translation>
    </message>
    <message>
        <source>Tool temperature</source>
        <translation>工具温度</translation>
    </message>
    <message>
        <source>Tool voltage</source>
        <translation>工具电压</translation>
    </message>
    <message>
        <source>Tool current</source>
        <translation>工具电流</translation>
    </message>
    <message>
        <source>Speed scaling</source>
        <translation>速度缩放</translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation>速度滑块</translation>
    </message>
    <message>
        <source>Control step time</source>
        <translation>控制步时间</translation>
    </message>
    <message>
        <source>Script line</source>
        <translation>脚本行</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>控制器时间</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>有效负载</translation>
    </message>
    <message>
        <source>Payload centre of gravity</source>
        <translation>有效负载重心</translation>
    </message>
    <message>
        <source>TCP offset</source>
        <translation>TCP 偏移</translation>
    </message>
    <message>
        <source>TCP rotation</source>
        <translation>TCP 旋转</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>上电</translation>
    </message>
    <message>
        <source>Program running</source>
        <translation>程序运行中</translation>
    </message>
    <message>
        <source>Freedrive button</source>
        <translation>自由驱动按钮</translation>
    </message>
    <message>
        <source>Power button</source>
        <translation>电源按钮</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>缩减</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>保护性停止</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>防护停止</translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation>系统紧急停止</translation>
    </message>
    <message>
        <source>Robot emergency stop</source>
        <translation>机器人紧急停止</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>紧急停止</translation>
    </message>
    <message>
        <source>Violation</source>
        <translation>违规</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Enabling device</source>
        <translation>使能装置</translation>
    </message>
    <message>
        <source>Bit %1</source>
        <translation>位 %1</translation>
    </message>
    <message>
        <source>Output registers, floats</source>
        <translation>输出寄存器，浮点</translation>
    </message>
    <message>
        <source>Input registers, floats</source>
        <translation>输入寄存器，浮点</translation>
    </message>
    <message>
        <source>Output registers, integers</source>
        <translation>输出寄存器，整数</translation>
    </message>
    <message>
        <source>Input registers, integers</source>
        <translation>输入寄存器，整数</translation>
    </message>
    <message>
        <source>Output registers, bits</source>
        <translation>输出寄存器，位</translation>
    </message>
    <message>
        <source>Input registers, bits</source>
        <translation>输入寄存器，位</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Stopped due to safety</source>
        <translation>被安全停止</translation>
    </message>
</context>
<context>
    <name>SpaceMouse</name>
    <message>
        <source>left button</source>
        <translation>左按钮</translation>
    </message>
    <message>
        <source>The tool follows the motion of the cap.</source>
        <translation>工具跟随帽盖的运动。</translation>
    </message>
</context>
<context>
    <name>Spectrum</name>
    <message>
        <source>compute a spectrum</source>
        <translation>计算频谱</translation>
    </message>
    <message>
        <source>The range contains fewer than %1 samples. Select a longer range.</source>
        <translation>采样少于 %1 个：请选择更长的范围。</translation>
    </message>
    <message>
        <source>Values are missing in this range. Select a range without gaps.</source>
        <translation>此范围内缺少数值：请选择没有缺口的范围。</translation>
    </message>
    <message>
        <source>Not enough memory. Select a shorter range.</source>
        <translation>内存不足：请选择较短的范围。</translation>
    </message>
</context>
<context>
    <name>StartProject</name>
    <message>
        <source>The last project no longer exists: %1</source>
        <translation>上次的项目已不存在：%1</translation>
    </message>
</context>
<context>
    <name>StateLane</name>
    <message>
        <source>Protective stop</source>
        <translation>保护性停止</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>防护停止</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>紧急停止</translation>
    </message>
    <message>
        <source>Enabling device released</source>
        <translation>使能装置松开</translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation>安全违规</translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation>安全故障</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>断电</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>启动中</translation>
    </message>
    <message>
        <source>Brakes on</source>
        <translation>制动器抱紧</translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation>反向驱动</translation>
    </message>
    <message>
        <source>Not running</source>
        <translation>未运行</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>自由驱动</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation>点动 %1</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>运动中</translation>
    </message>
    <message>
        <source>At standstill</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>Late data</source>
        <translation>数据延迟</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Enter an IP address, such as 192.168.0.10, or a host name.</source>
        <translation>请输入 IP 地址（例如 192.168.0.10）或主机名。</translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and this PC is on the same network.</source>
        <translation>检查机器人已开机、网线已插好、本 PC 在同一网络中。</translation>
    </message>
    <message>
        <source>Enable the interface on the robot under Settings &gt; Security &gt; Services. A robot that has just started may need another minute.</source>
        <translation>在机器人的“设置 &gt; 安全 &gt; 服务”中打开接口。刚启动的机器人可能还需要一分钟。</translation>
    </message>
    <message>
        <source>The robot may be restarting or switching between Local and Remote control. Wait a minute, then connect again.</source>
        <translation>机器人可能正在重启，或在本地与远程之间切换。请等待一分钟后重新连接。</translation>
    </message>
    <message>
        <source>The robot does not respond. Check the cable and the address.</source>
        <translation>机器人不应答。请检查网线和地址。</translation>
    </message>
    <message>
        <source>No more data received. Check the cable. Tiller reconnects automatically; motion does not resume.</source>
        <translation>不再收到数据。请检查网线。Tiller 会自动重连；运动不会恢复。</translation>
    </message>
    <message>
        <source>The response is not valid for this protocol. Check the address and the port.</source>
        <translation>响应不符合协议。请检查地址和端口。</translation>
    </message>
    <message>
        <source>If newer software is available for this robot, update the robot.</source>
        <translation>如果此机器人有更新的软件版本，请更新机器人。</translation>
    </message>
    <message>
        <source>The robot&apos;s software does not provide this value.</source>
        <translation>机器人的软件不提供此数值。</translation>
    </message>
    <message>
        <source>Another program or a fieldbus on the robot uses these registers. Close the other program, or disable the fieldbus in the installation.</source>
        <translation>另一个程序或机器人上的现场总线占用这些寄存器：关闭该程序，或在安装设置中关闭现场总线。</translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation>请先连接机器人。</translation>
    </message>
    <message>
        <source>Take control first.</source>
        <translation>请先获取控制。</translation>
    </message>
    <message>
        <source>Power on the arm, release the brakes and clear any safety stop first.</source>
        <translation>请先给机械臂上电、松开制动器并解除安全停止。</translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant.</source>
        <translation>在示教器右上角把机器人切换到远程控制。</translation>
    </message>
    <message>
        <source>Choose a target within the reach of the arm and a speed below the speed cap.</source>
        <translation>选择机械臂范围内的目标和上限内的速度。</translation>
    </message>
    <message>
        <source>The arm cannot reach this pose. Move the target closer or rotate the tool.</source>
        <translation>机械臂无法到达此位姿：把点移近或转动工具。</translation>
    </message>
    <message>
        <source>The robot could not run the program. See the log for the controller&apos;s message.</source>
        <translation>机器人无法运行程序。控制器的消息见日志。</translation>
    </message>
    <message>
        <source>Check that the file exists and that you have permission to read it.</source>
        <translation>检查文件是否存在且可读。</translation>
    </message>
    <message>
        <source>Choose a folder that you have permission to write to.</source>
        <translation>选择一个可以写入的文件夹。</translation>
    </message>
    <message>
        <source>The file was not changed. Open a backup, or repair the file at the reported position.</source>
        <translation>文件未更改。请打开备份，或修复报告的位置。</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Address not found</source>
        <translation>找不到地址</translation>
    </message>
    <message>
        <source>Robot not reachable</source>
        <translation>无法到达机器人</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>连接被拒绝</translation>
    </message>
    <message>
        <source>Connection closed by the robot</source>
        <translation>机器人关闭了连接</translation>
    </message>
    <message>
        <source>Timed out</source>
        <translation>超时</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>连接中断</translation>
    </message>
    <message>
        <source>Protocol error</source>
        <translation>协议错误</translation>
    </message>
    <message>
        <source>Not supported by this robot</source>
        <translation>此机器人不支持</translation>
    </message>
    <message>
        <source>Value not available</source>
        <translation>数值不可用</translation>
    </message>
    <message>
        <source>Registers in use</source>
        <translation>寄存器被占用</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation>未控制</translation>
    </message>
    <message>
        <source>Robot not ready</source>
        <translation>机器人未就绪</translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation>机器人处于本地控制</translation>
    </message>
    <message>
        <source>Outside the limits</source>
        <translation>超出极限</translation>
    </message>
    <message>
        <source>Invalid value</source>
        <translation>无效值</translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation>不可达</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Refused by the robot</source>
        <translation>被机器人拒绝</translation>
    </message>
    <message>
        <source>Program error on the robot</source>
        <translation>机器人上的程序错误</translation>
    </message>
    <message>
        <source>Cannot read the file</source>
        <translation>无法读取文件</translation>
    </message>
    <message>
        <source>Cannot write the file</source>
        <translation>无法写入文件</translation>
    </message>
    <message>
        <source>File is damaged</source>
        <translation>文件已损坏</translation>
    </message>
    <message>
        <source>Disk full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>Internal error</source>
        <translation>内部错误</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>已结束</translation>
    </message>
    <message>
        <source>button or key released</source>
        <translation>已松开按钮或按键</translation>
    </message>
    <message>
        <source>pointer left the button</source>
        <translation>指针离开按钮</translation>
    </message>
    <message>
        <source>focus lost</source>
        <translation>失去焦点</translation>
    </message>
    <message>
        <source>another window became active</source>
        <translation>另一个窗口变为活动窗口</translation>
    </message>
    <message>
        <source>window closed</source>
        <translation>窗口已关闭</translation>
    </message>
    <message>
        <source>a dialog or menu opened</source>
        <translation>打开了对话框或菜单</translation>
    </message>
    <message>
        <source>another button or key pressed</source>
        <translation>按下了另一个按钮或按键</translation>
    </message>
    <message>
        <source>Esc pressed</source>
        <translation>按下 Esc</translation>
    </message>
    <message>
        <source>Space pressed</source>
        <translation>按下空格键</translation>
    </message>
    <message>
        <source>STOP pressed</source>
        <translation>按下 STOP</translation>
    </message>
    <message>
        <source>input device lost</source>
        <translation>输入设备丢失</translation>
    </message>
    <message>
        <source>robot data arrived too late</source>
        <translation>机器人数据太旧</translation>
    </message>
    <message>
        <source>robot or safety mode changed</source>
        <translation>机器人或安全模式改变</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>连接中断</translation>
    </message>
    <message>
        <source>limit reached</source>
        <translation>到达极限</translation>
    </message>
    <message>
        <source>control lost</source>
        <translation>失去控制</translation>
    </message>
    <message>
        <source>target reached</source>
        <translation>到达目标</translation>
    </message>
    <message>
        <source>stopped by a program</source>
        <translation>被程序停止</translation>
    </message>
    <message>
        <source>contact detected</source>
        <translation>检测到接触</translation>
    </message>
    <message>
        <source>target cannot be reached</source>
        <translation>目标无法到达</translation>
    </message>
    <message>
        <source>could not verify that the button or key is still pressed</source>
        <translation>无法确认按钮或按键仍被按下</translation>
    </message>
    <message>
        <source>maximum hold time reached; press again</source>
        <translation>已达到最长按住时间；请重新按下</translation>
    </message>
    <message>
        <source>PolyScope X before 10.11 does not accept these commands over the network. Use the teach pendant.</source>
        <translation>10.11 之前的 PolyScope X 不接受通过网络发送的这些命令：请使用示教器。</translation>
    </message>
    <message>
        <source>PolyScope X cannot close popups over the network. Use the teach pendant.</source>
        <translation>PolyScope X 无法通过网络关闭弹窗：请使用示教器。</translation>
    </message>
    <message>
        <source>Monitoring. Take control to move the arm.</source>
        <translation>仅监视。获取控制以移动机械臂。</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>正在获取控制…</translation>
    </message>
    <message>
        <source>Control was given back. Take control to move the arm.</source>
        <translation>控制已交还。获取控制以移动机械臂。</translation>
    </message>
    <message>
        <source>The control program on the robot was stopped. Take control again.</source>
        <translation>控制程序在机器人上被停止。请再次获取控制。</translation>
    </message>
    <message>
        <source>The control program was replaced or does not respond. Take control again.</source>
        <translation>控制程序已被替换或不应答。请再次获取控制。</translation>
    </message>
    <message>
        <source>The connection was lost. Take control again.</source>
        <translation>链路已中断。请再次获取控制。</translation>
    </message>
    <message>
        <source>Your script is running. Tiller regains control when the script ends.</source>
        <translation>您的脚本正在运行。结束后 Tiller 恢复控制。</translation>
    </message>
    <message>
        <source>Free some space on the disk, then save or record again.</source>
        <translation>请释放一些磁盘空间，然后重新保存或录制。</translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. Turn off “Monitor only” in Settings, or start Tiller without --monitor-only.</source>
        <translation>仅监视：此窗口不更改机器人的任何状态。请在设置中关闭“仅监视”，或不带 --monitor-only 启动 Tiller。</translation>
    </message>
    <message>
        <source>No current data from the robot. Check the network connection to the robot.</source>
        <translation>没有收到机器人的最新数据。请检查与机器人的网络连接。</translation>
    </message>
    <message>
        <source>selection or modifier key changed</source>
        <translation>选择或修饰键已改变</translation>
    </message>
    <message>
        <source>the window did not respond</source>
        <translation>窗口无响应</translation>
    </message>
    <message>
        <source>not measured: no data during the stop</source>
        <translation>未测量：停止期间无数据</translation>
    </message>
    <message>
        <source>not measured: another program is moving the arm</source>
        <translation>未测量：另一个程序正在移动机械臂</translation>
    </message>
    <message>
        <source>the PC is going to sleep</source>
        <translation>PC 将休眠</translation>
    </message>
    <message>
        <source>the robot did not receive the stop command</source>
        <translation>机器人未收到停止指令</translation>
    </message>
    <message>
        <source>servo target too far from the previous target</source>
        <translation>伺服目标距前一个目标太远</translation>
    </message>
</context>
<context>
    <name>WaypointClipboard</name>
    <message>
        <source>the value is missing</source>
        <translation>缺少值</translation>
    </message>
    <message>
        <source>“%1” is not a number</source>
        <translation>“%1”不是数字</translation>
    </message>
    <message>
        <source>%1 is outside the range %2 to %3</source>
        <translation>%1 超出 %2 至 %3</translation>
    </message>
    <message>
        <source>Line %1, column “%2”: %3.</source>
        <translation>第 %1 行，“%2”列：%3。</translation>
    </message>
    <message>
        <source>“%1” must be “J” or “L”</source>
        <translation>“%1”必须是“J”或“L”</translation>
    </message>
    <message>
        <source>“%1” must be “joints” or “pose”</source>
        <translation>“%1”必须是“joints”或“pose”</translation>
    </message>
    <message>
        <source>the project has no frame named “%1”</source>
        <translation>此项目中没有坐标系“%1”</translation>
    </message>
    <message>
        <source>The text is not a table of waypoints. Copy a waypoint from the list to see the columns, or use the six values of a pose.</source>
        <translation>这不是路点表。从列表复制一个以查看其列，或粘贴一个位姿的六个数字。</translation>
    </message>
    <message>
        <source>“%1” is not a waypoint colour (none, blue, orange, green, pink, yellow or sky)</source>
        <translation>“%1”不是路点的颜色（none、blue、orange、green、pink、yellow 或 sky）</translation>
    </message>
</context>
<context>
    <name>WaypointExchange</name>
    <message>
        <source>Line %1: the closing quotation mark is missing.</source>
        <translation>第 %1 行：缺少右引号。</translation>
    </message>
</context>
<context>
    <name>tiller::ActionsDialog</name>
    <message>
        <source>Actions at “%1”</source>
        <translation>“%1”处的动作</translation>
    </message>
    <message numerus="yes">
        <source>Actions at %n waypoints</source>
        <translation>
            <numerusform>%n 个路点处的动作</numerusform>
        </translation>
    </message>
    <message>
        <source>“Run route (hold)” runs these actions in order at the waypoint while the button is held.</source>
        <translation>“运行路线”到达路点时，在按住按钮期间按此顺序执行动作。</translation>
    </message>
    <message>
        <source>These waypoints have different actions. “Apply” replaces them all with the actions below.</source>
        <translation>这些路点的动作各不相同。“应用”会将它们全部替换为下面的动作。</translation>
    </message>
    <message>
        <source>Actions in order</source>
        <translation>按顺序的动作</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove the selected action</source>
        <translation>移除所选动作</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Move the selected action up</source>
        <translation>上移所选动作</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Move the selected action down</source>
        <translation>下移所选动作</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>Terminal</source>
        <translation>端子</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>超时</translation>
    </message>
    <message>
        <source>After this time, the action fails with a message. With 0, the action waits while the button is held, up to one hour.</source>
        <translation>超过此时间则等待失败并显示消息。0：按住按钮期间等待，最长一小时。</translation>
    </message>
    <message>
        <source>Add an action after the selected action</source>
        <translation>在所选动作之后添加动作</translation>
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
        <translation>%1 范围</translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation>%1 数值</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>设定</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>设定 %1</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Scale…</source>
        <translation>缩放…</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>%1 的名称</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>%1 的比例</translation>
    </message>
    <message>
        <source>e.g. bar; empty: no scaling</source>
        <translation>例如 bar；空：不换算</translation>
    </message>
    <message>
        <source>At 4 mA or 0 V</source>
        <translation>4 mA 或 0 V 时</translation>
    </message>
    <message>
        <source>At 20 mA or 10 V</source>
        <translation>20 mA 或 10 V 时</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>%1: %2
To rename or scale the signal, right-click it, or press F2 or Shift+F2.</source>
        <translation>%1：%2
按 F2 重命名，Shift+F2 缩放，或右键单击。</translation>
    </message>
</context>
<context>
    <name>tiller::ArmKey</name>
    <message>
        <source>Keyboard armed</source>
        <translation>键盘已启用</translation>
    </message>
    <message>
        <source>Arm keyboard</source>
        <translation>启用键盘</translation>
    </message>
    <message>
        <source>While the keyboard is armed, holding an arrow key moves the arm. A border around the window shows that the keyboard is armed.</source>
        <translation>键盘启用后，按住方向键时移动机械臂。窗口四周的边框表示键盘已启用。</translation>
    </message>
    <message>
        <source>Arrow keys move along X and Y, PgUp and PgDn along Z; with Alt, they rotate the tool. Hold 1 to 6 and press + or − to move a joint. Space and Esc stop the arm. To disarm the keyboard, click this button or wait 30 s.</source>
        <translation>方向键移动 X 和 Y，PgUp 和 PgDn 移动 Z；加 Alt 旋转。1 至 6 加 + 和 − 转动关节。Space 和 Esc 停止。点击或等待 30 秒可停用键盘。</translation>
    </message>
</context>
<context>
    <name>tiller::CellPage</name>
    <message>
        <source>Size %1</source>
        <translation>尺寸 %1</translation>
    </message>
    <message>
        <source>Shown and checked for collisions</source>
        <translation>显示并进行碰撞检查</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Enter a name for the box or plane.</source>
        <translation>请输入长方体或平面的名称。</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>将“%1”重命名为“%2”</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>No boxes or planes yet.
Move the TCP to a corner of an obstacle and press “Teach corner”.</source>
        <translation>还没有长方体或平面。
将 TCP 移到障碍物的一个角，然后按“此处为角”。</translation>
    </message>
    <message>
        <source>Check for collisions</source>
        <translation>检查碰撞</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Centre of the box. Press Return to apply the values. Only the box changes; the robot does not move.</source>
        <translation>长方体的中心。按回车应用。只有长方体改变；机器人不移动。</translation>
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
        <translation>长方体</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>添加“%1”</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>First corner recorded</source>
        <translation>已记录第一个角</translation>
    </message>
    <message>
        <source>Move the TCP to the opposite corner and press “Teach corner 2”.</source>
        <translation>将 TCP 移到对角，然后按“另一个角”。</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>The corners must differ by at least 1 mm along X, Y and Z. Move the TCP to the opposite corner of the box.</source>
        <translation>两个角在 X、Y、Z 方向上必须各相差至少 1 mm。请将 TCP 移到长方体的对角。</translation>
    </message>
    <message>
        <source>Move “%1”</source>
        <translation>移动“%1”</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>复制“%1”</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>删除“%1”</translation>
    </message>
    <message>
        <source>Set the floor</source>
        <translation>设置地面</translation>
    </message>
    <message>
        <source>Remove the floor</source>
        <translation>移除地面</translation>
    </message>
    <message>
        <source>Change the safety distance</source>
        <translation>更改安全距离</translation>
    </message>
    <message>
        <source>Teach corner 2</source>
        <translation>另一个角</translation>
    </message>
    <message>
        <source>Teach corner</source>
        <translation>此处为角</translation>
    </message>
    <message>
        <source>%1 · %2 in %3</source>
        <translation>%1 · %3 中的 %2</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Length along X</source>
        <translation>沿 X 的长度</translation>
    </message>
    <message>
        <source>Length along Y</source>
        <translation>沿 Y 的长度</translation>
    </message>
    <message>
        <source>Length along Z</source>
        <translation>沿 Z 的长度</translation>
    </message>
    <message>
        <source>Point on the plane, X</source>
        <translation>平面上的点，X</translation>
    </message>
    <message>
        <source>Point on the plane, Y</source>
        <translation>平面上的点，Y</translation>
    </message>
    <message>
        <source>Point on the plane, Z</source>
        <translation>平面上的点，Z</translation>
    </message>
    <message>
        <source>Normal X, towards the arm</source>
        <translation>法线 X，朝向机械臂</translation>
    </message>
    <message>
        <source>Normal Y, towards the arm</source>
        <translation>法线 Y，朝向机械臂</translation>
    </message>
    <message>
        <source>Normal Z, towards the arm</source>
        <translation>法线 Z，朝向机械臂</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>When off, the box or plane is neither shown nor checked for collisions.</source>
        <translation>关闭时不显示该长方体或平面，也不进行碰撞检查。</translation>
    </message>
    <message>
        <source>Horizontal plane in the base frame that the arm must stay above.</source>
        <translation>基座坐标系中机械臂必须保持在其上方的水平面。</translation>
    </message>
    <message>
        <source>Floor height</source>
        <translation>地面高度</translation>
    </message>
    <message>
        <source>Safety distance</source>
        <translation>安全距离</translation>
    </message>
    <message>
        <source>Jogging stops at this distance from objects in the cell and between parts of the arm. Moves that would bring the arm closer are refused.</source>
        <translation>点动在距单元以及机械臂各部分之间达到此距离时停止。更接近的运动会被拒绝。</translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation>TCP 处</translation>
    </message>
    <message>
        <source>Set the floor to the TCP height</source>
        <translation>将地面设为 TCP 高度</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Teach a box corner at the TCP</source>
        <translation>将长方体的角设在 TCP</translation>
    </message>
    <message>
        <source>Teach plane</source>
        <translation>此处为平面</translation>
    </message>
    <message>
        <source>Add a plane through the TCP, perpendicular to the tool</source>
        <translation>添加过 TCP 且垂直于工具的平面</translation>
    </message>
    <message>
        <source>New box</source>
        <translation>新建长方体</translation>
    </message>
    <message>
        <source>Add a box numerically</source>
        <translation>按数值添加长方体</translation>
    </message>
    <message>
        <source>Add a plane through the TCP</source>
        <translation>添加过 TCP 的平面</translation>
    </message>
    <message>
        <source>Add a plane numerically</source>
        <translation>按数值添加平面</translation>
    </message>
    <message>
        <source>Move the box or plane to the TCP</source>
        <translation>将长方体或平面移到 TCP</translation>
    </message>
    <message>
        <source>Rename box or plane</source>
        <translation>重命名长方体或平面</translation>
    </message>
    <message>
        <source>Duplicate box or plane</source>
        <translation>复制长方体或平面</translation>
    </message>
    <message>
        <source>Delete box or plane</source>
        <translation>删除长方体或平面</translation>
    </message>
    <message>
        <source>Resize “%1”</source>
        <translation>调整“%1”的大小</translation>
    </message>
    <message>
        <source>The normal must not be zero. Enter at least one nonzero component.</source>
        <translation>法线不能为零。请先输入一个分量。</translation>
    </message>
    <message>
        <source>Rotate “%1”</source>
        <translation>旋转“%1”</translation>
    </message>
    <message>
        <source>missing frame</source>
        <translation>缺少坐标系</translation>
    </message>
    <message>
        <source>Turn on the collision check of “%1”</source>
        <translation>打开“%1”的碰撞检查</translation>
    </message>
    <message>
        <source>Turn off the collision check of “%1”</source>
        <translation>关闭“%1”的碰撞检查</translation>
    </message>
    <message>
        <source>Turn collision check on or off</source>
        <translation>打开或关闭碰撞检查</translation>
    </message>
    <message>
        <source>The cell already contains “%1”. Choose a different name.</source>
        <translation>单元中已有“%1”。请选择其他名称。</translation>
    </message>
</context>
<context>
    <name>tiller::ChecklistItem</name>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>not done yet</source>
        <translation>未完成</translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonBand</name>
    <message>
        <source>Comparison with the arm model</source>
        <translation>与机械臂模型的比较</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>比较…</translation>
    </message>
    <message>
        <source>Compare this recording with the arm model using different limits</source>
        <translation>用其他限值将此录制与机械臂模型比较</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Go to time</source>
        <translation>转到时刻</translation>
    </message>
    <message>
        <source>Cancel the comparison</source>
        <translation>取消比较</translation>
    </message>
    <message>
        <source>Place cursor A where the arm and the model diverge</source>
        <translation>将游标 A 置于机械臂与模型出现偏差处</translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonDialog</name>
    <message>
        <source>Compare with the arm model</source>
        <translation>与机械臂模型比较</translation>
    </message>
    <message>
        <source>The simulated arm follows the recorded joint targets, and its motion is compared with the recorded motion. The model includes neither contact nor friction.</source>
        <translation>模拟机械臂跟随录制的关节目标，并将其运动与录制的运动比较。模型不包含接触和摩擦。</translation>
    </message>
    <message>
        <source>Arm model</source>
        <translation>机械臂模型</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation>关节位置</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>TCP 位置</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>关节电流</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>TCP 力</translation>
    </message>
    <message>
        <source>Signals with a limit of 0 are not compared.</source>
        <translation>限值为 0 的信号不参与比较。</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Minimum duration</source>
        <translation>最短持续时间</translation>
    </message>
</context>
<context>
    <name>tiller::CurveDialog</name>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Displayed value = value × scale + offset</source>
        <translation>显示值 = 值 × 比例 + 偏移</translation>
    </message>
    <message>
        <source>Choose the colour</source>
        <translation>选择颜色</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Automatic colour</source>
        <translation>自动颜色</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>线型</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>实线</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>虚线</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>点线</translation>
    </message>
    <message>
        <source>Value axis</source>
        <translation>数值轴</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>请输入名称。</translation>
    </message>
    <message>
        <source>Name and unit cannot contain = [ ].</source>
        <translation>名称和单位不能包含 = [ ]。</translation>
    </message>
    <message>
        <source>Enter a number other than 0 as the scale.</source>
        <translation>请输入非 0 的数值作为比例。</translation>
    </message>
    <message>
        <source>Enter a number as the offset.</source>
        <translation>请输入数值作为偏移。</translation>
    </message>
</context>
<context>
    <name>tiller::DecimalSpinBox</name>
    <message>
        <source>“%1” is out of range (%2 to %3). The value is still %4.</source>
        <translation>“%1”超出范围（%2 到 %3）。当前值仍为 %4。</translation>
    </message>
</context>
<context>
    <name>tiller::DeviceTrainer</name>
    <message>
        <source>Enable motion (until Tiller is closed)</source>
        <translation>移动机械臂（直到关闭 Tiller）</translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation>仅主轴</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation>手柄与 SpaceMouse</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Direction in which the arm would move</source>
        <translation>机械臂将移动的方向</translation>
    </message>
    <message>
        <source>Hold-to-run</source>
        <translation>使能键</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation>未找到手柄或 SpaceMouse。连接后会自动检测到。</translation>
    </message>
    <message>
        <source>● held (%1)</source>
        <translation>● 已按住（%1）</translation>
    </message>
    <message>
        <source>○ not held: hold the %1</source>
        <translation>○ 未按住：请按住%1</translation>
    </message>
    <message>
        <source>none (neutral)</source>
        <translation>无（中立）</translation>
    </message>
    <message>
        <source>With the keyboard armed (Ctrl+J): arrow keys for X and Y; PgUp and PgDn for Z; Alt with these keys for rotation; 1 to 6 with + and − for joints; Home for the home position; End to align; Backspace to move back; F for Freedrive; Ctrl for slower; Shift for faster. Space and Esc stop the arm.</source>
        <translation>键盘（启用时，Ctrl+J）：方向键：X 和 Y；PgUp、PgDn：Z；加 Alt：旋转；1 至 6 加 + 和 −：关节；Home：原位；End：对齐；Backspace：返回；F：自由驱动；Ctrl：更慢；Shift：更快。Space 和 Esc 停止。</translation>
    </message>
</context>
<context>
    <name>tiller::EmptyState</name>
    <message>
        <source>Nothing found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>Nothing found with these filters.</source>
        <translation>以这些过滤条件未找到。</translation>
    </message>
    <message>
        <source>Nothing found for “%1”.
Clear the search to see everything.</source>
        <translation>未找到“%1”。
清空搜索以查看全部。</translation>
    </message>
</context>
<context>
    <name>tiller::FirstSteps</name>
    <message>
        <source>Power on (header)</source>
        <translation>上电（页眉）</translation>
    </message>
    <message>
        <source>Release brakes (header)</source>
        <translation>松开制动器（页眉）</translation>
    </message>
    <message>
        <source>Take control and hold a jog button</source>
        <translation>获取控制，按住点动按钮</translation>
    </message>
    <message>
        <source>Teach here (T)</source>
        <translation>在此示教 (T)</translation>
    </message>
    <message>
        <source>Jog away and hold “Go to” (G)</source>
        <translation>点动离开，按住“前往” (G)</translation>
    </message>
    <message>
        <source>Record (above the plots)</source>
        <translation>录制（曲线图上方）</translation>
    </message>
</context>
<context>
    <name>tiller::FirstStepsCard</name>
    <message>
        <source>First steps</source>
        <translation>第一步</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>练习任务</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>The list will not appear again. Use the command “First steps” to reopen it.</source>
        <translation>该列表不会再次出现。使用命令“第一步”可重新打开它。</translation>
    </message>
    <message>
        <source>First steps · %1 of %2</source>
        <translation>第一步 · %1 / %2</translation>
    </message>
</context>
<context>
    <name>tiller::FrameDetails</name>
    <message>
        <source>Selected frame</source>
        <translation>所选坐标系</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>In the base frame. Press Return to apply the values. Only the frame changes; the robot does not move.</source>
        <translation>基座坐标系中的值。按回车应用。只有坐标系改变；机器人不移动。</translation>
    </message>
    <message>
        <source>not used by any waypoint</source>
        <translation>未被任何路点使用</translation>
    </message>
    <message numerus="yes">
        <source>used by %n waypoints</source>
        <translation>
            <numerusform>被 %n 个路点使用</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the TCP</source>
        <translation>距 TCP %1</translation>
    </message>
</context>
<context>
    <name>tiller::FrameEditing</name>
    <message>
        <source>No waypoints moved with the frame.</source>
        <translation>没有路点随其移动。</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints moved with the frame.</source>
        <translation>
            <numerusform>%n 个路点随其移动了。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Waypoints out of reach: %n.</source>
        <translation>
            <numerusform>不可达的路点：%n 个。</numerusform>
        </translation>
    </message>
    <message>
        <source>frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>示教“%1”</translation>
    </message>
    <message>
        <source>The frame moves by %1 (%2, base frame).</source>
        <translation>坐标系移动 %1（%2，基座坐标系）。</translation>
    </message>
    <message>
        <source>No waypoint uses this frame.</source>
        <translation>没有路点使用此坐标系。</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints move with the frame.</source>
        <translation>
            <numerusform>%n 个路点随其移动。</numerusform>
        </translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>修正示教“%1”？</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>修正示教</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>修正示教“%1”</translation>
    </message>
    <message>
        <source>Touched up “%1”</source>
        <translation>已修正示教“%1”</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>复制“%1”</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>删除“%1”？</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints use this frame. They keep their positions and are converted to Base.</source>
        <translation>
            <numerusform>%n 个路点使用此坐标系。它们保持位置，并转换到基座坐标系。</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation>删除坐标系</translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation>更改“%1”的位姿</translation>
    </message>
    <message>
        <source>The pose of “%1” was changed. %2</source>
        <translation>“%1”的位姿已更改。%2</translation>
    </message>
</context>
<context>
    <name>tiller::FrameModel</name>
    <message>
        <source>Enter a name for the frame.</source>
        <translation>请输入坐标系的名称。</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>将“%1”重命名为“%2”</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>原点 %1</translation>
    </message>
    <message>
        <source>Origin in Base, X Y Z, %1</source>
        <translation>基座中的原点，X Y Z，%1</translation>
    </message>
    <message>
        <source>Rotation, rad</source>
        <translation>旋转 rad</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Rotation vector in Base, radians</source>
        <translation>基座中的旋转矢量，弧度</translation>
    </message>
    <message>
        <source>Roll, pitch and yaw in Base</source>
        <translation>基座中的横滚、俯仰、偏航</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Waypoints that move with the frame</source>
        <translation>随坐标系移动的路点</translation>
    </message>
    <message>
        <source>TCP %1</source>
        <translation>TCP %1</translation>
    </message>
    <message>
        <source>Distance from the TCP, %1</source>
        <translation>与 TCP 的距离，%1</translation>
    </message>
    <message>
        <source>“%1” is a built-in frame. Choose a different name.</source>
        <translation>“%1”是内置坐标系。请选择其他名称。</translation>
    </message>
    <message>
        <source>A frame named “%1” already exists. Choose a different name.</source>
        <translation>“%1”已是另一个坐标系的名称。请选择其他名称。</translation>
    </message>
</context>
<context>
    <name>tiller::FrameTable</name>
    <message>
        <source>Frames</source>
        <translation>坐标系</translation>
    </message>
</context>
<context>
    <name>tiller::FrameTeacher</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Frame from three points</source>
        <translation>三点坐标系</translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation>取消坐标系</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>On +X</source>
        <translation>在 +X 上</translation>
    </message>
    <message>
        <source>Towards +Y</source>
        <translation>朝 +Y</translation>
    </message>
    <message>
        <source>Record the origin at the TCP</source>
        <translation>在此取原点</translation>
    </message>
    <message>
        <source>Record the point on +X at the TCP</source>
        <translation>在此取 +X 上的点</translation>
    </message>
    <message>
        <source>Record the point towards +Y at the TCP</source>
        <translation>在此取朝 +Y 的点</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>取点</translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation>创建坐标系</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the point again.</source>
        <translation>机器人没有发送有效位置。请重新取点。</translation>
    </message>
    <message>
        <source>The point on +X is only %1 from the origin. Record it again at least %2 away. A larger distance gives more accurate axes.</source>
        <translation>+X 上的点距原点仅 %1。请重新取，至少 %2：越远，轴越准。</translation>
    </message>
    <message>
        <source>The third point is only %1 from the origin. Record the point again at least %2 away.</source>
        <translation>第三点距原点仅 %1。请重新取，至少 %2。</translation>
    </message>
    <message>
        <source>The three points are collinear: the third point is only %1 from the X axis. Record the point again at least %2 towards +Y.</source>
        <translation>三点在一条线上：第三点距 X 轴仅 %1。请重新取，向 +Y 侧至少 %2。</translation>
    </message>
    <message>
        <source>Ready: the point on +X is %1 from the origin, and the third point is %2 from the X axis.</source>
        <translation>就绪：+X 上的点距 %1，第三点距 X 轴 %2。</translation>
    </message>
    <message>
        <source>Jog the tip to the origin of the frame and record the point (P).</source>
        <translation>将尖端点动到坐标系的原点并取点 (P)。</translation>
    </message>
    <message>
        <source>Now jog to a point on +X: %1 from the origin (minimum %2).</source>
        <translation>现在到 +X 上的一点：距原点 %1，最少 %2。</translation>
    </message>
    <message>
        <source>Now jog towards +Y: %1 from the X axis (minimum %2).</source>
        <translation>现在到 +Y 一侧：距 X 轴 %1，最少 %2。</translation>
    </message>
    <message>
        <source>Record  P</source>
        <translation>取点  P</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重取</translation>
    </message>
</context>
<context>
    <name>tiller::FramesTab</name>
    <message>
        <source>Frames</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>From TCP</source>
        <translation>从 TCP</translation>
    </message>
    <message>
        <source>Teach a frame from the TCP</source>
        <translation>从 TCP 示教坐标系</translation>
    </message>
    <message>
        <source>3 points</source>
        <translation>三点</translation>
    </message>
    <message>
        <source>Teach a frame from three points</source>
        <translation>用三点示教坐标系</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>修正示教</translation>
    </message>
    <message>
        <source>Touch up the frame</source>
        <translation>修正示教坐标系</translation>
    </message>
    <message>
        <source>More frame commands</source>
        <translation>更多坐标系命令</translation>
    </message>
    <message>
        <source>No frames yet.
Jog the tip to a corner of the tray or table. Press “From TCP”, or press “3 points” to record the origin, +X and +Y.</source>
        <translation>还没有坐标系。
把尖端点动到托盘或桌子的一角。按“从 TCP”，或按“三点”取原点、+X 和 +Y。</translation>
    </message>
    <message>
        <source>new frame</source>
        <translation>新坐标系</translation>
    </message>
    <message>
        <source>Create a frame at the TCP with the axes of the tool (Shift+T)</source>
        <translation>在 TCP 处以工具轴创建坐标系 (Shift+T)</translation>
    </message>
    <message>
        <source>Create a frame from its origin, a point on +X and a point towards +Y (Ctrl+Shift+T)</source>
        <translation>由原点、+X 上的点和朝 +Y 的点创建坐标系 (Ctrl+Shift+T)</translation>
    </message>
    <message>
        <source>Move the selected frame to the TCP (Shift+U)</source>
        <translation>将所选坐标系移到 TCP 处 (Shift+U)</translation>
    </message>
    <message>
        <source>Select a frame to touch up.</source>
        <translation>选择要修正示教的坐标系。</translation>
    </message>
    <message>
        <source>Teach frame from the TCP</source>
        <translation>从 TCP 示教坐标系</translation>
    </message>
    <message>
        <source>Teach frame from three points</source>
        <translation>用三点示教坐标系</translation>
    </message>
    <message>
        <source>Record the next point of the frame</source>
        <translation>取坐标系的下一点</translation>
    </message>
    <message>
        <source>Create frame from points</source>
        <translation>由点创建坐标系</translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation>取消坐标系示教</translation>
    </message>
    <message>
        <source>Touch up frame from the TCP</source>
        <translation>从 TCP 修正示教坐标系</translation>
    </message>
    <message>
        <source>Touch up frame from three points</source>
        <translation>用三点修正示教坐标系</translation>
    </message>
    <message>
        <source>Jog in this frame</source>
        <translation>在此坐标系中点动</translation>
    </message>
    <message>
        <source>Rename frame</source>
        <translation>重命名坐标系</translation>
    </message>
    <message>
        <source>Duplicate frame</source>
        <translation>复制坐标系</translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation>删除坐标系</translation>
    </message>
    <message>
        <source>Touch up “%1” from three points</source>
        <translation>用三点修正示教“%1”</translation>
    </message>
    <message>
        <source>New frame from three points</source>
        <translation>三点新坐标系</translation>
    </message>
    <message>
        <source>Touch up…</source>
        <translation>修正示教…</translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation>创建坐标系</translation>
    </message>
    <message>
        <source>Edit frame values</source>
        <translation>编辑坐标系数值</translation>
    </message>
</context>
<context>
    <name>tiller::GoThroughBar</name>
    <message>
        <source>Loop</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Run the route</source>
        <translation>运行路线</translation>
    </message>
    <message>
        <source>Run route (hold)</source>
        <translation>运行路线（按住）</translation>
    </message>
    <message>
        <source>Run route, hold</source>
        <translation>运行路线，按住</translation>
    </message>
    <message>
        <source>Previous waypoint, hold</source>
        <translation>上一个路点，按住</translation>
    </message>
    <message>
        <source>Moves to the previous waypoint while the button is held</source>
        <translation>按住时返回上一个路点</translation>
    </message>
    <message>
        <source>Next waypoint, hold</source>
        <translation>下一个路点，按住</translation>
    </message>
    <message>
        <source>Moves to the next waypoint while the button is held, then stops</source>
        <translation>按住时前往下一个路点，并停在那里</translation>
    </message>
    <message>
        <source>Route waypoints</source>
        <translation>路线的路点</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>哪些路点</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>从此处</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>所选</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>After the last waypoint, continues with the first waypoint while the button is held</source>
        <translation>按住按钮期间，到达最后一个路点后从第一个重新开始</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller 未取得控制。请先获取控制。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Next: %1 of %2, %3</source>
        <translation>下一个：%1 / %2，%3</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>Done. The next press starts at the first waypoint.</source>
        <translation>完成。下次按下从第一个开始。</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n 个路点</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Moves from waypoint to waypoint while the button is held, no faster than the jog speed, and runs the actions of each waypoint. Release to pause; the next press continues to the next waypoint.</source>
        <translation>按住按钮时依次前往各路点，速度不超过点动速度，并在每处执行规定的动作。松开即暂停；再次按下则继续前往下一个路点。</translation>
    </message>
    <message>
        <source>At %1: %2</source>
        <translation>在 %1：%2</translation>
    </message>
    <message>
        <source>Selects the waypoints to run, in list order</source>
        <translation>按列表顺序选择路线的路点</translation>
    </message>
</context>
<context>
    <name>tiller::GoToButton</name>
    <message>
        <source>Go to (hold)  G</source>
        <translation>前往（按住）  G</translation>
    </message>
    <message>
        <source>Go to, hold</source>
        <translation>前往，按住</translation>
    </message>
    <message>
        <source>Moves the arm to the selected waypoint while the button or G is held, no faster than the jog speed</source>
        <translation>按住按钮或 G 时把机械臂移到所选路点，不快于点动速度</translation>
    </message>
</context>
<context>
    <name>tiller::GripperPanel</name>
    <message>
        <source>Gripper state</source>
        <translation>夹爪状态</translation>
    </message>
    <message>
        <source>Gripper opening</source>
        <translation>夹爪开度</translation>
    </message>
    <message>
        <source>Gripped object</source>
        <translation>夹持的物体</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>激活</translation>
    </message>
    <message>
        <source>Activate the gripper</source>
        <translation>激活夹爪</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation>打开夹爪</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation>关闭夹爪</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>夹爪</translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation>夹爪：打开</translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation>夹爪：关闭</translation>
    </message>
    <message>
        <source>Gripper: move to %1</source>
        <translation>夹爪：移动到 %1</translation>
    </message>
    <message>
        <source>Gripper type</source>
        <translation>夹爪类型</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Robotiq %1</source>
        <translation>Robotiq %1</translation>
    </message>
    <message>
        <source>One output: on = closed</source>
        <translation>一个输出：接通 = 关闭</translation>
    </message>
    <message>
        <source>Two outputs: open, close</source>
        <translation>两个输出：打开、关闭</translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation>关闭用输出</translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation>打开用输出</translation>
    </message>
    <message>
        <source>Target opening</source>
        <translation>目标开度</translation>
    </message>
    <message>
        <source>Finger speed</source>
        <translation>手指速度</translation>
    </message>
    <message>
        <source>Finger force</source>
        <translation>手指力</translation>
    </message>
    <message>
        <source>Suggested action</source>
        <translation>建议的操作</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>开度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Target opening of the fingers, 0 to %1. “Move” starts the motion.</source>
        <translation>手指的目标开度，0 至 %1。“移动”启动运动。</translation>
    </message>
    <message>
        <source>Speed of the next motion. 0 % is about %1, 100 % about %2.</source>
        <translation>下一个动作的速度。0 % 约 %1，100 % 约 %2。</translation>
    </message>
    <message>
        <source>Force of the next grip. 0 % is about %1, 100 % about %2.</source>
        <translation>下一次夹持的力。0 % 约 %1，100 % 约 %2。</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Gripper set to %1</source>
        <translation>夹爪设为：%1</translation>
    </message>
    <message>
        <source>%1 (speed %2, force %3)</source>
        <translation>%1（速度 %2，力 %3）</translation>
    </message>
    <message>
        <source>Please wait…</source>
        <translation>请稍候…</translation>
    </message>
    <message>
        <source>Select the mounted gripper. The choice is stored for this robot.</source>
        <translation>选择所安装的夹爪。选择会为此机器人保存。</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>activating…</source>
        <translation>正在激活…</translation>
    </message>
    <message>
        <source>not active</source>
        <translation>未激活</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>等待中…</translation>
    </message>
    <message>
        <source>active</source>
        <translation>已激活</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>移动中</translation>
    </message>
    <message>
        <source>active, at standstill</source>
        <translation>已激活，静止</translation>
    </message>
    <message>
        <source>unknown while moving</source>
        <translation>移动时未知</translation>
    </message>
    <message>
        <source>The gripper is not available with this port offset. Use a smaller port offset.</source>
        <translation>使用此端口偏移时夹爪不可用。请使用较小的端口偏移。</translation>
    </message>
    <message>
        <source>Activating: the fingers open and close once.</source>
        <translation>正在激活：手指开合一次。</translation>
    </message>
    <message>
        <source>Activate the gripper first.</source>
        <translation>请先激活夹爪。</translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation>夹爪已激活。</translation>
    </message>
    <message>
        <source>The fingers open and close once and drop any gripped object. Keep your fingers clear of the gripper.</source>
        <translation>手指开合一次；所夹物体会掉落。手指请勿放入夹爪。</translation>
    </message>
    <message>
        <source>Opens the gripper and releases the object.</source>
        <translation>打开夹爪；所夹物体会松开。</translation>
    </message>
    <message>
        <source>Closes the gripper. Keep your fingers clear of the gripper.</source>
        <translation>关闭夹爪。手指请勿放入。</translation>
    </message>
    <message>
        <source>The gripper did not execute the command. Check that no other program controls the gripper, then try again.</source>
        <translation>夹爪未执行命令。请确认没有其他程序控制夹爪，然后重试。</translation>
    </message>
    <message>
        <source>Gripper: stop</source>
        <translation>夹爪：停止</translation>
    </message>
    <message>
        <source>Move the fingers to the target opening</source>
        <translation>把手指移到目标开度</translation>
    </message>
    <message>
        <source>Closed by</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Opened by</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Connect to a robot first. Tiller stores the gripper selection for each robot.</source>
        <translation>请先连接机器人。Tiller 按机器人分别保存夹爪选择。</translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation>机器人没有发送数据。请等待数据，或重新连接。</translation>
    </message>
    <message>
        <source>external grip</source>
        <translation>外夹</translation>
    </message>
    <message>
        <source>internal grip</source>
        <translation>内夹</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Stopping the arm does not open the gripper.</source>
        <translation>机械臂停止时夹爪不会张开。</translation>
    </message>
    <message>
        <source>Moves the fingers to the target opening.</source>
        <translation>将手指移到目标开度。</translation>
    </message>
    <message>
        <source>Speed or force is out of range. Enter a value from 0 to 100 %.</source>
        <translation>速度或力超出范围。请输入 0 到 100 %。</translation>
    </message>
</context>
<context>
    <name>tiller::HeaderBar</name>
    <message>
        <source>ROBOT</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>ROBOT MODE</source>
        <translation>机器人模式</translation>
    </message>
    <message>
        <source>SAFETY</source>
        <translation>安全</translation>
    </message>
    <message>
        <source>CONTROL</source>
        <translation>控制</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>LAST STOP</source>
        <translation>上次停止</translation>
    </message>
    <message>
        <source>Robot state</source>
        <translation>机器人状态</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>LAST STOP · no key check</source>
        <translation>上次停止 · 无按键检查</translation>
    </message>
    <message>
        <source>%1 ms · %2</source>
        <translation>%1 ms · %2</translation>
    </message>
    <message>
        <source>Measured from the stop command to standstill. Cause: %1</source>
        <translation>从停止命令到静止的测量值。原因：%1</translation>
    </message>
    <message>
        <source>No stop measured yet</source>
        <translation>尚未测量停止</translation>
    </message>
    <message>
        <source>▲ Speed cap raised to %1</source>
        <translation>▲ 速度上限提高到 %1</translation>
    </message>
    <message>
        <source>The arm may move faster than %1. Lower the speed cap in Settings. The cap is reset when Tiller is closed.</source>
        <translation>机械臂可能快于 %1。请在设置中降低速度上限。关闭 Tiller 后上限会复位。</translation>
    </message>
    <message>
        <source>MONITOR ONLY</source>
        <translation>仅监视</translation>
    </message>
    <message>
        <source>Cause: %1 (%2)</source>
        <translation>原因：%1（%2）</translation>
    </message>
    <message>
        <source>The program was stopped on the robot, so the stop could not be measured.</source>
        <translation>程序在机器人上被停止，因此无法测量此次停止。</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>The robot stopped sending data while the arm was moving, so the stop could not be measured.</source>
        <translation>机械臂移动时机器人停止发送数据，无法测量停止过程。</translation>
    </message>
    <message>
        <source>Not stopped</source>
        <translation>未停止</translation>
    </message>
</context>
<context>
    <name>tiller::HoldRules</name>
    <message>
        <source>The window was not active. Press again.</source>
        <translation>窗口刚才不是活动窗口。请重新按下。</translation>
    </message>
    <message>
        <source>Click in the window first.</source>
        <translation>请先点击窗口内部。</translation>
    </message>
    <message>
        <source>A dialog or a menu is open. Close it first.</source>
        <translation>打开了对话框或菜单。请先关闭。</translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation>已按住另一个按钮或按键。请先松开。</translation>
    </message>
    <message>
        <source>The display server does not respond, so Tiller cannot detect the release of a button or key. Release the button or key, then try again.</source>
        <translation>显示服务器不响应：无法检测按钮或按键是否松开。请松开后重试。</translation>
    </message>
</context>
<context>
    <name>tiller::HoldToRunButton</name>
    <message>
        <source>hold</source>
        <translation>按住</translation>
    </message>
    <message>
        <source>Hold this button. The arm moves only while the button is held.</source>
        <translation>请按住此按钮：仅在按住时移动机械臂。</translation>
    </message>
</context>
<context>
    <name>tiller::ImportReport</name>
    <message>
        <source>Steps: %1. Kept as URScript text: %2. Not imported: %3. New waypoints: %4.</source>
        <translation>步骤：%1。保留为 URScript 文本：%2。未导入：%3。新路点：%4。</translation>
    </message>
    <message>
        <source>Imported program</source>
        <translation>导入的程序</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Node or statement</source>
        <translation>节点或语句</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Import report for “%1”</source>
        <translation>“%1”的导入报告</translation>
    </message>
</context>
<context>
    <name>tiller::IncidentWatch</name>
    <message>
        <source>protective stop</source>
        <translation>保护性停止</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>紧急停止</translation>
    </message>
    <message>
        <source>safety violation</source>
        <translation>安全违规</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>The incident (%1) could not be recorded.</source>
        <translation>无法录制事件（%1）。</translation>
    </message>
    <message>
        <source>Incident recorded: %1</source>
        <translation>事件已录制：%1</translation>
    </message>
    <message>
        <source>The recording %2 starts %1 s before the stop. Double-click this entry to open the recording.</source>
        <translation>录制 %2 从停止前 %1 s 开始。双击此条目可打开。</translation>
    </message>
</context>
<context>
    <name>tiller::IoChannel</name>
    <message>
        <source>no data</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>等待中…</translation>
    </message>
    <message>
        <source>%1, outdated</source>
        <translation>%1，已过时</translation>
    </message>
    <message>
        <source>Pulse</source>
        <translation>脉冲</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>%1 的名称</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>
The output cannot be switched while the robot is not sending data.</source>
        <translation>
没有来自机器人的数据时无法切换输出。</translation>
    </message>
    <message>
        <source>
Click to switch the output %1. Press P to pulse it. Right-click to pulse or rename it.</source>
        <translation>
点击切换：%1。P：脉冲。右键：脉冲、重命名。</translation>
    </message>
    <message>
        <source>
Right-click or press F2 to rename the input.</source>
        <translation>
右键单击或按 F2 重命名。</translation>
    </message>
</context>
<context>
    <name>tiller::IoPages</name>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>夹爪</translation>
    </message>
    <message>
        <source>I/O page</source>
        <translation>I/O 页面</translation>
    </message>
</context>
<context>
    <name>tiller::IoTab</name>
    <message>
        <source>Inputs and outputs</source>
        <translation>输入和输出</translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation>搜索输入和输出</translation>
    </message>
    <message>
        <source>Search by terminal or name</source>
        <translation>按端子或名称搜索</translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation>数字输出</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>数字输入</translation>
    </message>
    <message>
        <source>Configurable outputs</source>
        <translation>可配置输出</translation>
    </message>
    <message>
        <source>Configurable inputs</source>
        <translation>可配置输入</translation>
    </message>
    <message>
        <source>Tool outputs</source>
        <translation>工具输出</translation>
    </message>
    <message>
        <source>Tool inputs</source>
        <translation>工具输入</translation>
    </message>
    <message>
        <source>Press the Tab key to select a row on the I/O tab first.</source>
        <translation>请先用 Tab 键选择 I/O 选项卡的一行。</translation>
    </message>
    <message>
        <source>The robot did not confirm %1</source>
        <translation>机器人没有确认 %1</translation>
    </message>
    <message>
        <source>Analog</source>
        <translation>模拟量</translation>
    </message>
    <message>
        <source>General purpose registers</source>
        <translation>通用寄存器</translation>
    </message>
    <message>
        <source>Replay is active. Press “Back to live” first.</source>
        <translation>正在回放。请先按“返回实时”。</translation>
    </message>
    <message>
        <source>%1 cannot be pulsed now</source>
        <translation>现在无法对 %1 输出脉冲</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>已锁定</translation>
    </message>
    <message>
        <source>controlled by another program</source>
        <translation>由其他程序控制</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>Another program or the installation may control the output. Check both, then switch the output again.</source>
        <translation>可能由其他程序或安装设置控制。请检查两者，然后重新切换输出。</translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation>机器人没有发送数据。请等待数据，或重新连接。</translation>
    </message>
</context>
<context>
    <name>tiller::JogColumn</name>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Hold to move</source>
        <translation>按住移动</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Pose or joints</source>
        <translation>位姿或关节</translation>
    </message>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation>没有可返回的路径。请先点动机械臂。</translation>
    </message>
    <message>
        <source>release and press again</source>
        <translation>松开后重新按下</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>自由驱动</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>原位</translation>
    </message>
    <message>
        <source>Moves all joints to the home position while the button is held</source>
        <translation>按住时把所有关节移到原位</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>Aligns the tool with the nearest axis of the selected frame while the button is held</source>
        <translation>按住时使工具与所选坐标系最近的轴对齐</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Retraces the last motion while the button is held</source>
        <translation>按住时沿上一次运动的路径返回</translation>
    </message>
    <message>
        <source>home</source>
        <translation>已在原位</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>已对齐</translation>
    </message>
    <message>
        <source>Ends in %1 s</source>
        <translation>%1 s 后结束</translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation>已按住另一个按钮或按键。请先松开。</translation>
    </message>
    <message>
        <source>Last stop: %1, standstill after %2 ms, %3</source>
        <translation>上次停止：%1，%2 ms 后静止，%3</translation>
    </message>
    <message>
        <source>Move the arm by hand while this button is held: %1. Right-click to select axes.</source>
        <translation>按住此按钮时可用手移动机械臂：%1。右键选择轴。</translation>
    </message>
    <message>
        <source>Freedrive, %1</source>
        <translation>自由驱动，%1</translation>
    </message>
    <message>
        <source>Freedrive…</source>
        <translation>自由驱动…</translation>
    </message>
    <message>
        <source>Check payload before Freedrive (resets on reconnect)</source>
        <translation>自由驱动前检查有效负载（重新连接后重置）</translation>
    </message>
    <message>
        <source>Last stop: not measured (data lost)</source>
        <translation>上次停止：未测量（数据丢失）</translation>
    </message>
    <message>
        <source>Press for one step</source>
        <translation>按一次走一步</translation>
    </message>
    <message>
        <source>Last stop: %1 (%2)</source>
        <translation>上次停止：%1（%2）</translation>
    </message>
</context>
<context>
    <name>tiller::JogKey</name>
    <message>
        <source>%1 left in this direction</source>
        <translation>此方向剩余 %1</translation>
    </message>
</context>
<context>
    <name>tiller::JogPad</name>
    <message>
        <source>Jog buttons</source>
        <translation>点动按钮</translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation>点动 %1</translation>
    </message>
</context>
<context>
    <name>tiller::JogSelectors</name>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>按住</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>Moves while the button is held</source>
        <translation>按住时移动</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Rotates while the button is held</source>
        <translation>按住时旋转</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>View axes: X right, Y away from you, Z up</source>
        <translation>画面的轴：X 向右，Y 远离您，Z 向上</translation>
    </message>
    <message>
        <source>Requires the 3D view</source>
        <translation>需要 3D 视图</translation>
    </message>
    <message>
        <source>No frame taught yet. Teach a frame on the Frames tab.</source>
        <translation>还没有示教坐标系。请在坐标系选项卡中示教。</translation>
    </message>
    <message>
        <source>Moves by %1 per press.</source>
        <translation>每按一次移动 %1。</translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press.</source>
        <translation>每按一次，工具或关节转动 %1。</translation>
    </message>
    <message>
        <source>≤ %1</source>
        <translation>≤ %1</translation>
    </message>
    <message>
        <source>Moves slowly while the button is held, until the contact force reaches %1 N. Click again to select a different step.</source>
        <translation>按住时缓慢移动，直到接触力达到 %1 N。再次点击可选择其他步长。</translation>
    </message>
    <message>
        <source>Moves by %1 per press. Click again to select a different step.</source>
        <translation>每按一次移动 %1。再次点击可选择其他步长。</translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press. Click again to select a different angle.</source>
        <translation>每按一次，工具或关节转动 %1。再次点击可选择其他角度。</translation>
    </message>
    <message>
        <source>%1 · rotation %2 · joints %3 · Ctrl × 0.1, Shift × 3</source>
        <translation>%1 · 旋转 %2 · 关节 %3 · Ctrl × 0.1，Shift × 3</translation>
    </message>
    <message>
        <source>Other angle…</source>
        <translation>其他角度…</translation>
    </message>
    <message>
        <source>Other step…</source>
        <translation>其他步长…</translation>
    </message>
    <message>
        <source>Until contact, %1 N</source>
        <translation>直到接触，%1 N</translation>
    </message>
    <message>
        <source>Other contact force…</source>
        <translation>其他接触力…</translation>
    </message>
    <message>
        <source>Other speed…</source>
        <translation>其他速度…</translation>
    </message>
    <message>
        <source>Step in %1</source>
        <translation>步长（%1）</translation>
    </message>
    <message>
        <source>Angle in degrees</source>
        <translation>角度（度）</translation>
    </message>
    <message>
        <source>TCP speed in %1</source>
        <translation>TCP 速度（%1）</translation>
    </message>
    <message>
        <source>Contact force that ends the motion, in N</source>
        <translation>结束运动的接触力（N）</translation>
    </message>
    <message>
        <source>The step continues after the button is released. Space, Esc and STOP end the step.</source>
        <translation>松开后步进继续。空格、Esc 和 STOP 可结束步进。</translation>
    </message>
    <message>
        <source>Hold the button until the step is complete.</source>
        <translation>按住按钮直到步进完成。</translation>
    </message>
</context>
<context>
    <name>tiller::JointRow</name>
    <message>
        <source>%1 minus</source>
        <translation>%1 减</translation>
    </message>
    <message>
        <source>%1 plus</source>
        <translation>%1 加</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>tiller::JointRows</name>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
</context>
<context>
    <name>tiller::KeyboardJog</name>
    <message>
        <source>Keyboard jogging is armed</source>
        <translation>键盘点动已启用</translation>
    </message>
</context>
<context>
    <name>tiller::LimiterLine</name>
    <message>
        <source>Limiter</source>
        <translation>限制</translation>
    </message>
</context>
<context>
    <name>tiller::LimitsDialog</name>
    <message>
        <source>Limits of the value axis</source>
        <translation>数值轴范围</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>%1, minimum</source>
        <translation>%1，最小值</translation>
    </message>
    <message>
        <source>%1, maximum</source>
        <translation>%1，最大值</translation>
    </message>
    <message>
        <source>%1: enter two numbers. The minimum must be less than the maximum.</source>
        <translation>%1：请输入两个数值。最小值必须小于最大值。</translation>
    </message>
</context>
<context>
    <name>tiller::LogModel</name>
    <message>
        <source>Info</source>
        <translation>信息</translation>
    </message>
    <message>
        <source>▲ Warning</source>
        <translation>▲ 警告</translation>
    </message>
    <message>
        <source>⬣ Error</source>
        <translation>⬣ 错误</translation>
    </message>
    <message>
        <source>Tiller</source>
        <translation>Tiller</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>严重程度</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open the recording of this incident at the time of the stop</source>
        <translation>在停止时刻打开此事件的录制</translation>
    </message>
    <message>
        <source>Open the recording at this time</source>
        <translation>在此时刻打开记录</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>%1 · Origin: %2</source>
        <translation>%1 · 来源：%2</translation>
    </message>
    <message>
        <source>%1 times between %2 and %3 · Origin: %4</source>
        <translation>%2 至 %3 共 %1 次 · 来源：%4</translation>
    </message>
    <message>
        <source>(×%1, last at %2) %3</source>
        <translation>（×%1，最后 %2）%3</translation>
    </message>
</context>
<context>
    <name>tiller::LogTab</name>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Minimum severity</source>
        <translation>最低严重程度</translation>
    </message>
    <message>
        <source>Filter the log by text</source>
        <translation>按文本过滤日志</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>过滤</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the selected entries, or all visible entries (Ctrl+C)</source>
        <translation>复制所选条目，或所有可见条目 (Ctrl+C)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Write the visible entries to a file</source>
        <translation>将可见条目写入文件</translation>
    </message>
    <message>
        <source>Details of the selected entry</source>
        <translation>所选条目的详情</translation>
    </message>
    <message>
        <source>Export the log</source>
        <translation>导出日志</translation>
    </message>
    <message>
        <source>Text file (*.txt)</source>
        <translation>文本文件 (*.txt)</translation>
    </message>
    <message>
        <source>Log written to %1</source>
        <translation>日志已写入 %1</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>打开录制</translation>
    </message>
    <message>
        <source>Open the recording of the selected entry</source>
        <translation>打开所选条目的录制</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>记录：%1</translation>
    </message>
</context>
<context>
    <name>tiller::MetadataDialog</name>
    <message>
        <source>Ask before each recording</source>
        <translation>每次记录前询问</translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation>记录的元数据</translation>
    </message>
    <message>
        <source>Tiller stores the fields with a value in each recording. The names and values are kept for the next recording.</source>
        <translation>Tiller 会把有值的字段保存到每个记录中。名称和值会保留到下一次记录。</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>元数据</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Add field</source>
        <translation>添加字段</translation>
    </message>
    <message>
        <source>Remove field</source>
        <translation>删除字段</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>The value “%1” has no name. Enter a name.</source>
        <translation>值“%1”没有名称。请输入名称。</translation>
    </message>
    <message>
        <source>The name “%1” is not valid. Use letters, digits, spaces and _ - . (at most 60).</source>
        <translation>名称“%1”无效。请使用字母、数字、空格和 _ - .（最多 60 个字符）。</translation>
    </message>
    <message>
        <source>Tiller stores “%1” itself. Choose another name.</source>
        <translation>“%1”由 Tiller 自动保存。请选择其他名称。</translation>
    </message>
    <message>
        <source>The name “%1” occurs twice. Choose another name.</source>
        <translation>名称“%1”出现了两次。请选择其他名称。</translation>
    </message>
    <message>
        <source>The value of “%1” must be one line of at most %2 characters.</source>
        <translation>“%1”的值必须是一行，最多 %2 个字符。</translation>
    </message>
    <message>
        <source>Remove fields: at most %1 fields are possible.</source>
        <translation>请删除字段：最多 %1 个。</translation>
    </message>
</context>
<context>
    <name>tiller::MoveWords</name>
    <message>
        <source>%1 collides with %2 after %3 of the path</source>
        <translation>%1 在路径 %3 处与 %2 碰撞</translation>
    </message>
    <message>
        <source>The move enters the wrist singularity after %1 of the path</source>
        <translation>路径在 %1 处进入手腕奇异点</translation>
    </message>
    <message>
        <source>The move slows down near the wrist singularity at %1 of the path</source>
        <translation>在路径 %1 处因接近手腕奇异点而减速</translation>
    </message>
    <message>
        <source>The move enters the elbow singularity after %1 of the path</source>
        <translation>路径在 %1 处进入肘部奇异点</translation>
    </message>
    <message>
        <source>The move slows down near the elbow singularity at %1 of the path</source>
        <translation>在路径 %1 处因接近肘部奇异点而减速</translation>
    </message>
    <message>
        <source>The move enters the shoulder singularity after %1 of the path</source>
        <translation>路径在 %1 处进入肩部奇异点</translation>
    </message>
    <message>
        <source>The move slows down near the shoulder singularity at %1 of the path</source>
        <translation>在路径 %1 处因接近肩部奇异点而减速</translation>
    </message>
    <message>
        <source>A joint would have to jump after %1 of the path</source>
        <translation>在路径 %1 处某关节须突变</translation>
    </message>
    <message>
        <source>%1 exceeds its limit after %2 of the path</source>
        <translation>%1 在路径 %2 处超出范围</translation>
    </message>
    <message>
        <source>The move leaves the reach of the arm after %1 of the path</source>
        <translation>路径在 %1 处超出机械臂可达范围</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>肩部</translation>
    </message>
    <message>
        <source>Upper arm</source>
        <translation>上臂</translation>
    </message>
    <message>
        <source>Forearm</source>
        <translation>前臂</translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation>手腕 1</translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation>手腕 2</translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation>手腕 3</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>%1 is in contact with %2, and the move reduces the distance</source>
        <translation>%1 与 %2 接触，该运动会使其更接近</translation>
    </message>
    <message>
        <source>%1 is only %2 from %3, and the move reduces the distance</source>
        <translation>%1 距 %3 仅 %2，该运动会使其更接近</translation>
    </message>
    <message>
        <source>%1 comes within %2 of %3 after %4 of the path</source>
        <translation>%1 在路径的 %4 处距 %3 小于 %2</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>The position of “%1” is unknown because its frame is not in the project. Enter its position, turn off its collision check, or delete it on the Cell page</source>
        <translation>“%1”的位置未知，因为其坐标系不在项目中。请在单元页面上输入位置、关闭其碰撞检查或将其删除</translation>
    </message>
</context>
<context>
    <name>tiller::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>通知</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Notice action</source>
        <translation>通知的操作</translation>
    </message>
    <message>
        <source>Second notice action</source>
        <translation>通知的第二个操作</translation>
    </message>
</context>
<context>
    <name>tiller::OpenTableDialog</name>
    <message>
        <source>Open table</source>
        <translation>打开表格</translation>
    </message>
    <message>
        <source>Tiller cannot determine the times of the rows in %1. Select how to read the table.</source>
        <translation>Tiller 无法确定 %1 中各行的时间。请选择读取表格的方式。</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>文件的前几行</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>时间列</translation>
    </message>
    <message>
        <source>No time column</source>
        <translation>无时间列</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>时间单位</translation>
    </message>
    <message>
        <source>Rows per second</source>
        <translation>每秒行数</translation>
    </message>
    <message>
        <source>Column separator</source>
        <translation>列分隔符</translation>
    </message>
    <message>
        <source>Comma</source>
        <translation>逗号</translation>
    </message>
    <message>
        <source>Semicolon</source>
        <translation>分号</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>制表符</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>Decimal separator</source>
        <translation>小数分隔符</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>First row</source>
        <translation>第一行</translation>
    </message>
    <message>
        <source>Column names</source>
        <translation>列名</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Reason: %1</source>
        <translation>原因：%1</translation>
    </message>
    <message>
        <source>Detect automatically</source>
        <translation>自动检测</translation>
    </message>
</context>
<context>
    <name>tiller::PartModel</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
</context>
<context>
    <name>tiller::PartPage</name>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
</context>
<context>
    <name>tiller::PathControls</name>
    <message>
        <source>Path tolerance</source>
        <translation>路径公差</translation>
    </message>
    <message>
        <source>Record path</source>
        <translation>录制路径</translation>
    </message>
    <message>
        <source>Export path as CSV…</source>
        <translation>将路径导出为 CSV…</translation>
    </message>
    <message>
        <source>Import path from CSV…</source>
        <translation>从 CSV 导入路径…</translation>
    </message>
    <message>
        <source>The path recorded so far is kept.</source>
        <translation>此前录制的路径会保留。</translation>
    </message>
    <message>
        <source>Stop recording path</source>
        <translation>停止录制路径</translation>
    </message>
    <message>
        <source>Simplifying the path…</source>
        <translation>正在简化路径…</translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation>机器人未发送数据，无法录制路径。请等待数据，或连接机器人。</translation>
    </message>
    <message>
        <source>Stops recording and stores the path as waypoints</source>
        <translation>停止录制并将路径保存为路点</translation>
    </message>
    <message>
        <source>Records the path of the arm during Freedrive or jogging and stores it as waypoints. Press again to stop. Recording does not move the robot.</source>
        <translation>录制机械臂在自由驱动或点动时的路径，并保存为路点。再次按下可停止。机器人不移动。</translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation>选择路径的路点，至少两个。</translation>
    </message>
    <message>
        <source>Export path</source>
        <translation>导出路径</translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation>CSV 文件 (*.csv)</translation>
    </message>
    <message>
        <source>The path was not exported.</source>
        <translation>路径未导出。</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints exported as a path to %1</source>
        <translation>
            <numerusform>%n 个路点已作为路径写入 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Import path</source>
        <translation>导入路径</translation>
    </message>
    <message>
        <source>○ Path</source>
        <translation>○ 路径</translation>
    </message>
    <message>
        <source>The path of the arm is being recorded. To stop recording, press “● REC” or select “Stop recording path” in the menu.</source>
        <translation>正在记录机械臂的路径。按“● REC”，或在菜单中选择停止记录路径以结束。</translation>
    </message>
    <message>
        <source>Path recording stopped because the maximum duration of ten minutes was reached.</source>
        <translation>路径录制已停止：已达到十分钟的最长时间。</translation>
    </message>
    <message>
        <source>Path recording stopped because the robot stopped sending data or was restarted.</source>
        <translation>路径录制已停止：机器人不再发送数据，或已重新启动。</translation>
    </message>
</context>
<context>
    <name>tiller::PathRecorder</name>
    <message>
        <source>%1 has no column “%2”. The columns “timestamp” and “actual_q_0” to “actual_q_5” are required.</source>
        <translation>%1 没有列“%2”。需要 timestamp 和 actual_q_0 至 actual_q_5。</translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation>机器人未发送数据，无法录制路径。请等待数据，或连接机器人。</translation>
    </message>
    <message>
        <source>Import refused because another path is being recorded or processed. Stop the recording, or wait, and try again.</source>
        <translation>拒绝导入：正在录制或处理另一条路径。请停止录制或等待，然后重试。</translation>
    </message>
    <message>
        <source>The path could not be imported.</source>
        <translation>无法导入路径。</translation>
    </message>
    <message>
        <source>path %1</source>
        <translation>路径 %1</translation>
    </message>
    <message>
        <source>The arm did not move. No path was stored.</source>
        <translation>机械臂没有移动：未保存路径。</translation>
    </message>
    <message>
        <source>Record “%1”</source>
        <translation>录制“%1”</translation>
    </message>
    <message>
        <source>“%1”: %2 s, %3 waypoints. Maximum deviation from the recording: %4 and %5.</source>
        <translation>“%1”：%2 s，%3 个路点。与录制的最大偏差：%4 和 %5。</translation>
    </message>
    <message numerus="yes">
        <source>%n packets were lost.</source>
        <translation>
            <numerusform>丢失了 %n 个数据包。</numerusform>
        </translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation>选择路径的路点，至少两个。</translation>
    </message>
    <message>
        <source>“%1” is out of reach. Touch up or delete the waypoint.</source>
        <translation>“%1”不可达。请修正示教或移除。</translation>
    </message>
</context>
<context>
    <name>tiller::PatternDialog</name>
    <message>
        <source>pattern</source>
        <translation>阵列</translation>
    </message>
    <message>
        <source>Pattern from three corners</source>
        <translation>三角点阵列</translation>
    </message>
    <message>
        <source>Pattern “%1”</source>
        <translation>阵列“%1”</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>First cell</source>
        <translation>第一个格位</translation>
    </message>
    <message>
        <source>End of the first row</source>
        <translation>第一行末尾</translation>
    </message>
    <message>
        <source>Start of the last row</source>
        <translation>最后一行起点</translation>
    </message>
    <message>
        <source>Select a waypoint</source>
        <translation>选择路点</translation>
    </message>
    <message>
        <source>As taught</source>
        <translation>按示教</translation>
    </message>
    <message>
        <source>Cells per row</source>
        <translation>每行格数</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>层数</translation>
    </message>
    <message>
        <source>Layer height</source>
        <translation>层高</translation>
    </message>
    <message>
        <source>Distance from one layer to the next, measured opposite to the tool direction.</source>
        <translation>层间距离，方向与工具方向相反。</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>顺序</translation>
    </message>
    <message>
        <source>Row by row</source>
        <translation>逐行</translation>
    </message>
    <message>
        <source>Zigzag</source>
        <translation>蛇形</translation>
    </message>
    <message>
        <source>Create pattern</source>
        <translation>创建阵列</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Enter a name for the pattern.</source>
        <translation>请输入阵列的名称。</translation>
    </message>
    <message>
        <source>Teach the corners first, then select a waypoint for each corner.</source>
        <translation>请先示教阵列的角，然后为每个角选择路点。</translation>
    </message>
    <message>
        <source>The layer height must not be 0. Enter a layer height.</source>
        <translation>层高不能为 0。请输入层高。</translation>
    </message>
    <message>
        <source>The pattern has %1 cells; the maximum is %2. Enter fewer cells per row, rows or layers.</source>
        <translation>阵列有 %1 个格位；上限为 %2。请减少每行格位数、行数或层数。</translation>
    </message>
    <message>
        <source>All cells are excluded. Click a cell to include it.</source>
        <translation>所有格位均已排除。请单击一个格位以包含它。</translation>
    </message>
    <message>
        <source>The three corners are on a straight line. Select a different waypoint for one of them.</source>
        <translation>三个角点在一条直线上。请为其中一个选择其他路点。</translation>
    </message>
    <message>
        <source>Two corners are at the same position. Select a different waypoint for one of them.</source>
        <translation>两个角是同一位置。请为其中一个选择另一路点。</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n 个路点</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, all within reach.</source>
        <translation>%1，全部可达。</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n out of reach and marked.</source>
        <translation>
            <numerusform>%1，其中 %n 个不可达，已标记。</numerusform>
        </translation>
    </message>
    <message>
        <source>A pattern with this name already exists. Choose a different name.</source>
        <translation>已有此名称的阵列。请选择其他名称。</translation>
    </message>
    <message>
        <source>The layer height is not a number or is out of range. Enter a different layer height.</source>
        <translation>层高不是数字或超出范围。请输入其他层高。</translation>
    </message>
</context>
<context>
    <name>tiller::PatternGrid</name>
    <message>
        <source>Pattern cells</source>
        <translation>阵列的格位</translation>
    </message>
    <message>
        <source>Click a cell to exclude or include it. The first cell is at the lower left.</source>
        <translation>单击格位以排除或包含。第一个格位位于左下角。</translation>
    </message>
    <message>
        <source>Row %1, column %2</source>
        <translation>第 %1 行，第 %2 列</translation>
    </message>
</context>
<context>
    <name>tiller::PayloadEstimator</name>
    <message>
        <source>Next pose (hold)</source>
        <translation>下一位姿（按住）</translation>
    </message>
    <message>
        <source>Keep payload</source>
        <translation>保留有效负载</translation>
    </message>
    <message>
        <source>Measure payload</source>
        <translation>测量有效负载</translation>
    </message>
    <message>
        <source>Measure the payload in several poses</source>
        <translation>在多个位姿测量有效负载</translation>
    </message>
    <message>
        <source>Next pose, hold</source>
        <translation>下一位姿，按住</translation>
    </message>
    <message>
        <source>Rotates the wrist to the next pose while the button is held, no faster than the jog speed. Make sure that the tool has space to rotate.</source>
        <translation>按住时把手腕转到下一位姿，不快于点动速度。请确认工具有转动空间。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancel payload measurement</source>
        <translation>取消有效负载测量</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller 未取得控制。请先获取控制。</translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and record the pose again.</source>
        <translation>机械臂移动了。请让其静止，不要触碰任何东西，再重新取位姿。</translation>
    </message>
    <message>
        <source>The robot is not sending force data. Enter the mass and the centre of gravity instead.</source>
        <translation>机器人不发送力数据。请改用数值输入质量和重心。</translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation>正在称重… 请勿触碰工具。</translation>
    </message>
    <message>
        <source>%1 kg, centre of gravity at %2 from the flange. The poses agree within %3 and %4.</source>
        <translation>%1 kg，重心距法兰 %2。各位姿在 %3 和 %4 之内一致。</translation>
    </message>
    <message>
        <source>%1 The accuracy is low: pose %2 deviates most. Remove this pose and record another pose.</source>
        <translation>%1 精度较低：位姿 %2 偏差最大。请移除它并另取一个位姿。</translation>
    </message>
    <message>
        <source>The load of %1 kg is too light to measure the centre of gravity. Enter the payload manually.</source>
        <translation>%1 kg 的负载太轻，无法测量重心。请手动输入有效负载。</translation>
    </message>
    <message>
        <source>Wait for standstill, keep the tool free of contact, and record the pose. Then rotate the wrist by jogging or with “Next pose (hold)”, and record three more poses.</source>
        <translation>让机械臂静止，不触碰任何东西，取位姿。然后用点动或“下一位姿”转动手腕，再取三个。</translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation>取位姿 %1</translation>
    </message>
    <message>
        <source>Remove least accurate pose</source>
        <translation>移除最不准确的位姿</translation>
    </message>
    <message>
        <source>Remove last pose</source>
        <translation>移除最后一个位姿</translation>
    </message>
    <message>
        <source>Pose %1  %2</source>
        <translation>位姿 %1  %2</translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation>  ◀ 最不准确</translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool rotated in a different direction.</source>
        <translation>工具方向过于相近。请将工具转到另一方向再取一个位姿。</translation>
    </message>
    <message numerus="yes">
        <source>Rotate the wrist in a different direction and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>把手腕转到另一侧并取位姿。还需：%n。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::PayloadPage</name>
    <message>
        <source>Mass kg</source>
        <translation>质量 kg</translation>
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
        <translation>使用中</translation>
    </message>
    <message>
        <source>Enter a name for the payload.</source>
        <translation>请输入有效负载的名称。</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>将“%1”重命名为“%2”</translation>
    </message>
    <message>
        <source>Nothing mounted</source>
        <translation>未安装任何东西</translation>
    </message>
    <message>
        <source>Robotiq 2F-85, empty</source>
        <translation>Robotiq 2F-85，空</translation>
    </message>
    <message>
        <source>Robotiq 2F-140, empty</source>
        <translation>Robotiq 2F-140，空</translation>
    </message>
    <message>
        <source>Payloads</source>
        <translation>有效负载</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
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
        <translation>有效负载的质量</translation>
    </message>
    <message>
        <source>Centre of gravity X</source>
        <translation>重心 X</translation>
    </message>
    <message>
        <source>Centre of gravity Y</source>
        <translation>重心 Y</translation>
    </message>
    <message>
        <source>Centre of gravity Z</source>
        <translation>重心 Z</translation>
    </message>
    <message>
        <source>Press Return to apply the value to the project. The robot&apos;s payload does not change.</source>
        <translation>按回车应用到项目。机器人的有效负载不变。</translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation>设到机器人</translation>
    </message>
    <message>
        <source>Use this payload and set it on the robot</source>
        <translation>使用此有效负载并设到机器人</translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation>测量…</translation>
    </message>
    <message>
        <source>Measure the payload with the arm</source>
        <translation>用机械臂测量有效负载</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>验证</translation>
    </message>
    <message>
        <source>Verify the payload</source>
        <translation>验证有效负载</translation>
    </message>
    <message>
        <source>Store the active payload of the robot</source>
        <translation>保存机器人当前有效负载</translation>
    </message>
    <message>
        <source>Enter new payload</source>
        <translation>输入新的有效负载</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>有效负载</translation>
    </message>
    <message>
        <source>Add preset: %1</source>
        <translation>添加预设：%1</translation>
    </message>
    <message>
        <source>Rename payload</source>
        <translation>重命名有效负载</translation>
    </message>
    <message>
        <source>Duplicate payload</source>
        <translation>复制有效负载</translation>
    </message>
    <message>
        <source>Delete payload</source>
        <translation>删除有效负载</translation>
    </message>
    <message>
        <source>Add the payload “%1”</source>
        <translation>添加有效负载“%1”</translation>
    </message>
    <message>
        <source>Change the payload “%1”</source>
        <translation>更改有效负载“%1”</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>未连接机器人。请连接，或试用模拟器。</translation>
    </message>
    <message>
        <source>Select the payload to set.</source>
        <translation>选择要设定的有效负载。</translation>
    </message>
    <message>
        <source>Use the payload “%1”</source>
        <translation>使用有效负载“%1”</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller 未取得控制。请先获取控制。</translation>
    </message>
    <message>
        <source>Delete the payload “%1”</source>
        <translation>删除有效负载“%1”</translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation>正在称重… 请勿触碰工具。</translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and press “Verify” again.</source>
        <translation>机械臂移动了。请让其静止，不要触碰任何东西，再次检查。</translation>
    </message>
    <message>
        <source>The payload cannot be verified because the robot is not sending force data. Wait for data, or reconnect.</source>
        <translation>机器人没有发送力数据，无法验证有效负载。请等待数据，或重新连接。</translation>
    </message>
    <message>
        <source>With a payload of %1 kg, the arm measures a force of %2 and a torque of %3.</source>
        <translation>有效负载为 %1 kg 时，机械臂测得力 %2 和力矩 %3。</translation>
    </message>
    <message>
        <source>The payload is correct. %1</source>
        <translation>有效负载正确。%1</translation>
    </message>
    <message>
        <source>The payload is correct</source>
        <translation>有效负载正确</translation>
    </message>
    <message>
        <source>The load is about %1 kg heavier than the configured payload.</source>
        <translation>负载比配置的有效负载约重 %1 kg。</translation>
    </message>
    <message>
        <source>The load is about %1 kg lighter than the configured payload.</source>
        <translation>负载比配置的有效负载约轻 %1 kg。</translation>
    </message>
    <message>
        <source>The centre of gravity differs, or something is touching the tool.</source>
        <translation>重心不同，或有物体触碰工具。</translation>
    </message>
    <message>
        <source>%1 %2 Measure the payload, or select a different payload. Zeroing the force sensor hides a wrong payload until the tool rotates.</source>
        <translation>%1 %2 请测量有效负载，或选择另一个。力传感器归零会掩盖错误的有效负载，直到工具转动。</translation>
    </message>
    <message>
        <source>The payload is wrong. %1 %2</source>
        <translation>有效负载不正确。%1 %2</translation>
    </message>
    <message>
        <source>The payload is wrong</source>
        <translation>有效负载不正确</translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation>%1，机器人当前使用</translation>
    </message>
    <message>
        <source>%1; the robot uses %2 kg, centre of gravity %3</source>
        <translation>%1；机器人使用 %2 kg，重心 %3</translation>
    </message>
    <message>
        <source>The robot&apos;s payload differs from “%1”</source>
        <translation>机器人的有效负载与“%1”不同</translation>
    </message>
    <message>
        <source>On the robot: %1 kg, centre of gravity %2. In the project: %3 kg, centre of gravity %4. Nothing was changed.</source>
        <translation>机器人：%1 kg，重心 %2。项目：%3 kg，重心 %4。没有任何更改。</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>将“%1”设到机器人</translation>
    </message>
    <message>
        <source>No payloads yet.
Press “Measure…” to measure the payload with the arm.</source>
        <translation>尚无负载。
按“测量…”用机械臂测量负载。</translation>
    </message>
    <message>
        <source>A payload named “%1” already exists. Choose a different name.</source>
        <translation>“%1”已是另一个有效负载的名称。请选择其他名称。</translation>
    </message>
</context>
<context>
    <name>tiller::PlotAnalysis</name>
    <message>
        <source>Spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>XY</source>
        <translation>XY</translation>
    </message>
    <message>
        <source>vs.</source>
        <translation>对</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>频谱和 XY</translation>
    </message>
    <message>
        <source>Analysis type</source>
        <translation>分析类型</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>X-axis signal</source>
        <translation>X 轴信号</translation>
    </message>
    <message>
        <source>Add a signal to the plots first.</source>
        <translation>请先向曲线图添加信号。</translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range.</source>
        <translation>此范围内没有采样。请选择其他范围。</translation>
    </message>
    <message>
        <source>Samples are missing in this range. Place cursors A and B around a range without gaps.</source>
        <translation>此范围内缺少采样：请放置游标 A 和 B，使其间没有缺口。</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>频率 [Hz]</translation>
    </message>
    <message>
        <source>Amplitude of %1</source>
        <translation>%1 的幅值</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n 个采样</numerusform>
        </translation>
    </message>
    <message>
        <source>This range is too long to combine signals from different recordings. Place cursors A and B around a shorter range.</source>
        <translation>该范围太长，无法组合不同录制的信号。请将游标 A 和 B 放在更短的范围上。</translation>
    </message>
    <message>
        <source>Reading the recording: %1</source>
        <translation>正在读取记录：%1</translation>
    </message>
    <message numerus="yes">
        <source>Hann window of %1 samples · resolution %2 Hz · mean of %n segment(s) · %3 to %4 s</source>
        <translation>
            <numerusform>%1 个采样的汉宁窗 · 分辨率 %2 Hz · %n 段平均 · %3 至 %4 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) shown, 1 of every %1</source>
        <translation>
            <numerusform>显示 %n 个采样，每 %1 个取一个</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 to %3 s</source>
        <translation>%1 · %2 至 %3 s</translation>
    </message>
    <message>
        <source>This range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation>该范围包含不同机器人的样本。请将光标 A 和 B 放在同一台机器人数据的两端。</translation>
    </message>
</context>
<context>
    <name>tiller::PlotComparison</name>
    <message>
        <source>Arm and model diverge: %1</source>
        <translation>机械臂与模型出现偏差：%1</translation>
    </message>
    <message>
        <source>Comparing the arm with its model: %1</source>
        <translation>正在将机械臂与其模型比较：%1</translation>
    </message>
    <message>
        <source>Not compared with the arm model: the recording does not specify the robot model. Press “Compare…” and select the model.</source>
        <translation>未与机械臂模型比较：录制中没有机器人型号。请按“比较…”并选择型号。</translation>
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
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Time range of the plots. The mouse wheel zooms the time axis; over the value axis, or with Ctrl, it zooms the values. Double-click the value axis to scale automatically.</source>
        <translation>曲线图的时间范围。滚轮缩放时间轴；在数值轴上或按住 Ctrl 时缩放数值。双击数值轴可自动缩放。</translation>
    </message>
    <message>
        <source>Pause the plots</source>
        <translation>暂停曲线图</translation>
    </message>
    <message>
        <source>Zero the displayed force</source>
        <translation>将显示的力归零</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>归零</translation>
    </message>
    <message>
        <source>Export the visible range</source>
        <translation>导出可见范围</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Save the visible range as an image (e.g. PNG) or as values (e.g. CSV)</source>
        <translation>将可见范围保存为图片（如 PNG）或数值（如 CSV）</translation>
    </message>
    <message>
        <source>Cannot zero the force: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation>无法将力归零：曲线图没有样本。请连接机器人，或滚动到有样本的时间。</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
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
        <translation>暂停</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Freeze the plots. Reception and recording of data continue.</source>
        <translation>冻结曲线图；数据和录制继续</translation>
    </message>
    <message>
        <source>Show the force as measured by the robot. %1</source>
        <translation>按机器人测量值显示力。%1</translation>
    </message>
    <message>
        <source>Subtract the current force in the plots. The robot, recordings and exported values are not changed.</source>
        <translation>在曲线图中减去当前的力。机器人、录制和导出的数值不变。</translation>
    </message>
    <message>
        <source>● REC %1</source>
        <translation>● REC %1</translation>
    </message>
    <message>
        <source>● Record</source>
        <translation>● 录制</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>停止录制</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Cannot export: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation>无法导出：曲线图没有样本。请连接机器人，或滚动到有样本的时间。</translation>
    </message>
    <message>
        <source>Exported the visible range to %1</source>
        <translation>可见范围已导出到 %1</translation>
    </message>
    <message>
        <source>PNG image (*.png)</source>
        <translation>PNG 图像 (*.png)</translation>
    </message>
    <message>
        <source>SVG image (*.svg)</source>
        <translation>SVG 图像 (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 文档 (*.pdf)</translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation>CSV 文件 (*.csv)</translation>
    </message>
    <message>
        <source>Recording options</source>
        <translation>录制选项</translation>
    </message>
    <message>
        <source>Rows, signals, folder and file name of the next recording</source>
        <translation>下次录制的行、信号、文件夹和文件名</translation>
    </message>
    <message>
        <source>One row per packet</source>
        <translation>每个数据包一行</translation>
    </message>
    <message numerus="yes">
        <source>One row every %n packet(s)</source>
        <translation>
            <numerusform>每 %n 个数据包一行</numerusform>
        </translation>
    </message>
    <message>
        <source>All signals…</source>
        <translation>所有信号…</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s)…</source>
        <translation>
            <numerusform>%n 个信号…</numerusform>
        </translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>打开文件夹</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>录制文件夹</translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range, then export again.</source>
        <translation>此范围内没有样本。请选择其他范围，然后重新导出。</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>What happened at this time?</source>
        <translation>此刻发生了什么？</translation>
    </message>
    <message>
        <source>The plots were copied to the clipboard as an image.</source>
        <translation>曲线图已作为图片复制到剪贴板。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>History %1 · %2</source>
        <translation>历史 %1 · %2</translation>
    </message>
    <message>
        <source>New page</source>
        <translation>新建页</translation>
    </message>
    <message>
        <source>Remove this page</source>
        <translation>移除此页</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>打开录制…</translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation>关闭录制文件</translation>
    </message>
    <message>
        <source>Copy plots as image</source>
        <translation>将曲线图复制为图片</translation>
    </message>
    <message>
        <source>Save layout…</source>
        <translation>保存布局…</translation>
    </message>
    <message>
        <source>Open layout…</source>
        <translation>打开布局…</translation>
    </message>
    <message>
        <source>History memory</source>
        <translation>历史内存</translation>
    </message>
    <message>
        <source>Opened the recording %1</source>
        <translation>已打开录制 %1</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>打开录制</translation>
    </message>
    <message>
        <source>Save plot layout</source>
        <translation>保存曲线图布局</translation>
    </message>
    <message>
        <source>Plot layouts (*.json)</source>
        <translation>曲线图布局 (*.json)</translation>
    </message>
    <message>
        <source>Open plot layout</source>
        <translation>打开曲线图布局</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 等</translation>
    </message>
    <message>
        <source>Signal list</source>
        <translation>信号列表</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Robot signals. Drag a signal to a plot, or to the edge of a plot to create a new plot. Double-click a signal to add it to a plot.</source>
        <translation>机器人信号。将信号拖到曲线图中，或拖到曲线图边缘以新建曲线图。双击信号可将其添加到曲线图。</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>游标处的值</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Values at cursors A and B, and statistics of the range between the cursors: minimum, maximum, mean, RMS, standard deviation, slope</source>
        <translation>每个信号在游标 A 和 B 处的值，以及其间的最小、最大、平均、RMS、偏差、斜率</translation>
    </message>
    <message>
        <source>Plot pages and layout</source>
        <translation>曲线图的页与布局</translation>
    </message>
    <message>
        <source>Layout ▾</source>
        <translation>布局 ▾</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>频谱和 XY</translation>
    </message>
    <message>
        <source>Export the visible range…</source>
        <translation>导出可见范围…</translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Relative to the newest sample</source>
        <translation>相对最新采样</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>控制器时间</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>时刻</translation>
    </message>
    <message>
        <source>The maximum number of plot pages has been reached. Remove a page first.</source>
        <translation>曲线图页数已达上限：请先移除一页。</translation>
    </message>
    <message>
        <source>CSV: text, for pandas and spreadsheets</source>
        <translation>CSV：文本，用于 pandas 和电子表格</translation>
    </message>
    <message>
        <source>MCAP: every field, the log and the project, for ROS tools</source>
        <translation>MCAP：所有字段、日志和项目，用于 ROS 工具</translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation>与机械臂模型比较…</translation>
    </message>
    <message>
        <source>Exported the range between cursors A and B to %1</source>
        <translation>已将游标 A 和 B 之间的范围导出到 %1</translation>
    </message>
    <message>
        <source>Cursor A to cursor B (*%1)</source>
        <translation>游标 A 到游标 B (*%1)</translation>
    </message>
    <message>
        <source>The page shows several recordings, or a recording and live signals. Show only one of them on the page, then export again.</source>
        <translation>此页面显示了多个录制，或同时显示了录制和实时信号。请只显示其中一个，然后重新导出。</translation>
    </message>
    <message>
        <source>Live signals can be exported only as .csv. For other formats, record the signals first.</source>
        <translation>实时信号只能导出为 .csv。如需其他格式，请先录制。</translation>
    </message>
    <message>
        <source>The range contains too many values to export from this window. Export a shorter range, or run “tiller-cli export”.</source>
        <translation>该范围的值过多，无法从此窗口导出。请导出较短的范围，或运行“tiller-cli export”。</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>机器人：%1</translation>
    </message>
    <message>
        <source>Recordings (%1);;All files (*)</source>
        <translation>录制 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Record to a file (%1)</source>
        <translation>录制到文件 (%1)</translation>
    </message>
    <message>
        <source>Record robot data to a file (%1). Use the arrow button to select the signals and the folder.</source>
        <translation>将机器人数据录制到文件 (%1)。使用旁边的箭头按钮选择信号和文件夹。</translation>
    </message>
    <message>
        <source>All %1 pages show recordings. Remove a page or close the recordings first.</source>
        <translation>全部 %1 个页面都显示记录。请先移除一个页面或关闭记录。</translation>
    </message>
    <message>
        <source>Cursor readout</source>
        <translation>游标读数</translation>
    </message>
    <message>
        <source>Click in the plots to place cursors A and B; drag them, or use the A, B and arrow keys. Click a legend entry to hide its curve; Ctrl+click the entry to show its values at the cursors.</source>
        <translation>在曲线图中点击以放置游标 A 和 B；拖动它们，或使用 A、B 键和方向键。点击图例中的名称可隐藏其曲线，按住 Ctrl 则读取该信号。</translation>
    </message>
    <message>
        <source>Time range</source>
        <translation>时间范围</translation>
    </message>
    <message>
        <source>Paused · %1 s behind</source>
        <translation>已暂停 · 滞后 %1 s</translation>
    </message>
    <message>
        <source>Return to the newest samples</source>
        <translation>回到最新样本</translation>
    </message>
    <message>
        <source>controller time %1 to %2 s</source>
        <translation>控制器时间 %1 至 %2 s</translation>
    </message>
    <message>
        <source>%1 to %2 s</source>
        <translation>%1 至 %2 s</translation>
    </message>
    <message>
        <source>Folder: %1…</source>
        <translation>文件夹：%1…</translation>
    </message>
    <message>
        <source>The file type is not supported. Use the suffix .png, .svg or .pdf for an image, or .csv for values.</source>
        <translation>不支持此文件类型。图片请用 .png、.svg 或 .pdf，数值请用 .csv 命名。</translation>
    </message>
    <message>
        <source>%1 at controller time %2 s.</source>
        <translation>%1（控制器时间 %2 s）。</translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation>显示标准曲线图</translation>
    </message>
    <message>
        <source>the file does not contain a plot layout</source>
        <translation>文件不包含曲线图布局</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %2/s · %3 free · %n packet(s) lost</source>
        <translation>
            <numerusform>%1 · %2/s · 剩余 %3 · 丢失 %n 个数据包</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened the recording %1, but part of it could not be read. %2</source>
        <translation>已打开录制 %1，但无法读取其中一部分。%2</translation>
    </message>
    <message>
        <source>Part of the recording %1 could not be read. %2</source>
        <translation>无法读取录制 %1 的一部分。%2</translation>
    </message>
    <message>
        <source>The range contains samples from different robots. Use cursors A and B to select a range with data from one robot, then export again.</source>
        <translation>该范围包含不同机器人的数据。请用光标 A 和 B 选择一台机器人的范围，然后重新导出。</translation>
    </message>
    <message>
        <source>The image %1 could not be created. Choose a different image format.</source>
        <translation>无法创建图片 %1。请选择其他图片格式。</translation>
    </message>
    <message>
        <source>Recordings…</source>
        <translation>记录列表…</translation>
    </message>
    <message>
        <source>The plots do not contain data from %1.</source>
        <translation>图表中没有 %1 的数据。</translation>
    </message>
    <message>
        <source>● Waiting</source>
        <translation>● 等待</translation>
    </message>
    <message>
        <source>Waiting for the trigger. Files so far: %1</source>
        <translation>正在等待触发条件。已有文件：%1</translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation>元数据…</translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>元数据（%n 个字段）…</numerusform>
        </translation>
    </message>
    <message>
        <source>Trigger…</source>
        <translation>触发条件…</translation>
    </message>
    <message>
        <source>Trigger %1…</source>
        <translation>触发条件 %1…</translation>
    </message>
    <message>
        <source>File name: %1…</source>
        <translation>文件名：%1…</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation>实时的 %1 倍</translation>
    </message>
    <message>
        <source>Stop playback</source>
        <translation>停止播放</translation>
    </message>
    <message>
        <source>Cannot play: the page has no samples. Connect to a robot or open a recording first.</source>
        <translation>无法播放：该页没有样本。请先连接机器人或打开记录。</translation>
    </message>
</context>
<context>
    <name>tiller::PlotMarks</name>
    <message>
        <source>%1 is above %2</source>
        <translation>%1 高于 %2</translation>
    </message>
    <message>
        <source>%1 is below %2</source>
        <translation>%1 低于 %2</translation>
    </message>
</context>
<context>
    <name>tiller::PlotPages</name>
    <message>
        <source>Plot pages</source>
        <translation>曲线图页</translation>
    </message>
    <message>
        <source>Page name</source>
        <translation>页的名称</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>第 %1 页</translation>
    </message>
    <message>
        <source>Double-click to rename</source>
        <translation>双击重命名</translation>
    </message>
</context>
<context>
    <name>tiller::PlotValues</name>
    <message>
        <source>Values at the cursors</source>
        <translation>游标处的值</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
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
        <translation>最小</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Std</source>
        <translation>标准差</translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation>峰峰值</translation>
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
        <translation>在曲线图中单击以放置光标 A，然后放置光标 B。表格随后显示光标之间范围的统计值。</translation>
    </message>
    <message>
        <source>%1 · calculating: %2</source>
        <translation>%1 · 正在计算：%2</translation>
    </message>
    <message>
        <source>Statistics are incomplete: %1</source>
        <translation>统计不完整：%1</translation>
    </message>
    <message>
        <source>Slope per second</source>
        <translation>斜率 /s</translation>
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
        <translation>%1（归零）</translation>
    </message>
    <message>
        <source>%1 %2 s · %3 %4</source>
        <translation>%1 %2 s · %3 %4</translation>
    </message>
    <message>
        <source>Fixed scale · double-click the axis to scale automatically</source>
        <translation>刻度固定 · 双击轴自动缩放</translation>
    </message>
    <message>
        <source>Zeroed (offset %1 %2)</source>
        <translation>已归零（偏移 %1 %2）</translation>
    </message>
    <message>
        <source>Plots over time</source>
        <translation>随时间的曲线图</translation>
    </message>
    <message>
        <source>A and B place the cursors. Left and Right move the active cursor. Up and Down select the signal at the cursors. H hides the curve of this signal; Ctrl+Delete removes it. Plus and Minus change the time range, or the value scale with Ctrl; Ctrl+0 scales automatically. N adds a note, F shows all data, and End returns to the newest samples.</source>
        <translation>A 和 B 放置游标。左右键移动当前游标，上下键选择游标读取的信号。H 隐藏该信号的曲线；Ctrl+Delete 移除曲线。加号和减号改变时间范围，按住 Ctrl 改变数值刻度；Ctrl+0 自动缩放。N 添加备注，F 显示全部数据，End 返回最新样本。</translation>
    </message>
    <message>
        <source>A–B Δt %1 s</source>
        <translation>A–B Δt %1 s</translation>
    </message>
    <message>
        <source>Drop signals here</source>
        <translation>把信号拖放到此处</translation>
    </message>
    <message>
        <source>No samples yet. Connect to a robot.</source>
        <translation>还没有样本。请连接机器人。</translation>
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
        <translation>绕 X 旋转 (RX)</translation>
    </message>
    <message>
        <source>Rotation about Y (RY)</source>
        <translation>绕 Y 旋转 (RY)</translation>
    </message>
    <message>
        <source>Rotation about Z (RZ)</source>
        <translation>绕 Z 旋转 (RZ)</translation>
    </message>
</context>
<context>
    <name>tiller::PoseView</name>
    <message>
        <source>TCP at the flange</source>
        <translation>TCP 在法兰</translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation>TCP 距法兰 %1</translation>
    </message>
    <message>
        <source>in %1 · %2</source>
        <translation>在%1 · %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>TCP pose in %1</source>
        <translation>%1中的 TCP 位姿</translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ₀: displacement from the zero position. Click to show the displacement since the start of the last motion.</source>
        <translation>方向按设置显示。Δ₀：自归零起的位移。点击显示自上次运动开始起的位移。</translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ: displacement since the start of the last motion. Click to set the displacement to zero.</source>
        <translation>方向按设置显示。Δ：自上次运动开始起的位移。点击在此处归零。</translation>
    </message>
    <message>
        <source>TCP in the flange frame: %1</source>
        <translation>法兰坐标系中的 TCP：%1</translation>
    </message>
</context>
<context>
    <name>tiller::PositionsPage</name>
    <message>
        <source>Joints °</source>
        <translation>关节 °</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>原位</translation>
    </message>
    <message>
        <source>Enter a name for the position.</source>
        <translation>请输入位置的名称。</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>将“%1”重命名为“%2”</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>No positions yet.
Jog the arm to a position and press “Set home here” or “Add position”.</source>
        <translation>还没有位置。
把机械臂点动到某处，按“此处设为原位”或“添加位置”。</translation>
    </message>
    <message>
        <source>Safe height</source>
        <translation>安全高度</translation>
    </message>
    <message>
        <source>%1. Press Return to apply the values. Only the stored position changes; the robot does not move.</source>
        <translation>%1。按回车应用。只有保存的位置改变；机器人不移动。</translation>
    </message>
    <message>
        <source>Height in the base frame. Above this height, the cell is free of obstacles, and the TCP may move sideways.</source>
        <translation>基座坐标系中的高度，其上方没有障碍物：TCP 可在其上方横向移动。</translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation>TCP 处</translation>
    </message>
    <message>
        <source>Set the safe height to the current TCP height</source>
        <translation>将安全高度设为 TCP 的当前高度</translation>
    </message>
    <message>
        <source>Set home here</source>
        <translation>此处设为原位</translation>
    </message>
    <message>
        <source>Add position</source>
        <translation>添加位置</translation>
    </message>
    <message>
        <source>Store the current position of the arm</source>
        <translation>保存机械臂的当前位置</translation>
    </message>
    <message>
        <source>Use as home</source>
        <translation>用作原位</translation>
    </message>
    <message>
        <source>Use the selected position as home</source>
        <translation>把所选位置用作原位</translation>
    </message>
    <message>
        <source>Touch up position</source>
        <translation>修正示教位置</translation>
    </message>
    <message>
        <source>Reset to default home</source>
        <translation>恢复默认原位</translation>
    </message>
    <message>
        <source>Rename position</source>
        <translation>重命名位置</translation>
    </message>
    <message>
        <source>Delete position</source>
        <translation>删除位置</translation>
    </message>
    <message>
        <source>Set “%1” to the current position of the arm?</source>
        <translation>将“%1”设为机械臂的当前位置？</translation>
    </message>
    <message>
        <source>The Home button will then move the arm to this position.</source>
        <translation>“原位”按钮会将机械臂移到那里。</translation>
    </message>
    <message>
        <source>Set home</source>
        <translation>设定原位</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Add the position “%1”</source>
        <translation>添加位置“%1”</translation>
    </message>
    <message>
        <source>Select a position to touch up.</source>
        <translation>选择要修正示教的位置。</translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>修正示教“%1”？</translation>
    </message>
    <message>
        <source>Largest joint change: %1 %2.</source>
        <translation>最大关节变化：%1 %2。</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>修正示教</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>修正示教“%1”</translation>
    </message>
    <message>
        <source>Use “%1” as home</source>
        <translation>把“%1”用作原位</translation>
    </message>
    <message>
        <source>Select a position to use as home.</source>
        <translation>选择用作原位的位置。</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>删除“%1”</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>更改“%1”</translation>
    </message>
    <message>
        <source>Set the safe height</source>
        <translation>设定安全高度</translation>
    </message>
    <message>
        <source>Remove the safe height</source>
        <translation>移除安全高度</translation>
    </message>
    <message>
        <source>The Home button moves the arm to the default home position: upright, without self-collision.</source>
        <translation>“原位”按钮将机械臂移到默认原位：直立，无自碰撞。</translation>
    </message>
    <message>
        <source>%1: target of the Home button</source>
        <translation>%1：“原位”按钮的目标</translation>
    </message>
    <message>
        <source>%1 · %2 %3 from the current position</source>
        <translation>%1 · 距此处 %2 %3</translation>
    </message>
    <message>
        <source>A position named “%1” already exists. Choose a different name.</source>
        <translation>“%1”已是另一个位置的名称。请选择其他名称。</translation>
    </message>
</context>
<context>
    <name>tiller::Practice</name>
    <message>
        <source>Start the simulated robot in the Robot menu first.</source>
        <translation>请先启动模拟机器人：在机器人菜单中。</translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes first.</source>
        <translation>请先给机械臂上电并松开制动器。</translation>
    </message>
    <message>
        <source>The safety system has stopped the arm. Use “Recover…” first.</source>
        <translation>机械臂已被安全系统停止。请先使用“恢复…”。</translation>
    </message>
    <message>
        <source>Done. Press “Start” to repeat the task.</source>
        <translation>完成。按“开始”可重复此任务。</translation>
    </message>
    <message>
        <source>Press “Start”.</source>
        <translation>请按“开始”。</translation>
    </message>
</context>
<context>
    <name>tiller::PracticeCard</name>
    <message>
        <source>Practice</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Force Fz in newtons</source>
        <translation>力 Fz（牛顿）</translation>
    </message>
    <message>
        <source>Enter a value and press Return</source>
        <translation>输入数值，按回车</translation>
    </message>
    <message>
        <source>Fz [N]</source>
        <translation>Fz [N]</translation>
    </message>
    <message>
        <source>Previous task</source>
        <translation>上一个任务</translation>
    </message>
    <message>
        <source>Next task</source>
        <translation>下一个任务</translation>
    </message>
    <message>
        <source>Practice · %1 of %2</source>
        <translation>练习 · %1 / %2</translation>
    </message>
    <message>
        <source>Starts or restarts the task</source>
        <translation>开始或重新开始任务</translation>
    </message>
    <message>
        <source>Continues with the next task</source>
        <translation>进入下一个任务</translation>
    </message>
    <message>
        <source>Available after the check above has passed</source>
        <translation>通过上面的检查后可用</translation>
    </message>
</context>
<context>
    <name>tiller::PreflightPage</name>
    <message>
        <source>Good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>未检查</translation>
    </message>
    <message>
        <source>Before you connect to %1</source>
        <translation>连接 %1 之前</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>检查项</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>再次检查</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Keep everyone out of reach of the arm.
Keep the emergency stop within reach: STOP in this window is a software stop.
Start slowly: the initial speed is %1.
Watch the arm, not the screen, while you hold a button.
Release the button to stop the arm.</source>
        <translation>不要让任何人进入机械臂的可达范围。
紧急停止应在手边：此窗口的 STOP 是软件停止。
慢速开始：初始速度为 %1。
按住按钮时看机械臂，不要看屏幕。
松开按钮，机械臂即停止。</translation>
    </message>
    <message>
        <source>Checking %1…</source>
        <translation>正在检查 %1…</translation>
    </message>
    <message>
        <source>Problems found</source>
        <translation>发现问题</translation>
    </message>
    <message>
        <source>Ready, with warnings</source>
        <translation>就绪，有警告</translation>
    </message>
    <message>
        <source>Everything is ready</source>
        <translation>一切就绪</translation>
    </message>
    <message>
        <source>Connect anyway</source>
        <translation>仍然连接</translation>
    </message>
    <message>
        <source>If you connect anyway, the window shows the available data. The red items above may prevent Tiller from taking control or may stop a running motion.</source>
        <translation>若仍然连接，窗口会显示可用的数据。上面的红色项可能妨碍获取控制，或停止正在进行的运动。</translation>
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
        <translation>%1，已禁用</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>%1, running</source>
        <translation>%1，正在运行</translation>
    </message>
    <message>
        <source>%1, breakpoint</source>
        <translation>%1，断点</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1，已更改</translation>
    </message>
</context>
<context>
    <name>tiller::ProgramTab</name>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Show step</source>
        <translation>显示步骤</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Move steps</source>
        <translation>移动步骤</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>更改“%1”</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>Add steps, or edit the selected step</source>
        <translation>添加步骤，或编辑所选步骤</translation>
    </message>
    <message>
        <source>Step fields</source>
        <translation>步骤的字段</translation>
    </message>
    <message>
        <source>New program</source>
        <translation>新建程序</translation>
    </message>
    <message>
        <source>Rename program…</source>
        <translation>重命名程序…</translation>
    </message>
    <message>
        <source>Delete program</source>
        <translation>删除程序</translation>
    </message>
    <message>
        <source>Export script…</source>
        <translation>导出脚本…</translation>
    </message>
    <message>
        <source>Paste steps</source>
        <translation>粘贴步骤</translation>
    </message>
    <message>
        <source>Cut steps</source>
        <translation>剪切步骤</translation>
    </message>
    <message>
        <source>Copy steps</source>
        <translation>复制步骤</translation>
    </message>
    <message>
        <source>Duplicate steps</source>
        <translation>创建步骤副本</translation>
    </message>
    <message>
        <source>Delete steps</source>
        <translation>删除步骤</translation>
    </message>
    <message>
        <source>Disable or enable steps</source>
        <translation>禁用或启用步骤</translation>
    </message>
    <message>
        <source>Move steps up</source>
        <translation>上移步骤</translation>
    </message>
    <message>
        <source>Move steps down</source>
        <translation>下移步骤</translation>
    </message>
    <message>
        <source>Move steps into the section above</source>
        <translation>将步骤移入上方的段</translation>
    </message>
    <message>
        <source>Move steps out of the section</source>
        <translation>将步骤移出该段</translation>
    </message>
    <message>
        <source>Drag steps into the program, or double-click them.</source>
        <translation>将步骤拖入程序，或双击步骤。</translation>
    </message>
    <message>
        <source>⚠ Step %1: %2</source>
        <translation>⚠ 步骤 %1：%2</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>The program can run. Press “Preview” to simulate it.</source>
        <translation>程序可以运行。按“预览”进行仿真。</translation>
    </message>
    <message>
        <source>Add steps</source>
        <translation>添加步骤</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>添加“%1”</translation>
    </message>
    <message>
        <source>Rename program</source>
        <translation>重命名程序</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>将“%1”重命名为“%2”</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>删除“%1”</translation>
    </message>
    <message>
        <source>Disable steps</source>
        <translation>禁用步骤</translation>
    </message>
    <message>
        <source>Enable steps</source>
        <translation>启用步骤</translation>
    </message>
    <message>
        <source>Simulating…</source>
        <translation>正在仿真…</translation>
    </message>
    <message>
        <source>Simulated: the program takes %1 s. No problems found.</source>
        <translation>仿真结果：程序用时 %1 s。未发现问题。</translation>
    </message>
    <message numerus="yes">
        <source>⚠ Simulated: %n problem(s) found. %1</source>
        <translation>
            <numerusform>⚠ 仿真结果：发现 %n 个问题。%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Export script</source>
        <translation>导出脚本</translation>
    </message>
    <message>
        <source>URScript (*.script)</source>
        <translation>URScript (*.script)</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>已导出到 %1</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>正在启动…</translation>
    </message>
    <message>
        <source>Running step %1 (%2)</source>
        <translation>正在运行步骤 %1（%2）</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>正在运行</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>正在停止…</translation>
    </message>
    <message>
        <source>Paused before step %1 (%2)</source>
        <translation>在步骤 %1（%2）之前暂停</translation>
    </message>
    <message>
        <source>Pausing after step %1 (%2)</source>
        <translation>将在步骤 %1（%2）之后暂停</translation>
    </message>
    <message>
        <source>Simulated: two cycles of the endless program take %1 s. No problems found.</source>
        <translation>仿真：循环程序的两个周期用时%1 s。未发现问题。</translation>
    </message>
    <message>
        <source>Check recoverability</source>
        <translation>检查可恢复性</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>检查已取消。</translation>
    </message>
    <message>
        <source>Cancel check</source>
        <translation>取消检查</translation>
    </message>
    <message>
        <source>In simulation, the program can continue after a stop in %1 of %2 steps.</source>
        <translation>在仿真中，程序在%2个步骤中的%1个停止后可以继续。</translation>
    </message>
    <message>
        <source>Add or remove breakpoints</source>
        <translation>添加或移除断点</translation>
    </message>
    <message>
        <source>⚠ The program cannot pause before this step.</source>
        <translation>⚠ 程序不能在此步骤前暂停。</translation>
    </message>
    <message>
        <source>New breakpoints take effect at the next start.</source>
        <translation>新断点在下次启动时生效。</translation>
    </message>
    <message>
        <source>The program is running, so it cannot be deleted. Stop the program first.</source>
        <translation>程序正在运行，无法删除。请先停止程序。</translation>
    </message>
    <message>
        <source>Paused on the robot in step %1 (%2)</source>
        <translation>在步骤 %1（%2）由机器人暂停</translation>
    </message>
    <message>
        <source>Program “%1” deleted. Ctrl+Z restores it.</source>
        <translation>程序“%1”已删除。Ctrl+Z 可恢复。</translation>
    </message>
    <message>
        <source>Import program…</source>
        <translation>导入程序…</translation>
    </message>
    <message>
        <source>Import program</source>
        <translation>导入程序</translation>
    </message>
    <message>
        <source>Robot programs (*.script *.urp *.urpx);;All files (*)</source>
        <translation>机器人程序 (*.script *.urp *.urpx);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <translation>正在导入 %1…</translation>
    </message>
    <message>
        <source>Import “%1”</source>
        <translation>导入“%1”</translation>
    </message>
    <message>
        <source>Imported “%1”.</source>
        <translation>已导入“%1”。</translation>
    </message>
    <message>
        <source>⚠ The import failed. The project is unchanged.</source>
        <translation>⚠ 导入失败。项目未更改。</translation>
    </message>
    <message>
        <source>Step %1 (%2)</source>
        <translation>步骤 %1（%2）</translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation>未检查：%1。</translation>
    </message>
    <message>
        <source>Checking recoverability…</source>
        <translation>正在检查可恢复性…</translation>
    </message>
    <message>
        <source>⚠ Correct the problems in the program first.</source>
        <translation>⚠ 请先更正程序。</translation>
    </message>
    <message>
        <source>Outputs were changed after the stop, so the program cannot continue. Run the program from the beginning.</source>
        <translation>停止后输出已更改，程序无法继续。请从头运行。</translation>
    </message>
    <message>
        <source>The program was changed after the stop, so it cannot continue. Run the program from the beginning.</source>
        <translation>停止后程序已更改，无法继续。请从头运行。</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) changed because the project changed. Press “Preview” to simulate the program.</source>
        <translation>
            <numerusform>项目的更改使 %n 个步骤发生变化。按“预览”对程序进行仿真。</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused before step %1 (%2) because of the maximum hold time. Hold “Continue (hold)” to continue.</source>
        <translation>因最长按住时间，在步骤 %1（%2）之前暂停。按住“继续（按住）”以继续。</translation>
    </message>
    <message>
        <source>Running step %1 (%2). Joint moves are slow because the preview did not run the whole program from this position.</source>
        <translation>正在运行步骤 %1（%2）。预览没有从此位置运行整个程序，因此关节运动较慢。</translation>
    </message>
    <message>
        <source>Not run: %1.</source>
        <translation>未运行：%1。</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectDocument</name>
    <message>
        <source>Delete “%1”</source>
        <translation>删除“%1”</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n waypoints</source>
        <translation>
            <numerusform>删除 %n 个路点</numerusform>
        </translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>更改顺序</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFiles</name>
    <message>
        <source>The damaged project file was kept as %1.</source>
        <translation>损坏的项目文件已保留为 %1</translation>
    </message>
    <message>
        <source>The project could not be saved</source>
        <translation>项目无法保存</translation>
    </message>
    <message>
        <source>%1. Update Tiller to open the file. The file was not changed.</source>
        <translation>%1。请更新 Tiller 后打开。文件保持原样。</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>打开项目</translation>
    </message>
    <message>
        <source>Tiller projects (*.tiller)</source>
        <translation>Tiller 项目 (*.tiller)</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>保存项目</translation>
    </message>
    <message>
        <source>The project could not be opened</source>
        <translation>项目无法打开</translation>
    </message>
    <message>
        <source>Opened a copy of “%1”. Save the copy to a file to keep changes.</source>
        <translation>已打开“%1”的副本。请保存到文件以保留更改。</translation>
    </message>
    <message>
        <source>“%1” is a copy with unsaved changes.</source>
        <translation>“%1”是含有未保存更改的副本。</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>放弃更改</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation>%1 已损坏</translation>
    </message>
    <message>
        <source>%1. Readable waypoints: %2, unreadable: %3. The damaged file is kept.</source>
        <translation>%1。可读路点：%2，不可读：%3。损坏的文件会保留。</translation>
    </message>
    <message numerus="yes">
        <source>Open %n waypoints</source>
        <translation>
            <numerusform>打开 %n 个路点</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes are saved to %1 again.</source>
        <translation>%1 已恢复保存</translation>
    </message>
    <message>
        <source>The other window closed %1. This window saves changes again.</source>
        <translation>另一个窗口已关闭 %1。此窗口恢复保存更改。</translation>
    </message>
    <message>
        <source>%1 is open in another window</source>
        <translation>%1 已在另一个窗口中打开</translation>
    </message>
    <message>
        <source>Opened by %1. Changes in this window are not saved to the file until you take over the project.</source>
        <translation>由 %1 打开。在您接管项目之前，此窗口中的更改不会保存到文件。</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>接管</translation>
    </message>
    <message>
        <source>Save as a copy</source>
        <translation>另存为副本</translation>
    </message>
    <message>
        <source>View only</source>
        <translation>仅查看</translation>
    </message>
    <message>
        <source>Another window or program has changed %1</source>
        <translation>另一个窗口或程序更改了 %1</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新加载</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>两者都保留</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>稍后决定</translation>
    </message>
    <message>
        <source>Reloaded %1</source>
        <translation>已重新加载 %1</translation>
    </message>
    <message>
        <source>The project in this window is now %1.</source>
        <translation>此窗口的项目现为 %1</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>未命名项目</translation>
    </message>
    <message>
        <source>Unsaved work can be recovered</source>
        <translation>可恢复未保存的工作</translation>
    </message>
    <message>
        <source>“%1” was changed on %2 and not saved to a file.</source>
        <translation>“%1”于 %2 更改，但未保存到文件。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Ask again next time</source>
        <translation>下次再问</translation>
    </message>
    <message>
        <source>%1 has unsaved changes. %2</source>
        <translation>%1 有未保存的更改。%2</translation>
    </message>
    <message>
        <source>The project has unsaved changes.</source>
        <translation>项目有未保存的更改。</translation>
    </message>
    <message>
        <source>“Keep both” saves the project of this window to a second file. “Reload” shows the new content. Tiller then offers to restore the unsaved changes at the next start.</source>
        <translation>“两者都保留”将此窗口的项目保存到第二个文件。“重新加载”显示新内容；此窗口未保存的更改将在下次启动时提供。</translation>
    </message>
    <message>
        <source>Unreadable boxes and planes of the cell: %1. Collisions with these objects are not prevented.</source>
        <translation>无法读取的单元长方体和平面：%1。与它们的碰撞不会被阻止。</translation>
    </message>
    <message>
        <source>The unsaved work in “%1” will be deleted. This cannot be undone.</source>
        <translation>“%1”中未保存的工作将被删除。此操作无法撤销。</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>新建项目</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>The project could not be taken over</source>
        <translation>无法接管项目</translation>
    </message>
    <message>
        <source>%1 already exists. Choose a different name for the new project.</source>
        <translation>%1 已存在。请为新项目选择其他名称。</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFit</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 以及另外 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>TCP of %1</source>
        <translation>%1 的 TCP</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but a %2 is connected. The same joint positions lead to different poses.</source>
        <translation>项目是用 %1 示教的，但连接的是 %2。相同的关节位置会得到不同的位姿。</translation>
    </message>
    <message>
        <source>The project uses the TCP “%1”. The active TCP of the robot differs by %2.</source>
        <translation>项目使用 TCP“%1”。机器人当前的 TCP 相差 %2。</translation>
    </message>
    <message>
        <source>The project matches the connected robot.</source>
        <translation>项目与已连接的机器人相符。</translation>
    </message>
    <message>
        <source>No robot is connected. Connect the robot that belongs to this project.</source>
        <translation>未连接机器人。请连接此项目的机器人。</translation>
    </message>
    <message>
        <source>Keep poses</source>
        <translation>保持位姿</translation>
    </message>
    <message>
        <source>Keep joints</source>
        <translation>保持关节</translation>
    </message>
    <message>
        <source>TCP differs from the project</source>
        <translation>TCP 与项目不同</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>在机器人上设置“%1”</translation>
    </message>
    <message>
        <source>Keep the robot&apos;s TCP</source>
        <translation>保持机器人的 TCP</translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same poses</source>
        <translation>从 %1 转换到 %2，保持位姿</translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same joint positions</source>
        <translation>从 %1 转换到 %2，保持关节</translation>
    </message>
    <message>
        <source>Out of reach: %1.</source>
        <translation>不可达：%1。</translation>
    </message>
    <message>
        <source>Removed because they are out of reach: %1. Press Ctrl+Z to restore them.</source>
        <translation>因不可达而移除：%1。撤销可恢复。</translation>
    </message>
    <message>
        <source>Some positions are out of reach</source>
        <translation>部分位置不可达</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>The robot model is not known yet. Wait until the robot reports the model.</source>
        <translation>尚不知道机器人的型号。请等待机器人报告。</translation>
    </message>
    <message>
        <source>Project for a different robot model</source>
        <translation>用于其他机器人型号的项目</translation>
    </message>
    <message>
        <source>“Keep poses” recalculates the joint positions; the tool reaches the same poses. “Keep joints” keeps the arm configuration; the tool reaches different poses. Until you decide, moves to positions in the project are blocked.</source>
        <translation>“保持位姿”重新计算关节位置，工具到达相同的位姿。“保持关节”保持机械臂的构型，工具到达不同的位姿。在您决定之前，不能移动到项目中的位置。</translation>
    </message>
    <message>
        <source>With the robot&apos;s TCP, the flange moves to the same poses as taught, but the TCP does not. Until you decide, moves to positions in the project are blocked.</source>
        <translation>使用机器人的 TCP 时，法兰会到达示教的位姿，但 TCP 不会。在您决定之前，不能移动到项目中的位置。</translation>
    </message>
    <message>
        <source>Moves to positions in this project are blocked</source>
        <translation>不能移动到此项目中的位置</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectStore</name>
    <message>
        <source>%1 — a copy, not saved to a file</source>
        <translation>%1 — 副本，未保存到文件</translation>
    </message>
    <message>
        <source>Project not saved to a file</source>
        <translation>项目未保存到文件</translation>
    </message>
    <message>
        <source>disk full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>%1 — not saved: %2</source>
        <translation>%1 — 未保存：%2</translation>
    </message>
    <message>
        <source>%1 — saving…</source>
        <translation>%1 — 正在保存…</translation>
    </message>
    <message>
        <source>%1 — saved</source>
        <translation>%1 — 已保存</translation>
    </message>
    <message>
        <source>No file is selected for the project. Save the project to a file first.</source>
        <translation>未为项目选择文件。请先将项目保存到文件。</translation>
    </message>
    <message>
        <source>%1 — open in another window; changes here are not saved</source>
        <translation>%1 — 已在另一个窗口中打开，此处的更改不会保存</translation>
    </message>
    <message>
        <source>%1 — changed by another program; changes here are not saved</source>
        <translation>%1 — 已被其他程序更改，此处的更改不会保存</translation>
    </message>
    <message>
        <source>Unsaved project</source>
        <translation>未保存的项目</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>其他程序</translation>
    </message>
    <message>
        <source>%1 — new</source>
        <translation>%1 — 新建</translation>
    </message>
    <message>
        <source>%1 is open in another window (%2). Close the project in that window, or save under a different name.</source>
        <translation>%1 已在另一个窗口中打开（%2）。请在那里关闭，或以其他名称保存。</translation>
    </message>
    <message>
        <source>%1 was changed by another program. Reload the project, or save it under a different name.</source>
        <translation>%1 已被其他程序更改。请重新加载，或以其他名称保存。</translation>
    </message>
</context>
<context>
    <name>tiller::RangeStatisticsCache</name>
    <message>
        <source>The range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation>该范围包含不同机器人的样本。请将光标 A 和 B 放在同一台机器人的数据中。</translation>
    </message>
</context>
<context>
    <name>tiller::RecordingsDialog</name>
    <message>
        <source>Recordings</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>选择文件夹</translation>
    </message>
    <message>
        <source>Search recordings</source>
        <translation>搜索记录</translation>
    </message>
    <message>
        <source>Search name, date, metadata and notes</source>
        <translation>搜索名称、日期、元数据和备注</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>元数据</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>This folder contains no recordings.</source>
        <translation>此文件夹中没有记录。</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n recording(s)</source>
        <translation>
            <numerusform>%1 / %n 个记录</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reading %n file(s)…</source>
        <translation>
            <numerusform>正在读取 %n 个文件…</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder with recordings</source>
        <translation>记录文件夹</translation>
    </message>
</context>
<context>
    <name>tiller::RecoveryPage</name>
    <message>
        <source>Recovery</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>TCP 处的力</translation>
    </message>
    <message>
        <source>Joint current</source>
        <translation>关节电流</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>TCP 速度</translation>
    </message>
    <message>
        <source>Waiting for data from the robot…</source>
        <translation>等待机器人的数据…</translation>
    </message>
    <message>
        <source>Stopped at X %1, Y %2, Z %3.</source>
        <translation>停止位置：X %1，Y %2，Z %3。</translation>
    </message>
    <message>
        <source>Suspected joint: %1 (largest deviation from its target current).</source>
        <translation>可疑关节：%1（电流与目标偏差最大）。</translation>
    </message>
    <message>
        <source> (%1 s)</source>
        <translation> (%1 s)</translation>
    </message>
    <message>
        <source>Tick the items that you have checked.</source>
        <translation>请勾选您已检查的项目。</translation>
    </message>
    <message>
        <source>Command sent; waiting for the robot…</source>
        <translation>命令已发送；等待机器人…</translation>
    </message>
</context>
<context>
    <name>tiller::RegisterPanel</name>
    <message>
        <source>General purpose registers</source>
        <translation>通用寄存器</translation>
    </message>
    <message>
        <source>Int %1</source>
        <translation>整数 %1</translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation>浮点 %1</translation>
    </message>
    <message>
        <source>Int</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>浮点</translation>
    </message>
    <message>
        <source>Bit</source>
        <translation>位</translation>
    </message>
    <message>
        <source>Input register type</source>
        <translation>输入寄存器的类型</translation>
    </message>
    <message>
        <source>Input register number</source>
        <translation>输入寄存器的编号</translation>
    </message>
    <message>
        <source>Input register value</source>
        <translation>输入寄存器的值</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
</context>
<context>
    <name>tiller::ReplayBand</name>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>返回实时</translation>
    </message>
    <message>
        <source>Show the current state of the robot. The recording stays open in the plots.</source>
        <translation>显示机器人的当前状态。录制仍在曲线图中打开。</translation>
    </message>
</context>
<context>
    <name>tiller::RobotPopup</name>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Popup on the robot</source>
        <translation>机器人上的弹窗</translation>
    </message>
    <message>
        <source>Tiller could not close the popup. Close the popup on the teach pendant.</source>
        <translation>Tiller 无法关闭弹出窗口。请在示教器上关闭。</translation>
    </message>
    <message>
        <source>No data from the robot. Close the popup on the teach pendant.</source>
        <translation>没有来自机器人的数据。请在示教器上关闭弹窗。</translation>
    </message>
    <message numerus="yes">
        <source>%n more popup(s) on the robot.</source>
        <translation>
            <numerusform>机器人上还有 %n 个。</numerusform>
        </translation>
    </message>
    <message>
        <source>A waiting program continues when the popup is closed: keep clear of the arm.</source>
        <translation>等待它的程序在关闭后会继续：请远离机械臂。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Close the popup on the robot</source>
        <translation>关闭机器人上的弹窗</translation>
    </message>
    <message>
        <source>Hide the popup</source>
        <translation>隐藏弹窗</translation>
    </message>
    <message>
        <source>Read the popup first.</source>
        <translation>请先阅读弹出消息。</translation>
    </message>
    <message>
        <source>The popup is being closed.</source>
        <translation>正在关闭弹出窗口。</translation>
    </message>
</context>
<context>
    <name>tiller::RobotSession</name>
    <message>
        <source>Stopped: %1 (%2 ms, %3)</source>
        <translation>已停止：%1（%2 ms，%3）</translation>
    </message>
    <message>
        <source>Connecting to %1 (%2)</source>
        <translation>正在连接 %1（%2）</translation>
    </message>
    <message>
        <source>Disconnected from %1</source>
        <translation>已断开 %1</translation>
    </message>
    <message>
        <source>In control</source>
        <translation>已控制</translation>
    </message>
    <message>
        <source>Taking control was cancelled by a stop.</source>
        <translation>获取控制权因停止而取消。</translation>
    </message>
    <message>
        <source>Connected to %1</source>
        <translation>已连接 %1</translation>
    </message>
    <message>
        <source>Safety mode is Normal again</source>
        <translation>安全模式已恢复“正常”</translation>
    </message>
    <message>
        <source>Program: %1</source>
        <translation>程序：%1</translation>
    </message>
    <message>
        <source>Program error on line %1, column %2: %3</source>
        <translation>程序错误，第 %1 行第 %2 列：%3</translation>
    </message>
    <message>
        <source>Popup on the robot: %1 %2</source>
        <translation>机器人上的弹窗：%1 %2</translation>
    </message>
    <message>
        <source>The program on the robot is waiting for a response on the teach pendant: %1</source>
        <translation>机器人上的程序在等待示教器上的答复：%1</translation>
    </message>
    <message>
        <source>Not connected to a robot.</source>
        <translation>未连接到机器人。</translation>
    </message>
    <message>
        <source>Waiting for data from %1.</source>
        <translation>等待 %1 的数据。</translation>
    </message>
    <message>
        <source>Connecting to %1…</source>
        <translation>正在连接 %1…</translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically; motion does not resume.</source>
        <translation>没有来自机器人的数据。正在自动重连；动作不会恢复。</translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation>机器人数据延迟。正在等待新数据。</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>正在获取控制…</translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. STOP still works.</source>
        <translation>仅监视：此窗口不更改机器人的任何状态。STOP 仍然有效。</translation>
    </message>
    <message>
        <source>“Monitor only” is off. Commands to the robot are enabled.</source>
        <translation>“仅监视”已关闭。可以向机器人发送命令。</translation>
    </message>
    <message>
        <source>%1: refused. %2</source>
        <translation>%1：已拒绝。%2</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>获取控制</translation>
    </message>
    <message>
        <source>Control was lost: the control connection did not respond for 0.5 s or was closed. STOP, Space and Esc still stop the robot. Take control again.</source>
        <translation>已失去控制：控制连接在 0.5 秒内无响应或已关闭。STOP、空格键和 Esc 仍可停止机器人。请重新获取控制。</translation>
    </message>
    <message numerus="yes">
        <source>The robot is sending too many messages. %n messages were not shown.</source>
        <translation>
            <numerusform>机器人发送的消息过多。%n 条消息未显示。</numerusform>
        </translation>
    </message>
    <message>
        <source>Move refused: %1.</source>
        <translation>移动被拒绝：%1。</translation>
    </message>
    <message>
        <source>Moves are refused. %1.</source>
        <translation>移动被拒绝。%1。</translation>
    </message>
    <message>
        <source>No data from the robot: the arm may be moving. Reconnecting automatically.</source>
        <translation>没有来自机器人的数据：机械臂可能在运动。正在自动重新连接。</translation>
    </message>
    <message>
        <source>A program is running. Wait until the program ends, or stop the program.</source>
        <translation>程序正在运行。请等待程序结束，或停止程序。</translation>
    </message>
    <message>
        <source>Stopping the other client&apos;s program to take control.</source>
        <translation>为获取控制权，正在停止其他客户端的程序。</translation>
    </message>
    <message>
        <source>The program on the robot is paused.</source>
        <translation>机器人上的程序已暂停。</translation>
    </message>
    <message>
        <source>Robot mode: %1</source>
        <translation>机器人模式：%1</translation>
    </message>
    <message>
        <source>Stopped: %1 (%2)</source>
        <translation>已停止：%1（%2）</translation>
    </message>
    <message>
        <source>Not stopped: a program is still running (%1). Press STOP again.</source>
        <translation>未停止：程序仍在运行（%1）。请再次按下 STOP。</translation>
    </message>
    <message>
        <source>Not stopped: the arm is still moving (%1). Press STOP again.</source>
        <translation>未停止：机械臂在运动（%1）。请再次按 STOP。</translation>
    </message>
    <message>
        <source>The robot at %1 is a %2 now. It was a %3 before.</source>
        <translation>%1 处的机器人现在是 %2，之前是 %3。</translation>
    </message>
    <message>
        <source>A program from another client has replaced the running program.</source>
        <translation>其他客户端的程序替换了正在运行的程序。</translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot. Taking control ends that program.</source>
        <translation>其他客户端的程序已接管机器人。获取控制权会结束该程序。</translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot, and control was lost. Taking control again ends that program.</source>
        <translation>其他客户端的程序已接管机器人，控制权已丢失。重新获取控制权会结束该程序。</translation>
    </message>
    <message>
        <source>A program from another client is running on the robot.</source>
        <translation>机器人上正在运行其他客户端的程序。</translation>
    </message>
    <message>
        <source>while moving to point %1 of %2: %3</source>
        <translation>在前往第 %1 个点（共 %2 个）的途中：%3</translation>
    </message>
    <message>
        <source>The program from the other client has ended.</source>
        <translation>其他客户端的程序已结束。</translation>
    </message>
    <message>
        <source>The program started while Tiller was not connected, at most %1 s before this entry.</source>
        <translation>程序在与 Tiller 断开连接期间启动，最多在此条目之前 %1 秒。</translation>
    </message>
</context>
<context>
    <name>tiller::RobotiqLink</name>
    <message>
        <source>Connecting to the gripper…</source>
        <translation>正在连接夹爪…</translation>
    </message>
    <message>
        <source>The gripper does not send any values. Power on the arm. If the problem persists, check the gripper cable at the wrist.</source>
        <translation>夹爪没有发送数值。请给机械臂上电；若问题仍存在，检查手腕处的夹爪电缆。</translation>
    </message>
    <message>
        <source>The gripper responds again.</source>
        <translation>夹爪恢复响应。</translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation>夹爪已激活。</translation>
    </message>
    <message>
        <source>The gripper was not activated. Check that nothing blocks its fingers, then press “Activate” again.</source>
        <translation>夹爪没有激活。确认手指没有受阻，然后再按“激活”。</translation>
    </message>
    <message>
        <source>The gripper holds an object (%1 open).</source>
        <translation>夹爪夹住了物体（张开 %1）。</translation>
    </message>
    <message>
        <source>The gripper lost the object.</source>
        <translation>夹爪丢失了物体。</translation>
    </message>
    <message>
        <source>Gripper: activate</source>
        <translation>夹爪：激活</translation>
    </message>
    <message>
        <source>%1 failed. %2</source>
        <translation>%1 失败。%2</translation>
    </message>
    <message>
        <source>No gripper service responds at %1:%2. Install Robotiq&apos;s URCap on the robot and select the gripper in the robot&apos;s installation.</source>
        <translation>%1:%2 处没有夹爪应答。请在机器人上安装 Robotiq 的 URCap，并在其安装设置中选择夹爪。</translation>
    </message>
    <message>
        <source>The gripper is not responding. Check the cable at the wrist and the gripper settings on the Installation tab of the teach pendant. If the problem persists, restart the robot.</source>
        <translation>夹爪不应答。请检查手腕处的电缆和示教器“安装设置”选项卡中的夹爪设置。若问题仍存在，请重启机器人。</translation>
    </message>
    <message>
        <source>The gripper did not accept the command. Activate the gripper. If it is already active, check its settings on the Installation tab of the teach pendant.</source>
        <translation>夹爪没有接受命令。请激活它；若已激活，请在示教器的“安装设置”选项卡中检查其设置。</translation>
    </message>
    <message>
        <source>The gripper is activating; the command runs afterwards.</source>
        <translation>夹爪正在激活；随后执行命令。</translation>
    </message>
    <message>
        <source>The gripper received a motion command before it was active. Press “Activate”.</source>
        <translation>夹爪在激活前被指令移动。请按“激活”。</translation>
    </message>
    <message>
        <source>The gripper is too hot. Let it cool down, then press “Activate”.</source>
        <translation>夹爪过热。待其冷却后按“激活”。</translation>
    </message>
    <message>
        <source>The gripper received no command for one second. Check its cable at the wrist, then press “Activate”.</source>
        <translation>夹爪一秒内没有收到命令。检查手腕处的电缆，然后按“激活”。</translation>
    </message>
    <message>
        <source>The supply voltage of the gripper is too low. Set the tool voltage to 24 V, then press “Activate”.</source>
        <translation>夹爪电压不足。把工具电压设为 24 V，然后按“激活”。</translation>
    </message>
    <message>
        <source>The automatic release of the gripper is in progress. Wait until it is complete, then press “Activate”.</source>
        <translation>夹爪正在自动释放。等其结束后按“激活”。</translation>
    </message>
    <message>
        <source>The automatic release of the gripper is complete. Press “Activate”.</source>
        <translation>夹爪的自动释放已结束。请按“激活”。</translation>
    </message>
    <message>
        <source>The gripper has an internal fault. Press “Activate”. If the fault returns, contact Robotiq.</source>
        <translation>夹爪有内部故障。请按“激活”；若再次出现，请咨询 Robotiq。</translation>
    </message>
    <message>
        <source>Activation failed. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation>激活失败。确认手指没有受阻，然后按“激活”。</translation>
    </message>
    <message>
        <source>The gripper draws too much current. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation>夹爪电流过大。确认手指没有受阻，然后按“激活”。</translation>
    </message>
    <message>
        <source>The gripper reports fault %1. Press “Activate”. If the fault returns, see the gripper manual.</source>
        <translation>夹爪报告故障 %1。请按“激活”；若再次出现，查看其手册。</translation>
    </message>
    <message>
        <source>The robot closed the connection to the gripper and may be restarting. Tiller reconnects automatically; the gripper continues to hold its object.</source>
        <translation>机器人结束了与夹爪的连接，可能正在重启。会自行恢复；夹爪继续夹持。</translation>
    </message>
</context>
<context>
    <name>tiller::RouteRunner</name>
    <message>
        <source>The route has no waypoints. Teach or select waypoints first.</source>
        <translation>路线中没有路点。请先示教或选择路点。</translation>
    </message>
    <message>
        <source>A waypoint of the route was deleted from the project. Select the waypoints of the route again.</source>
        <translation>路线中的某个路点已不在此项目中。请重新选择路线的路点。</translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation>“%1”：%2</translation>
    </message>
    <message>
        <source>A loop requires at least two waypoints. Select more waypoints, or clear “Loop”.</source>
        <translation>循环至少需要两个路点。请选择更多路点，或关闭循环。</translation>
    </message>
    <message>
        <source>There is no waypoint before the first waypoint of the route.</source>
        <translation>路线的第一个路点没有上一个路点。</translation>
    </message>
</context>
<context>
    <name>tiller::RunBar</name>
    <message>
        <source>Run (hold)</source>
        <translation>运行（按住）</translation>
    </message>
    <message>
        <source>Run the program (hold)</source>
        <translation>运行程序，按住</translation>
    </message>
    <message>
        <source>Move to start (hold)</source>
        <translation>到起点（按住）</translation>
    </message>
    <message>
        <source>Move to the start position (hold)</source>
        <translation>移动到起始位置，按住</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>No program is selected. Create or select a program first.</source>
        <translation>未选择程序。请先创建或选择程序。</translation>
    </message>
    <message>
        <source>Stops the program</source>
        <translation>停止程序</translation>
    </message>
    <message>
        <source>Runs the program at the programmed speed until it ends or is stopped. The arm also stops when Tiller closes or the connection is lost.</source>
        <translation>以程序设定的速度运行，直到结束或被停止。关闭 Tiller 或连接中断时机械臂也会停止。</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>单步</translation>
    </message>
    <message>
        <source>Finish cycle</source>
        <translation>完成循环</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation>没有程序在运行。</translation>
    </message>
    <message>
        <source>Continues the program</source>
        <translation>继续程序</translation>
    </message>
    <message>
        <source>Pauses the program before its next step</source>
        <translation>在下一步之前暂停程序</translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation>请先暂停程序。</translation>
    </message>
    <message>
        <source>Runs one step and then pauses the program</source>
        <translation>运行一步，然后暂停程序</translation>
    </message>
    <message>
        <source>The program has no endless loop.</source>
        <translation>程序没有无限循环。</translation>
    </message>
    <message>
        <source>Ends the program before the next cycle of its endless loop</source>
        <translation>在无限循环的下一周期之前结束程序</translation>
    </message>
    <message>
        <source>Start from here</source>
        <translation>从此处</translation>
    </message>
    <message>
        <source>Select one step.</source>
        <translation>请选择一个步骤。</translation>
    </message>
    <message>
        <source>Moves all joints to the start position while the button is held</source>
        <translation>按住按钮时将所有关节移动到起始位置</translation>
    </message>
    <message>
        <source>Continue at %1</source>
        <translation>从%1继续</translation>
    </message>
    <message>
        <source>Continue (hold)</source>
        <translation>继续（按住）</translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation>程序已在机器人上暂停。请在示教器上恢复。</translation>
    </message>
    <message>
        <source>Run program</source>
        <translation>运行程序</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>The value of “%1” is being changed.</source>
        <translation>正在更改“%1”的值。</translation>
    </message>
    <message>
        <source>Continue program</source>
        <translation>继续程序</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>From step %1 ✕</source>
        <translation>从步骤 %1 ✕</translation>
    </message>
    <message>
        <source>Starts the program at the selected step. Move the arm to the start position first.</source>
        <translation>从所选步骤开始程序。请先将机械臂移动到起始位置。</translation>
    </message>
    <message>
        <source>Hold “Continue (hold)” to continue.</source>
        <translation>按住“继续（按住）”以继续。</translation>
    </message>
    <message>
        <source>The preview did not run %1, so these steps were not checked for collisions and other problems. Test them with “Run (hold)”, or set the inputs and preview the program again.</source>
        <translation>预览未运行%1，因此这些步骤中的碰撞和其他问题未知。请用“运行（按住）”测试，或设置输入后重新预览。</translation>
    </message>
    <message>
        <source>A variable was changed. The moves after this change were not previewed, so they were not checked for collisions and other problems.</source>
        <translation>变量已更改。更改之后的运动未经预览，因此碰撞和其他问题未知。</translation>
    </message>
    <message>
        <source>Runs the program while the button is held, no faster than the jog speed. The program ends when you release the button. If the arm is not at the start position of a complete preview, joint moves are slower so that no possible path exceeds the speed limit.</source>
        <translation>按住按钮时运行程序，速度不超过点动速度。松开按钮时程序结束。如果机械臂不在完整预览的起始位置，关节运动会更慢，因为速度限制必须适用于所有可能的路径。</translation>
    </message>
    <message>
        <source>The program starts at step %1. Press to start from the beginning instead.</source>
        <translation>程序从步骤 %1 开始。按下可恢复为从头开始。</translation>
    </message>
    <message>
        <source>The program started with a jog speed of %1 and cannot continue at a lower speed. Select this speed again, or stop the program.</source>
        <translation>程序以 %1 的点动速度启动，无法以更低的速度继续。请重新选择此速度，或停止程序。</translation>
    </message>
    <message>
        <source>%1 Preview the program with the current inputs, or select a higher jog speed, so that the program can run to the end.</source>
        <translation>%1 请用当前输入预览程序，或选择更高的点动速度，使其能够运行到结束。</translation>
    </message>
</context>
<context>
    <name>tiller::SceneDock</name>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>No joint positions to replay</source>
        <translation>没有可回放的关节位置</translation>
    </message>
    <message>
        <source>Robot model unknown</source>
        <translation>机器人型号未知</translation>
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
        <translation>默认视图（透视）</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Look from the front: base X to the right, Z up</source>
        <translation>从正面看：基座的 X 向右，Z 向上</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧面</translation>
    </message>
    <message>
        <source>Look from the side: base Y to the right, Z up</source>
        <translation>从侧面看：基座的 Y 向右，Z 向上</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>顶部</translation>
    </message>
    <message>
        <source>Look from above: base X to the right, Y up</source>
        <translation>从上方看：基座的 X 向右，Y 向上</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view</source>
        <translation>把机械臂、目标和路点纳入画面</translation>
    </message>
</context>
<context>
    <name>tiller::SceneView</name>
    <message>
        <source>Arm view</source>
        <translation>机械臂视图</translation>
    </message>
    <message>
        <source>Drag or use the arrow keys to rotate the view; hold Shift or the right button to pan. Zoom with the wheel or with plus and minus. Double-click or press Home for the default view. The robot does not move.</source>
        <translation>拖动或用方向键旋转视图；按住 Shift 或右键平移。用滚轮或加减键缩放。双击或按 Home 恢复默认视图。这里的任何操作都不会移动机器人。</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>ghost “%1” · out of reach</source>
        <translation>虚影“%1” · 不可达</translation>
    </message>
    <message>
        <source>ghost “%1” · reachable · largest rotation %2 %3 · %4 s at %5</source>
        <translation>虚影“%1” · 可达 · 最大转动 %2 %3 · %5 时 %4 s</translation>
    </message>
    <message>
        <source>1 name hidden: zoom in</source>
        <translation>隐藏了 1 个名称：请放大</translation>
    </message>
    <message numerus="yes">
        <source>%n names hidden: zoom in</source>
        <translation>
            <numerusform>隐藏了 %n 个名称：请放大</numerusform>
        </translation>
    </message>
    <message>
        <source>ghost “%1” · reachable</source>
        <translation>虚影“%1” · 可达</translation>
    </message>
    <message>
        <source>ghost “%1” · %2 · largest rotation %3 %4 · %5 s at %6</source>
        <translation>虚影“%1” · %2 · 最大转动 %3 %4 · %6 时 %5 s</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>更改后：%1</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>更改前：%1</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>LIVE ARM</source>
        <translation>实时机械臂</translation>
    </message>
    <message>
        <source>ghost “%1” · taught with a different robot model</source>
        <translation>虚影“%1”· 用其他机器人型号示教</translation>
    </message>
</context>
<context>
    <name>tiller::SignalStore</name>
    <message>
        <source>compute a signal</source>
        <translation>计算信号</translation>
    </message>
    <message>
        <source>%1 is not part of the same RTDE packets as the other signals.</source>
        <translation>%1 与其他信号不在同一数据包中。</translation>
    </message>
    <message>
        <source>Derived</source>
        <translation>派生</translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. Remove other signals first.</source>
        <translation>这些信号超过机器人一次发送的数量：请先去除其他信号。</translation>
    </message>
    <message>
        <source>The recording %1 contains no samples. Open a different recording.</source>
        <translation>录制 %1 不包含样本。请打开其他录制。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2 的 %1</translation>
    </message>
    <message>
        <source>The history memory is too small to show %1. Increase the memory in the “Layout” menu.</source>
        <translation>历史内存不足以显示 %1：请在“布局”菜单中增加。</translation>
    </message>
    <message>
        <source>%1 could not be computed completely: %2</source>
        <translation>无法完整计算 %1：%2</translation>
    </message>
</context>
<context>
    <name>tiller::SignalTree</name>
    <message>
        <source>Search signals</source>
        <translation>搜索信号</translation>
    </message>
    <message>
        <source>Robot signals</source>
        <translation>机器人的信号</translation>
    </message>
    <message>
        <source>New: |F| [N] = norm(…)</source>
        <translation>新建：|F| [N] = norm(…)</translation>
    </message>
    <message>
        <source>Derived signal</source>
        <translation>派生信号</translation>
    </message>
    <message>
        <source>%1: not sent by this robot.</source>
        <translation>%1：此机器人不发送。</translation>
    </message>
    <message>
        <source>Enter a name, an optional unit in brackets, and an expression that uses signals. Drag signals here to insert their names. Functions: norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ and standard functions. Press Return to create the signal.</source>
        <translation>输入名称、可选的方括号单位和信号表达式。把信号拖到此处可插入其名称。函数：norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ 和标准函数。按回车键创建信号。</translation>
    </message>
</context>
<context>
    <name>tiller::SimulationChip</name>
    <message>
        <source>Simulation</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>This robot is simulated. No real robot moves.</source>
        <translation>此机器人是模拟的。没有真实机器人移动。</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>模拟</translation>
    </message>
</context>
<context>
    <name>tiller::SpeedChip</name>
    <message>
        <source>Speed slider</source>
        <translation>速度滑块</translation>
    </message>
    <message>
        <source>Robot speed slider, 2 to 100 %</source>
        <translation>机器人的速度滑块，2 至 100 %</translation>
    </message>
    <message>
        <source>SPEED</source>
        <translation>速度</translation>
    </message>
</context>
<context>
    <name>tiller::StatusLine</name>
    <message>
        <source>Recording, project and last message</source>
        <translation>录制、项目和最后一条消息</translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation>REC %1</translation>
    </message>
    <message>
        <source>%1 samples · %2 · %3 free</source>
        <translation>%1 个样本 · %2 · 剩余 %3</translation>
    </message>
    <message>
        <source>Recording stopped</source>
        <translation>录制已结束</translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation>未录制</translation>
    </message>
</context>
<context>
    <name>tiller::StepForm</name>
    <message>
        <source>Select one step to edit it.</source>
        <translation>请选择一个步骤进行编辑。</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>（无）</translation>
    </message>
</context>
<context>
    <name>tiller::StepPalette</name>
    <message>
        <source>Steps to add</source>
        <translation>可添加的步骤</translation>
    </message>
</context>
<context>
    <name>tiller::StepTree</name>
    <message>
        <source>Program steps</source>
        <translation>程序的步骤</translation>
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
        <translation>停止</translation>
    </message>
    <message>
        <source>Software stop. Not an emergency stop. Power stays on.</source>
        <translation>软件停止。不是紧急停止。电源保持接通。</translation>
    </message>
    <message>
        <source>Space and Esc also stop the arm.</source>
        <translation>空格键和 Esc 也可停止机械臂。</translation>
    </message>
    <message>
        <source>Click to stop the arm. Space and Esc stop the arm only while this window is in control.</source>
        <translation>单击以停止。仅当此窗口拥有控制时，空格键和 Esc 才会停止。</translation>
    </message>
    <message>
        <source>Space / Esc</source>
        <translation>空格 / Esc</translation>
    </message>
    <message>
        <source>click</source>
        <translation>单击</translation>
    </message>
    <message>
        <source>not an e-stop</source>
        <translation>非紧急停止</translation>
    </message>
</context>
<context>
    <name>tiller::StopPlot</name>
    <message>
        <source>Maximum in the last five seconds: %1</source>
        <translation>最近五秒的最大值：%1</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>no data before the stop</source>
        <translation>停止前无数据</translation>
    </message>
</context>
<context>
    <name>tiller::TcpPage</name>
    <message>
        <source>In use</source>
        <translation>使用中</translation>
    </message>
    <message>
        <source>Enter a name for the TCP.</source>
        <translation>请输入 TCP 的名称。</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>将“%1”重命名为“%2”</translation>
    </message>
    <message>
        <source>TCPs</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>No TCPs yet.
Press “From robot” to store the active TCP, or “Teach…” to teach a TCP with the arm.</source>
        <translation>还没有 TCP。
按“取自机器人”保存当前 TCP，或按“示教…”用机械臂示教。</translation>
    </message>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>Relative to the flange. Press Return to apply the value to the project. The robot&apos;s TCP does not change.</source>
        <translation>相对于法兰。按回车应用到项目。机器人的 TCP 不变。</translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation>设到机器人</translation>
    </message>
    <message>
        <source>Use this TCP and set it on the robot</source>
        <translation>使用此 TCP 并设到机器人</translation>
    </message>
    <message>
        <source>Teach…</source>
        <translation>示教…</translation>
    </message>
    <message>
        <source>Teach a TCP with the arm</source>
        <translation>用机械臂示教 TCP</translation>
    </message>
    <message>
        <source>From robot</source>
        <translation>取自机器人</translation>
    </message>
    <message>
        <source>Store the active TCP of the robot</source>
        <translation>保存机器人当前 TCP</translation>
    </message>
    <message>
        <source>Teach the selected TCP again…</source>
        <translation>重新示教所选 TCP…</translation>
    </message>
    <message>
        <source>Enter new TCP</source>
        <translation>输入新的 TCP</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Rename TCP</source>
        <translation>重命名 TCP</translation>
    </message>
    <message>
        <source>Duplicate TCP</source>
        <translation>复制 TCP</translation>
    </message>
    <message>
        <source>Delete TCP</source>
        <translation>删除 TCP</translation>
    </message>
    <message>
        <source>Change the TCP “%1”</source>
        <translation>更改 TCP“%1”</translation>
    </message>
    <message>
        <source>Teach the TCP “%1” again</source>
        <translation>重新示教 TCP“%1”</translation>
    </message>
    <message>
        <source>Add the TCP “%1”</source>
        <translation>添加 TCP“%1”</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>未连接机器人。请连接，或试用模拟器。</translation>
    </message>
    <message>
        <source>The active TCP of the robot is already stored as “%1”.</source>
        <translation>机器人当前的 TCP 已保存为“%1”。</translation>
    </message>
    <message>
        <source>Teach “%1” again</source>
        <translation>重新示教“%1”</translation>
    </message>
    <message>
        <source>Teach a new TCP</source>
        <translation>示教新 TCP</translation>
    </message>
    <message>
        <source>Select the TCP to set.</source>
        <translation>选择要设定的 TCP。</translation>
    </message>
    <message>
        <source>Use the TCP “%1”</source>
        <translation>使用 TCP“%1”</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller 未取得控制。请先获取控制。</translation>
    </message>
    <message>
        <source>Delete the TCP “%1”</source>
        <translation>删除 TCP“%1”</translation>
    </message>
    <message>
        <source>%1, relative to the flange</source>
        <translation>%1，从法兰起</translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation>%1，机器人当前使用</translation>
    </message>
    <message>
        <source>%1, %2 from the robot&apos;s TCP</source>
        <translation>%1，与机器人的相差 %2</translation>
    </message>
    <message>
        <source>The robot&apos;s TCP differs from “%1”</source>
        <translation>机器人的 TCP 与“%1”不同</translation>
    </message>
    <message>
        <source>On the robot: %1. In the project: %2. Difference: %3. Nothing was changed.</source>
        <translation>机器人：%1。项目：%2。相差 %3。没有任何更改。</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>将“%1”设到机器人</translation>
    </message>
    <message>
        <source>Set TCP on robot</source>
        <translation>在机器人上设置 TCP</translation>
    </message>
    <message>
        <source>A TCP named “%1” already exists. Choose a different name.</source>
        <translation>“%1”已是另一个 TCP 的名称。请选择其他名称。</translation>
    </message>
</context>
<context>
    <name>tiller::TcpTeacher</name>
    <message>
        <source>Record pose</source>
        <translation>取位姿</translation>
    </message>
    <message>
        <source>Redo least accurate pose</source>
        <translation>重取最不准确的位姿</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>取</translation>
    </message>
    <message>
        <source>Keep TCP</source>
        <translation>保留 TCP</translation>
    </message>
    <message>
        <source>Teach the TCP</source>
        <translation>示教 TCP</translation>
    </message>
    <message>
        <source>Record pose for the tool orientation</source>
        <translation>取一个用于方向的位姿</translation>
    </message>
    <message>
        <source>Tool orientation</source>
        <translation>工具方向</translation>
    </message>
    <message>
        <source>Keep current orientation</source>
        <translation>保持当前方向</translation>
    </message>
    <message>
        <source>Orientation from one pose: tool straight down</source>
        <translation>由一个位姿定方向：工具竖直向下</translation>
    </message>
    <message>
        <source>Orientation from three poses: along +Z, towards +X</source>
        <translation>由三个位姿定方向：沿 +Z，朝 +X</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Tip at %1. The poses agree within %2 (RMS); pose %3 deviates most, by %4.</source>
        <translation>尖端位于 %1。各位姿一致到 %2 (rms)；位姿 %3 最不吻合，相差 %4。</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the poses again.</source>
        <translation>机器人没有发送有效位置。请重新取位姿。</translation>
    </message>
    <message>
        <source>The tool keeps the current orientation.</source>
        <translation>工具保持当前方向。</translation>
    </message>
    <message>
        <source>Rotate the tool until it points straight down and its X axis is parallel to the base X axis, then record the pose.</source>
        <translation>转动工具，使其竖直向下且 X 轴与基座 X 轴平行，然后取位姿。</translation>
    </message>
    <message>
        <source>Orientation recorded. Record another pose to replace the orientation.</source>
        <translation>已取方向。再取一次即可替换。</translation>
    </message>
    <message>
        <source>Record the pose at the current position. After that, do not rotate the tool: jog along X, Y and Z only.</source>
        <translation>在当前位置取位姿。此后不要转动工具：只点动 X、Y 和 Z。</translation>
    </message>
    <message>
        <source>Move the tool along its +Z direction, away from the flange, by at least %1, and record the pose.</source>
        <translation>沿工具的 +Z 方向远离法兰移动至少 %1，然后取位姿。</translation>
    </message>
    <message>
        <source>Now move the tool along its +X direction by at least %1, and record the pose.</source>
        <translation>现在沿工具的 +X 方向移动至少 %1，然后取位姿。</translation>
    </message>
    <message>
        <source>Orientation recorded: %1 along +Z, %2 along +X; maximum flange rotation %3 at pose %4.</source>
        <translation>已取方向：沿 +Z %1，沿 +X %2；法兰最大转动 %3（位姿 %4）。</translation>
    </message>
    <message>
        <source>The flange rotated by up to %1 (pose %2). Record the three poses again without rotating the tool.</source>
        <translation>法兰最多转动了 %1（位姿 %2）。请在不转动工具的情况下重取三个位姿。</translation>
    </message>
    <message>
        <source>The distance along +Z is only %1. Record the three poses again, at least %2 apart.</source>
        <translation>沿 +Z 的距离仅 %1。请以至少 %2 的间距重取三个位姿。</translation>
    </message>
    <message>
        <source>The distance along +X is only %1. Record the three poses again, at least %2 apart.</source>
        <translation>沿 +X 的距离仅 %1。请以至少 %2 的间距重取三个位姿。</translation>
    </message>
    <message>
        <source>The three poses are collinear: the third pose is only %1 from the line. Record the three poses again.</source>
        <translation>三个位姿共线：第三个距该直线仅 %1。请重取三个位姿。</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the three poses again.</source>
        <translation>机器人没有发送有效位置。请重取三个。</translation>
    </message>
    <message>
        <source>Redo last pose</source>
        <translation>重取最后一个位姿</translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation>取位姿 %1</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>位姿 %1</translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation>  ◀ 最不准确</translation>
    </message>
    <message>
        <source>Poses can be recorded only while the robot sends data. Connect to a robot, or wait for new data.</source>
        <translation>只有机器人发送数据时才能取位姿。请连接机器人，或等待新数据。</translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool tilted by at least 30° in a different direction.</source>
        <translation>工具方向过于相近。请向另一方向倾斜 30° 以上再取一个位姿。</translation>
    </message>
    <message>
        <source>Jog the tip to a fixed, sharp point and record the pose. Record four poses in total, each with the tip on the same point and the tool tilted in a different direction.</source>
        <translation>把尖端点动到一个固定的尖点并取位姿。共四次：尖端在同一点，工具每次向不同侧倾斜。</translation>
    </message>
    <message numerus="yes">
        <source>Tilt the tool in a different direction, move the tip to the same point again, and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>把工具倾向另一侧，使尖端再到同一点，并取位姿。还需：%n。</numerusform>
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
        <translation>有效负载</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>TCP, payload, positions or cell</source>
        <translation>TCP、有效负载、位置或单元</translation>
    </message>
</context>
<context>
    <name>tiller::TravelWatch</name>
    <message>
        <source>%1: %2 left until %3 is %4 from %5</source>
        <translation>%1：再移动 %2 后，%3 距 %5 %4</translation>
    </message>
    <message>
        <source>%1: %2 left until the %3 joint limit</source>
        <translation>%1：距 %3 的极限剩余 %2</translation>
    </message>
    <message>
        <source>%1: %2 left until the reach limit or a singularity</source>
        <translation>%1：剩余 %2，随后是可达极限或奇异点</translation>
    </message>
</context>
<context>
    <name>tiller::VariableList</name>
    <message>
        <source>Program variables</source>
        <translation>程序的变量</translation>
    </message>
    <message>
        <source>The variable list changed during editing, so the value was not applied. Enter the value again.</source>
        <translation>编辑期间变量列表发生变化，因此值未应用。请重新输入。</translation>
    </message>
</context>
<context>
    <name>tiller::VariableModel</name>
    <message>
        <source>%1 (changing…)</source>
        <translation>%1（正在更改…）</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
</context>
<context>
    <name>tiller::VectorEditor</name>
    <message>
        <source>%1. Press Return to apply the value. The robot does not move.</source>
        <translation>%1。按回车应用。机器人不移动。</translation>
    </message>
</context>
<context>
    <name>tiller::ViewCard</name>
    <message>
        <source>Collapse</source>
        <translation>折叠</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>The view is too small to expand this card</source>
        <translation>视图太小，无法展开此卡片</translation>
    </message>
    <message>
        <source>Expand</source>
        <translation>展开</translation>
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
        <translation>路点坐标系中的值。按回车应用。只有路点改变；机器人不移动。</translation>
    </message>
    <message>
        <source>Selected waypoint</source>
        <translation>所选路点</translation>
    </message>
    <message>
        <source>Waypoint frame</source>
        <translation>路点的坐标系</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>坐标系</translation>
    </message>
    <message numerus="yes">
        <source>used in %n steps</source>
        <translation>
            <numerusform>用于 %n 个步骤</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the current pose</source>
        <translation>距当前位姿 %1</translation>
    </message>
    <message>
        <source>joints have priority</source>
        <translation>关节优先</translation>
    </message>
    <message>
        <source>pose has priority</source>
        <translation>位姿优先</translation>
    </message>
    <message>
        <source>cell of “%1”</source>
        <translation>“%1”的格位</translation>
    </message>
    <message>
        <source>corner of “%1”</source>
        <translation>“%1”的角</translation>
    </message>
    <message>
        <source>home position “%1”</source>
        <translation>原位，“%1”</translation>
    </message>
    <message>
        <source>position “%1”</source>
        <translation>位置“%1”</translation>
    </message>
    <message>
        <source>Run route</source>
        <translation>运行路线</translation>
    </message>
    <message>
        <source>Shows the route controls instead of the values.</source>
        <translation>显示路线的控件而不是数值。</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Shows the values instead of the route controls.</source>
        <translation>显示数值而不是路线的控件。</translation>
    </message>
    <message>
        <source>TCP “%1”</source>
        <translation>TCP“%1”</translation>
    </message>
    <message>
        <source>TCP at the flange</source>
        <translation>TCP 在法兰</translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation>TCP 距法兰 %1</translation>
    </message>
    <message>
        <source>Reference frame of the waypoint. Changing the frame does not move the waypoint. “—” means no frame: the joint positions have priority.</source>
        <translation>路点的参考坐标系。空间位置不变。“—”：无坐标系，以关节位置为准</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointDialogs</name>
    <message>
        <source>Select waypoints to change.</source>
        <translation>选择要更改的路点。</translation>
    </message>
    <message numerus="yes">
        <source>Change the properties of %n waypoints</source>
        <translation>
            <numerusform>更改 %n 个路点的属性</numerusform>
        </translation>
    </message>
    <message>
        <source>Select waypoints to move.</source>
        <translation>选择要移动的路点。</translation>
    </message>
    <message>
        <source>Change the pattern “%1”</source>
        <translation>更改阵列“%1”</translation>
    </message>
    <message>
        <source>Create the pattern “%1”</source>
        <translation>创建阵列“%1”</translation>
    </message>
    <message>
        <source>Convert the pattern “%1” to waypoints</source>
        <translation>将阵列“%1”转换为路点</translation>
    </message>
    <message>
        <source>Select a waypoint that belongs to a pattern.</source>
        <translation>选择阵列的一个格位。</translation>
    </message>
    <message>
        <source>Delete the pattern “%1”</source>
        <translation>删除阵列“%1”</translation>
    </message>
    <message>
        <source>Select a waypoint to see its history.</source>
        <translation>选择路点以查看其历史。</translation>
    </message>
    <message>
        <source>Restore an earlier version of “%1”</source>
        <translation>恢复“%1”的早期版本</translation>
    </message>
    <message>
        <source>Import waypoints</source>
        <translation>导入路点</translation>
    </message>
    <message>
        <source>Waypoint files (*.csv *.txt *.json *.tiller);;All files (*)</source>
        <translation>路点 (*.csv *.txt *.json *.tiller);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Export waypoints</source>
        <translation>导出路点</translation>
    </message>
    <message>
        <source>CSV file (*.csv);;JSON file (*.json)</source>
        <translation>CSV 文件 (*.csv);;JSON 文件 (*.json)</translation>
    </message>
    <message>
        <source>Import failed</source>
        <translation>没有导入任何内容</translation>
    </message>
    <message>
        <source>%1 is too large. The maximum size of a waypoint file is 64 MB.</source>
        <translation>%1 过大。路点文件的上限为 64 MB。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>路点</translation>
    </message>
    <message numerus="yes">
        <source>Import %n waypoints</source>
        <translation>
            <numerusform>导入 %n 个路点</numerusform>
        </translation>
    </message>
    <message>
        <source>The project contains no waypoints to export. Teach a waypoint first.</source>
        <translation>项目中没有可导出的路点。请先示教路点。</translation>
    </message>
    <message>
        <source>Export failed</source>
        <translation>没有导出任何内容</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints exported to %1</source>
        <translation>
            <numerusform>%n 个路点已写入 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the waypoints to add actions to.</source>
        <translation>请选择需要执行动作的路点。</translation>
    </message>
    <message numerus="yes">
        <source>Change the actions at %n waypoints</source>
        <translation>
            <numerusform>更改 %n 个路点处的动作</numerusform>
        </translation>
    </message>
    <message>
        <source>Teach three waypoints at the corners of the pattern first.</source>
        <translation>请先在阵列的角上示教三个路点。</translation>
    </message>
    <message>
        <source>The earlier version cannot be restored because its frame was deleted from the project. Select a different version.</source>
        <translation>无法恢复早期版本，因为其坐标系已从项目中删除。请选择其他版本。</translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>偏移、旋转或镜像 %n 个路点</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 contains no waypoints. Choose a different file.</source>
        <translation>%1 中没有路点。请选择其他文件。</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointEditing</name>
    <message>
        <source>Duplicate “%1”</source>
        <translation>复制“%1”</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n waypoints</source>
        <translation>
            <numerusform>复制 %n 个路点</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste failed</source>
        <translation>没有粘贴任何内容</translation>
    </message>
    <message>
        <source>The clipboard contains no waypoints. Copy waypoints first.</source>
        <translation>剪贴板上没有路点。请先复制路点。</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>路点</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n waypoints</source>
        <translation>
            <numerusform>粘贴 %n 个路点</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::WaypointHistoryDialog</name>
    <message>
        <source>History of “%1”</source>
        <translation>“%1”的历史</translation>
    </message>
    <message>
        <source>Changes, newest first</source>
        <translation>更改，最新在前</translation>
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
        <translation>恢复此更改之前的版本</translation>
    </message>
    <message>
        <source>Name: “%1” → “%2”</source>
        <translation>名称：“%1” → “%2”</translation>
    </message>
    <message>
        <source>Position: moved by %1 (%2, base frame)</source>
        <translation>位置：移动了 %1（%2，基座坐标系）</translation>
    </message>
    <message>
        <source>Joints: largest change %2 (%1)</source>
        <translation>关节：%1 转动最多，%2</translation>
    </message>
    <message>
        <source>none (joints have priority)</source>
        <translation>无（关节优先）</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>a deleted frame</source>
        <translation>已不存在的坐标系</translation>
    </message>
    <message>
        <source>Frame: %1 → %2</source>
        <translation>坐标系：%1 → %2</translation>
    </message>
    <message>
        <source>Move: MoveL → MoveJ</source>
        <translation>动作：MoveL → MoveJ</translation>
    </message>
    <message>
        <source>Move: MoveJ → MoveL</source>
        <translation>动作：MoveJ → MoveL</translation>
    </message>
    <message>
        <source>MoveJ speed: %1 → %2</source>
        <translation>MoveJ 速度：%1 → %2</translation>
    </message>
    <message>
        <source>MoveL speed: %1 → %2</source>
        <translation>MoveL 速度：%1 → %2</translation>
    </message>
    <message>
        <source>Blend: %1 → %2</source>
        <translation>交融：%1 → %2</translation>
    </message>
    <message>
        <source>TCP: taught with a different TCP</source>
        <translation>TCP：用另一个 TCP 示教</translation>
    </message>
    <message>
        <source>Group: “%1” → “%2”</source>
        <translation>组：“%1” → “%2”</translation>
    </message>
    <message>
        <source>Colour: %1 → %2</source>
        <translation>颜色：%1 → %2</translation>
    </message>
    <message>
        <source>Note: “%1” → “%2”</source>
        <translation>备注：“%1” → “%2”</translation>
    </message>
    <message>
        <source>Actions: changed</source>
        <translation>动作：与现在不同</translation>
    </message>
    <message>
        <source>No changes have been recorded for this waypoint.</source>
        <translation>此路点没有更改记录。</translation>
    </message>
    <message>
        <source>The version before this change is identical to the current version.</source>
        <translation>此更改之前的版本与当前版本相同。</translation>
    </message>
    <message>
        <source>Changes from the version before this change to the current version:</source>
        <translation>从此更改之前的版本到当前版本的变化：</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointModel</name>
    <message>
        <source>✕ joint</source>
        <translation>✕ 关节</translation>
    </message>
    <message>
        <source>✕ frame</source>
        <translation>✕ 坐标系</translation>
    </message>
    <message>
        <source>✕ line</source>
        <translation>✕ 直线</translation>
    </message>
    <message>
        <source>✕ reach</source>
        <translation>✕ 可达</translation>
    </message>
    <message>
        <source>Out of reach. Touch up the waypoint closer to the base.</source>
        <translation>不可达。请在靠近基座处修正示教。</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>MoveJ: all joints start and stop together</source>
        <translation>MoveJ：所有关节同时开始和停止</translation>
    </message>
    <message>
        <source>MoveL: the TCP moves along a straight line</source>
        <translation>MoveL：TCP 沿直线移动</translation>
    </message>
    <message>
        <source>Joints have priority: the arm returns to the same configuration</source>
        <translation>以关节为准：机械臂以相同姿态返回</translation>
    </message>
    <message>
        <source>The pose has priority: the waypoint moves with its frame</source>
        <translation>以位姿为准：随其坐标系移动</translation>
    </message>
    <message>
        <source>Within reach</source>
        <translation>可达</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>动作</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Blend %1</source>
        <translation>交融 %1</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>可达</translation>
    </message>
    <message>
        <source>Enter a name for the waypoint.</source>
        <translation>请输入路点的名称。</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>将“%1”重命名为“%2”</translation>
    </message>
    <message>
        <source>Change “%1” to MoveJ</source>
        <translation>将“%1”改为 MoveJ</translation>
    </message>
    <message>
        <source>Change “%1” to MoveL</source>
        <translation>将“%1”改为 MoveL</translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation>更改“%1”的位姿</translation>
    </message>
    <message>
        <source>Use joint positions for “%1”</source>
        <translation>对“%1”使用关节位置</translation>
    </message>
    <message>
        <source>Change the frame of “%1” to %2</source>
        <translation>将“%1”的坐标系改为 %2</translation>
    </message>
    <message>
        <source>Set the blend of “%1”</source>
        <translation>设定“%1”的交融</translation>
    </message>
    <message>
        <source>Set the speed of “%1”</source>
        <translation>设定“%1”的速度</translation>
    </message>
    <message>
        <source>Group: %1</source>
        <translation>组：%1</translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation>颜色：%1</translation>
    </message>
    <message>
        <source>Name %1, next waypoint</source>
        <translation>名称 %1，下一个</translation>
    </message>
    <message>
        <source>Actions: %1</source>
        <translation>在该处执行：%1</translation>
    </message>
    <message>
        <source>Name %1</source>
        <translation>名称 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n actions</source>
        <translation>
            <numerusform>%n 个动作</numerusform>
        </translation>
    </message>
    <message>
        <source>✕ model</source>
        <translation>✕ 型号</translation>
    </message>
    <message>
        <source>✕ path</source>
        <translation>✕ 路径</translation>
    </message>
    <message>
        <source>The arm cannot reach this pose, so “%1” was not changed. Enter a different pose.</source>
        <translation>机械臂无法到达此位姿。“%1”没有更改。请输入其他位姿。</translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation>“%1”不是数字。请输入数字。</translation>
    </message>
    <message>
        <source>%1 is out of range. Enter a value from %2 to %3.</source>
        <translation>%1 超出范围。请输入 %2 至 %3 之间的值。</translation>
    </message>
    <message>
        <source>A joint would exceed its limit. Touch up the waypoint with a different arm configuration.</source>
        <translation>某个关节会超出范围。请以另一种机械臂姿态修正示教该路点。</translation>
    </message>
    <message>
        <source>The frame of the waypoint is not in this project. Choose a different frame.</source>
        <translation>路点的坐标系不在此项目中。请选择另一个坐标系。</translation>
    </message>
    <message>
        <source>The straight line from the current position leaves the reach of the arm. Use MoveJ, or start from a different position.</source>
        <translation>从当前位置出发的直线超出机械臂的可达范围。请使用 MoveJ，或从其他位置开始。</translation>
    </message>
    <message>
        <source>Waypoint %2 is already named “%1”. Choose a different name.</source>
        <translation>“%1”已是路点 %2 的名称。请选择其他名称。</translation>
    </message>
    <message>
        <source>The project has no frame named “%1”. Choose a different frame.</source>
        <translation>此项目中没有坐标系“%1”。请选择其他坐标系。</translation>
    </message>
    <message>
        <source>The project was taught with a different robot model. Use “Adapt project to this robot…” first.</source>
        <translation>项目是用其他型号的机器人示教的。请先使用“使项目适应此机器人…”。</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointProperties</name>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>蓝</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>橙</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>粉</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>天蓝</translation>
    </message>
    <message>
        <source>Only the selected properties are changed.</source>
        <translation>只更改所选的属性。</translation>
    </message>
    <message>
        <source>Properties of “%1”</source>
        <translation>“%1”的属性</translation>
    </message>
    <message numerus="yes">
        <source>Properties of %n waypoints</source>
        <translation>
            <numerusform>%n 个路点的属性</numerusform>
        </translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>MoveJ speed</source>
        <translation>MoveJ 速度</translation>
    </message>
    <message>
        <source>MoveL speed</source>
        <translation>MoveL 速度</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>交融</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointSearch</name>
    <message>
        <source>Find waypoints</source>
        <translation>搜索路点</translation>
    </message>
    <message>
        <source>Find waypoints by name, group or note</source>
        <translation>按名称、组或备注搜索路点</translation>
    </message>
    <message>
        <source>Name, group or note</source>
        <translation>名称、组或备注</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Show all waypoints</source>
        <translation>显示所有路点</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>找到 %n 个</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::WaypointShift</name>
    <message>
        <source>Transformation type</source>
        <translation>变换类型</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Tool of each waypoint</source>
        <translation>工具，各自的</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Offset X, Y, Z</source>
        <translation>偏移 X、Y、Z</translation>
    </message>
    <message>
        <source>Offset %1</source>
        <translation>偏移 %1</translation>
    </message>
    <message>
        <source>Rotation axis or mirror normal</source>
        <translation>旋转轴或镜像法线</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>The arm cannot reach these waypoints after the move: %1. Choose a different offset, rotation or mirror plane. No waypoint will be moved.</source>
        <translation>移动后机械臂无法到达这些路点：%1。请选择其他偏移、旋转或镜像平面。不会移动任何路点。</translation>
    </message>
    <message numerus="yes">
        <source>%n of the moved waypoints will be out of reach. They will be kept and marked.</source>
        <translation>
            <numerusform>其中 %n 个将不可达；会保留并标记。</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirrors across the plane through the origin that is perpendicular to the axis. The tool approaches from the mirrored side.</source>
        <translation>以过原点并垂直于该轴的平面镜像。工具从镜像一侧接近。</translation>
    </message>
    <message>
        <source>All waypoints remain within reach.</source>
        <translation>全部仍可达。</translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>偏移、旋转或镜像 %n 个路点</numerusform>
        </translation>
    </message>
    <message>
        <source>The frame of a selected waypoint is not in the project. Choose a different frame for the waypoint first.</source>
        <translation>所选路点的坐标系不在此项目中。请先为该路点选择其他坐标系。</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointTable</name>
    <message>
        <source>Waypoints</source>
        <translation>路点</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointsTab</name>
    <message>
        <source>Waypoints</source>
        <translation>路点</translation>
    </message>
    <message>
        <source>Teach here  T</source>
        <translation>在此示教  T</translation>
    </message>
    <message>
        <source>Teach here</source>
        <translation>在此示教</translation>
    </message>
    <message>
        <source>Touch up  U</source>
        <translation>修正示教  U</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>修正示教</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>No waypoints yet.
Jog the arm to a position and press “Teach here” (T).</source>
        <translation>还没有路点。
把机械臂点动到某处，按“在此示教” (T)。</translation>
    </message>
    <message>
        <source>Select a waypoint to go to.</source>
        <translation>选择要前往的路点。</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller 未取得控制。请先获取控制。</translation>
    </message>
    <message>
        <source>Add the current position after the selection (T)</source>
        <translation>在所选项之后添加当前位置 (T)</translation>
    </message>
    <message>
        <source>Replace the selected waypoint with the current position (U)</source>
        <translation>用当前位置替换所选路点 (U)</translation>
    </message>
    <message>
        <source>Select a waypoint to touch up.</source>
        <translation>选择要修正示教的路点。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Copy as table</source>
        <translation>复制为表格</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>路点</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>示教“%1”</translation>
    </message>
    <message>
        <source>The current position is %1 away (%2, base frame). Largest joint change: %3 %4.</source>
        <translation>当前位置相距 %1（%2，基座坐标系）。最大关节变化：%3 %4。</translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>修正示教“%1”？</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>修正示教“%1”</translation>
    </message>
    <message>
        <source>Path recorded</source>
        <translation>路径已录制</translation>
    </message>
    <message>
        <source>Import waypoints…</source>
        <translation>导入路点…</translation>
    </message>
    <message>
        <source>Export waypoints…</source>
        <translation>导出路点…</translation>
    </message>
    <message>
        <source>Find waypoints</source>
        <translation>搜索路点</translation>
    </message>
    <message>
        <source>Group, colour, note, speeds…</source>
        <translation>组、颜色、备注、速度…</translation>
    </message>
    <message>
        <source>Offset, rotate or mirror…</source>
        <translation>偏移、旋转或镜像…</translation>
    </message>
    <message>
        <source>History…</source>
        <translation>历史…</translation>
    </message>
    <message>
        <source>Convert pattern to waypoints</source>
        <translation>将阵列转换为路点</translation>
    </message>
    <message>
        <source>Delete pattern and its waypoints</source>
        <translation>删除阵列及其路点</translation>
    </message>
    <message>
        <source>Actions…</source>
        <translation>动作…</translation>
    </message>
    <message>
        <source>Import and export</source>
        <translation>导入和导出</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>阵列</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Taught “%1”</source>
        <translation>已示教“%1”</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Create or edit pattern…</source>
        <translation>创建或编辑阵列…</translation>
    </message>
    <message>
        <source>The frame of “%1” is not in this project. Choose a different frame first.</source>
        <translation>“%1”的坐标系不在此项目中。请先选择另一个坐标系。</translation>
    </message>
</context>
<context>
    <name>tiller::app::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>搜索命令</translation>
    </message>
    <message>
        <source>Type a command or keyword</source>
        <translation>输入您想做的事</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>找到的命令</translation>
    </message>
    <message>
        <source>not available now</source>
        <translation>现在不可用</translation>
    </message>
</context>
<context>
    <name>tiller::app::ConnectDialog</name>
    <message>
        <source>Enter the robot&apos;s address, as shown on the teach pendant under About.</source>
        <translation>输入机器人的地址，如示教器“关于”中所示。</translation>
    </message>
    <message>
        <source>An IP address consists of four numbers from 0 to 255, e.g. 192.168.0.10.</source>
        <translation>IP 地址由四个 0 至 255 的数字组成，如 192.168.0.10。</translation>
    </message>
    <message>
        <source>A host name contains only letters, digits, dots and hyphens.</source>
        <translation>主机名只含字母、数字、点和连字符。</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>忘记</translation>
    </message>
    <message>
        <source>Start the simulated robot</source>
        <translation>启动模拟机器人</translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation>打开示例项目…</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Before you move a real arm: keep everyone out of its reach, keep the emergency stop within reach, check the payload and the TCP, and start slowly. STOP in this window is not an emergency stop.</source>
        <translation>移动真实机械臂之前：不要让任何人进入可达范围，紧急停止在手边，检查有效负载和 TCP，慢速开始。此窗口的 STOP 不是紧急停止。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>打开项目…</translation>
    </message>
    <message>
        <source>Opens a project without a robot, to view and edit waypoints and programs.</source>
        <translation>无需机器人即可打开项目，以查看和编辑路点和程序。</translation>
    </message>
    <message>
        <source>Try the simulator</source>
        <translation>试用模拟器</translation>
    </message>
    <message>
        <source>A simulated UR5e that runs in Tiller. All functions are available without risk.</source>
        <translation>在 Tiller 中运行的模拟 UR5e。所有功能均可无风险使用。</translation>
    </message>
    <message>
        <source>Starts the simulated robot and opens a project with taught waypoints.</source>
        <translation>启动模拟机器人，并打开一个已示教的项目。</translation>
    </message>
    <message>
        <source>Connect to a robot</source>
        <translation>连接机器人</translation>
    </message>
    <message>
        <source>Address or host name of the robot</source>
        <translation>机器人的地址或主机名</translation>
    </message>
    <message>
        <source>Display name of the robot</source>
        <translation>显示的机器人名称</translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation>实验室 UR5e</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Recently connected robots</source>
        <translation>最近连接过的机器人</translation>
    </message>
    <message>
        <source>Removes the selected robot from this list (Delete). The robot itself is not affected.</source>
        <translation>从此列表中移除所选机器人 (Delete)。机器人本身不受影响。</translation>
    </message>
</context>
<context>
    <name>tiller::app::Demonstration</name>
    <message>
        <source>Cannot create the folder %1. Choose a folder that you have permission to write to.</source>
        <translation>无法创建文件夹 %1。请选择可写入的文件夹。</translation>
    </message>
    <message>
        <source>connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>power on</source>
        <translation>上电</translation>
    </message>
    <message>
        <source>release the brakes</source>
        <translation>松开制动器</translation>
    </message>
    <message>
        <source>take control</source>
        <translation>获取控制</translation>
    </message>
    <message>
        <source>start recording</source>
        <translation>开始录制</translation>
    </message>
    <message>
        <source>teach the first waypoint</source>
        <translation>示教第一个路点</translation>
    </message>
    <message>
        <source>jog X+ in Base for 50 mm</source>
        <translation>在基座中点动 X+ 50 mm</translation>
    </message>
    <message>
        <source>teach the second waypoint</source>
        <translation>示教第二个路点</translation>
    </message>
    <message>
        <source>move to the first waypoint (button held)</source>
        <translation>前往第一个路点（按住）</translation>
    </message>
    <message>
        <source>digital output 0 on</source>
        <translation>数字输出 0 开</translation>
    </message>
    <message>
        <source>digital output 0 off</source>
        <translation>数字输出 0 关</translation>
    </message>
    <message>
        <source>take the screenshots</source>
        <translation>截图</translation>
    </message>
    <message>
        <source>Cannot write the screenshots to %1. Check the permissions of the folder and the free disk space.</source>
        <translation>无法将截图写入 %1。请检查文件夹权限和可用磁盘空间。</translation>
    </message>
    <message>
        <source>stop recording</source>
        <translation>停止录制</translation>
    </message>
    <message>
        <source>%1: not completed within %2 s (%3)</source>
        <translation>%1：未在 %2 s 内完成（%3）</translation>
    </message>
    <message>
        <source>the robot reported no reason</source>
        <translation>机器人没有报告原因</translation>
    </message>
    <message>
        <source>pressed again        %1 times: the motion had stopped before the button was released</source>
        <translation>重新按下             %1 次：松开按钮之前动作已停止</translation>
    </message>
    <message>
        <source>jogged               </source>
        <translation>点动               </translation>
    </message>
    <message>
        <source>release to standstill </source>
        <translation>从松开到静止 </translation>
    </message>
    <message>
        <source>packets              </source>
        <translation>数据包              </translation>
    </message>
    <message>
        <source> received, </source>
        <translation> 收到， </translation>
    </message>
    <message>
        <source> late, </source>
        <translation> 延迟， </translation>
    </message>
    <message>
        <source> lost
</source>
        <translation> 丢失
</translation>
    </message>
    <message>
        <source>recorded             </source>
        <translation>已录制             </translation>
    </message>
    <message>
        <source> rows, </source>
        <translation> 行， </translation>
    </message>
    <message>
        <source>files                </source>
        <translation>文件                </translation>
    </message>
    <message>
        <source>the window has no button “%1”</source>
        <translation>窗口中没有按钮“%1”</translation>
    </message>
    <message>
        <source>release the jog button</source>
        <translation>松开点动按钮</translation>
    </message>
    <message>
        <source>release the “Go to” button</source>
        <translation>松开“前往”按钮</translation>
    </message>
</context>
<context>
    <name>tiller::app::DeviceSettings</name>
    <message>
        <source>Jog device</source>
        <translation>点动设备</translation>
    </message>
    <message>
        <source>Test device…</source>
        <translation>测试设备…</translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation>显示各设备的当前数值，以及机械臂将移动的方向。</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>手柄</translation>
    </message>
    <message>
        <source>SpaceMouse</source>
        <translation>SpaceMouse</translation>
    </message>
    <message>
        <source>%1 dead zone</source>
        <translation>%1的死区</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Deflection below which the device does not move the arm.</source>
        <translation>偏转小于此值时设备不移动机械臂。</translation>
    </message>
    <message>
        <source>%1 curve</source>
        <translation>%1的曲线</translation>
    </message>
    <message>
        <source>exponent </source>
        <translation>指数 </translation>
    </message>
    <message>
        <source>1: linear. Higher values: finer near the centre, faster at full deflection.</source>
        <translation>1：线性。数值越大：中心附近越精细，满偏转时越快。</translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation>仅主轴</translation>
    </message>
    <message>
        <source>%1: dominant axis only</source>
        <translation>%1：仅偏转最大的轴</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>死区</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation>未找到手柄或 SpaceMouse。连接后会自动检测到。</translation>
    </message>
    <message>
        <source>The device moves the arm only while the hold-to-run button is held. The selection is not stored: after a restart, no device moves the arm.</source>
        <translation>仅在按住使能键时移动机械臂。不保存：重启后没有设备移动机械臂。</translation>
    </message>
</context>
<context>
    <name>tiller::app::DockStage</name>
    <message>
        <source>No panels are shown. Select a perspective at the lower right, or show a panel from the View menu.</source>
        <translation>没有显示面板。请在右下角选择视角布局，或用“视图”菜单显示面板。</translation>
    </message>
</context>
<context>
    <name>tiller::app::HelpPage</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>练习任务</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>手册(英文)</translation>
    </message>
    <message>
        <source>Jogging and keys</source>
        <translation>点动与按键</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>&lt;h2&gt;The manual is not installed on this PC&lt;/h2&gt;&lt;p&gt;The Debian package of Tiller contains the manual. To add the manual to your own build, install the package python3-sphinx:&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;Then build again. You can also read the pages as text in the folder packaging/manual of the source code. The page “Jogging and keys” of this window contains the jogging rules and all shortcuts.&lt;/p&gt;</source>
        <translation>&lt;h2&gt;本机上未安装手册&lt;/h2&gt;&lt;p&gt;手册包含在 Tiller 的 Debian 软件包中。要在自行编译时加入手册，请安装软件包 python3-sphinx：&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;然后重新编译。也可以在源代码的文件夹 packaging/manual 中以文本形式阅读。点动规则和所有按键在本窗口的另一页上。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;h2&gt;Moving the arm&lt;/h2&gt;&lt;p&gt;The arm moves while you hold a jog button, and stops when you release it. It also stops when&lt;/p&gt;&lt;ul&gt;&lt;li&gt;the pointer leaves the button, a different mouse button is pressed, or a second input device is used;&lt;/li&gt;&lt;li&gt;a modifier or an opposite key is pressed while a keyboard key is held;&lt;/li&gt;&lt;li&gt;the window loses focus, a dialog or menu opens, or the frame, speed, step or tab changes;&lt;/li&gt;&lt;li&gt;data from the robot are late, Tiller hangs, or the robot mode, the safety mode or Remote control changes;&lt;/li&gt;&lt;li&gt;the screen is locked, the PC goes to sleep, or the input device is unplugged or stops sending data;&lt;/li&gt;&lt;li&gt;the key-state check fails: on X11, Tiller checks every 10 ms with the display server that the button or key is still pressed. If the button or key is not pressed, or if the server does not respond for 100 ms, the motion ends. If the check is not available, the header and Settings show a note;&lt;/li&gt;&lt;li&gt;the maximum hold time is reached: %1 s for a jog (Settings), five minutes for Freedrive, the duration of the move plus 5 s for a move to a position. The last 3 s are counted down.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;After a stop, press the button or key again to move the arm. While Tiller is in control, &lt;b&gt;Space&lt;/b&gt; and &lt;b&gt;Esc&lt;/b&gt; stop the arm from every window, dialog and text field. When Tiller is not in control, they act on the focused element; click &lt;b&gt;STOP&lt;/b&gt; to stop a program from another client. This is a software stop, not an emergency stop: keep the emergency stop within reach.&lt;/p&gt;&lt;p&gt;Hold &lt;b&gt;Ctrl&lt;/b&gt; for one-tenth of the speed, or &lt;b&gt;Shift&lt;/b&gt; for three times the speed, up to the speed cap. On a keyboard without Latin letters, the letters below refer to key positions on a US keyboard.&lt;/p&gt;&lt;h2&gt;Commands&lt;/h2&gt;</source>
        <translation>&lt;h2&gt;移动机械臂&lt;/h2&gt;&lt;p&gt;按住点动按钮时机械臂移动，松开即停止。以下情况也会停止：&lt;/p&gt;&lt;ul&gt;&lt;li&gt;指针离开按钮、按下鼠标的另一个键，或使用了另一个输入设备；&lt;/li&gt;&lt;li&gt;按住键盘按键时，按下了修饰键或相反方向的按键；&lt;/li&gt;&lt;li&gt;窗口失去焦点、打开了对话框或菜单，或坐标系、速度、步长或选项卡发生变化；&lt;/li&gt;&lt;li&gt;机器人的数据延迟、本程序没有响应，或机器人离开“运行”、其安全模式或远程控制；&lt;/li&gt;&lt;li&gt;屏幕被锁定、PC 进入休眠，或输入设备被拔出或停止发送数据；&lt;/li&gt;&lt;li&gt;按键状态检查失败：在 X11 上，Tiller 每 10 ms 向显示服务器检查按钮或按键是否仍被按下。如果没有按下，或服务器 100 ms 没有响应，运动即结束。如果无法进行此检查，页眉和设置会显示；&lt;/li&gt;&lt;li&gt;达到最长按住时间：点动为 %1 s（设置），自由驱动为五分钟，移动到某位置为运动时间加 5 s。最后 3 s 会倒计时。&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;停止后需要重新按下。Tiller 拥有控制时，&lt;b&gt;Space&lt;/b&gt; 和 &lt;b&gt;Esc&lt;/b&gt; 在任何窗口、对话框和文本框中都会停止机械臂。Tiller 没有控制时，它们作用于当前焦点控件；请单击 &lt;b&gt;STOP&lt;/b&gt; 停止其他客户端的程序。这是软件停止，不是紧急停止：请使紧急停止在伸手可及之处。&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; 使运动精细十倍，&lt;b&gt;Shift&lt;/b&gt; 使运动快三倍，但绝不超过上限。在没有拉丁字母的键盘上，下面的字母指其在美式键盘上的位置。&lt;/p&gt;&lt;h2&gt;命令&lt;/h2&gt;</translation>
    </message>
</context>
<context>
    <name>tiller::app::ImportDialog</name>
    <message>
        <source>Colours, sizes and units</source>
        <translation>颜色、大小和单位</translation>
    </message>
    <message>
        <source>Speed cap and maximum hold time</source>
        <translation>速度上限和最长按住时间</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation>手柄与 SpaceMouse</translation>
    </message>
    <message>
        <source>Robots and their grippers</source>
        <translation>机器人及其夹爪</translation>
    </message>
    <message>
        <source>I/O names and scales</source>
        <translation>输入输出的名称和比例</translation>
    </message>
    <message>
        <source>Window layout</source>
        <translation>窗口布局</translation>
    </message>
    <message>
        <source>Other settings</source>
        <translation>其他设置</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>导入设置</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed.</source>
        <translation>%1 未导入。没有任何更改。</translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1:</source>
        <translation>所选设置将由 %1 中的设置替换：</translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1 (written by Tiller %2):</source>
        <translation>所选设置将由 %1（由 Tiller %2 写入）中的设置替换：</translation>
    </message>
    <message>
        <source>%1: identical</source>
        <translation>%1：已相同</translation>
    </message>
    <message>
        <source>%1: not in the file</source>
        <translation>%1：文件中没有</translation>
    </message>
    <message>
        <source>%1: %2 in Tiller, %3 in the file</source>
        <translation>%1：Tiller 中 %2，文件中 %3</translation>
    </message>
    <message>
        <source>The replaced settings are saved to a separate file, which can be imported again.</source>
        <translation>被替换的设置会保存到单独的文件，可以再次导入。</translation>
    </message>
    <message>
        <source>All settings in the file match the current settings.</source>
        <translation>文件中的所有设置与当前设置相同。</translation>
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
        <translation>键盘点动已停用</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>路点</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>I/O</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>%1 disconnected. The arm was stopped.</source>
        <translation>%1 已断开。机械臂已停止。</translation>
    </message>
    <message>
        <source>%1 stopped sending data while it was moving the arm. The arm was stopped. Release the device; if the problem persists, reconnect it.</source>
        <translation>%1 在移动机械臂时停止发送数据。机械臂已停止。请松开设备；若问题仍存在，请重新连接。</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Open recent project</source>
        <translation>打开最近的项目</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>打开项目…</translation>
    </message>
    <message>
        <source>Opens a project file.</source>
        <translation>打开项目文件。</translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation>打开示例项目…</translation>
    </message>
    <message>
        <source>Opens a copy of a sample project to try on the simulated robot.</source>
        <translation>打开一个示例项目的副本，在模拟机器人上试用。</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>项目另存为…</translation>
    </message>
    <message>
        <source>Saves the project to a different file, and saves all further changes to that file automatically.</source>
        <translation>立即保存到此文件，并自动保存以后的所有更改。</translation>
    </message>
    <message>
        <source>Show waypoints</source>
        <translation>显示路点</translation>
    </message>
    <message>
        <source>Show frames</source>
        <translation>显示坐标系</translation>
    </message>
    <message>
        <source>Show I/O</source>
        <translation>显示 I/O</translation>
    </message>
    <message>
        <source>Show log</source>
        <translation>显示日志</translation>
    </message>
    <message>
        <source>Shows this tab.</source>
        <translation>显示此选项卡。</translation>
    </message>
    <message>
        <source>Show gripper</source>
        <translation>显示夹爪</translation>
    </message>
    <message>
        <source>Shows the Gripper page of the I/O tab.</source>
        <translation>显示 I/O 选项卡的夹爪页。</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>重置布局</translation>
    </message>
    <message>
        <source>Restores the panel layout of the current perspective.</source>
        <translation>恢复当前视角布局的面板排列。</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Changes the colour theme. The setting is stored.</source>
        <translation>更改颜色主题。该设置会保存。</translation>
    </message>
    <message>
        <source>Zero the force in the plots, or show the measured force</source>
        <translation>曲线图中的力归零，或按测量值显示</translation>
    </message>
    <message>
        <source>Subtracts the current TCP force in the plots. Press again to show the measured force.</source>
        <translation>在曲线图中减去当前的 TCP 力。再次按下显示测量值。</translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation>命令…</translation>
    </message>
    <message>
        <source>Finds a command by name.</source>
        <translation>按名称查找命令。</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>设置…</translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation>导出设置…</translation>
    </message>
    <message>
        <source>Saves all settings to one file, for another computer or as a backup.</source>
        <translation>将所有设置保存到一个文件，用于另一台计算机或作为备份。</translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation>导入设置…</translation>
    </message>
    <message>
        <source>Shows which settings a file will replace, then imports them.</source>
        <translation>显示将被替换的内容后，从文件导入设置。</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Stops the arm, ends the connection and closes the window.</source>
        <translation>停止机械臂，结束连接并关闭窗口。</translation>
    </message>
    <message>
        <source>Load program</source>
        <translation>加载程序</translation>
    </message>
    <message>
        <source>Name of the program on the robot, as shown on the teach pendant</source>
        <translation>机器人上程序的名称，如示教器所示</translation>
    </message>
    <message>
        <source>Name of the program on the robot, e.g. pick.urp</source>
        <translation>机器人上程序的名称，例如 pick.urp</translation>
    </message>
    <message>
        <source>Speed cap set to %1</source>
        <translation>速度上限已设为 %1</translation>
    </message>
    <message>
        <source>A recording is running. Stop the recording first.</source>
        <translation>正在录制。请先停止。</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message numerus="yes">
        <source>The cell has more boxes or planes than the simulated robot supports: %n are ignored.</source>
        <translation>
            <numerusform>单元中有 %n 个长方体或平面超出模拟机器人的上限，将被忽略。</numerusform>
        </translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>报告问题…</translation>
    </message>
    <message>
        <source>Shows versions, log and settings, then saves them to one file for support.</source>
        <translation>显示内容后，将版本、日志和设置保存到一个文件，供技术支持使用。</translation>
    </message>
    <message>
        <source>Report saved: %1</source>
        <translation>报告已保存：%1</translation>
    </message>
    <message>
        <source>Tiller closed unexpectedly</source>
        <translation>Tiller 意外退出</translation>
    </message>
    <message>
        <source>Tiller saved a crash log. You can attach it to a problem report.</source>
        <translation>Tiller 保存了崩溃日志。您可以将其附在问题报告中。</translation>
    </message>
    <message>
        <source>Opens the manual page for the focused control, the list of commands and shortcuts, and the jogging rules.</source>
        <translation>打开焦点所在部分的手册页面、命令和快捷键列表，以及点动规则。</translation>
    </message>
    <message>
        <source>The settings could not be saved. %1</source>
        <translation>无法保存设置。%1</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>已撤销：%1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>已重做：%1</translation>
    </message>
    <message>
        <source>Adapt project to this robot…</source>
        <translation>使项目适应此机器人…</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>获取控制</translation>
    </message>
    <message>
        <source>A program is paused on the robot.</source>
        <translation>机器人上有一个程序已暂停。</translation>
    </message>
    <message>
        <source>A program is running on the robot.</source>
        <translation>机器人上有一个程序正在运行。</translation>
    </message>
    <message>
        <source>The program “%1” is paused on the robot.</source>
        <translation>程序“%1”已在机器人上暂停。</translation>
    </message>
    <message>
        <source>The program “%1” is running on the robot.</source>
        <translation>程序“%1”正在机器人上运行。</translation>
    </message>
    <message>
        <source>Taking control stops the program. The program cannot be resumed, only restarted.</source>
        <translation>获取控制会停止程序。程序无法继续，只能重新启动。</translation>
    </message>
    <message>
        <source>Stop program and take control</source>
        <translation>停止程序并获取控制</translation>
    </message>
    <message>
        <source>Keep program</source>
        <translation>保留程序</translation>
    </message>
    <message>
        <source>Waypoints, Program, Frames, Tools, I/O, Log</source>
        <translation>路点、程序、坐标系、工具、I/O、日志</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Powering off stops the program. The program cannot be resumed, only restarted.</source>
        <translation>关闭电源会停止程序。程序无法继续，只能重新启动。</translation>
    </message>
    <message>
        <source>Stop program and power off</source>
        <translation>停止程序并关闭电源</translation>
    </message>
    <message>
        <source>A path is being recorded. Stop the path recording first.</source>
        <translation>正在录制路径。请先停止录制。</translation>
    </message>
    <message>
        <source>Close window</source>
        <translation>关闭窗口</translation>
    </message>
    <message>
        <source>A recording is running.</source>
        <translation>正在记录。</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>新建项目…</translation>
    </message>
    <message>
        <source>Starts an empty project in a new file.</source>
        <translation>在新文件中开始一个空项目。</translation>
    </message>
    <message>
        <source>The change takes effect immediately and may disturb the program.</source>
        <translation>更改立即生效，可能会干扰程序。</translation>
    </message>
    <message>
        <source>Change anyway</source>
        <translation>仍然更改</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Change while a program is active</source>
        <translation>程序处于活动状态时的更改</translation>
    </message>
    <message>
        <source>Change connection</source>
        <translation>更改连接</translation>
    </message>
    <message>
        <source>Do not ask again during this program</source>
        <translation>此程序运行期间不再询问</translation>
    </message>
    <message>
        <source>A program is loaded on the robot.</source>
        <translation>机器人上已加载一个程序。</translation>
    </message>
    <message>
        <source>The program “%1” is loaded on the robot.</source>
        <translation>机器人上已加载程序“%1”。</translation>
    </message>
    <message>
        <source>Pausing stops the arm until the program is resumed.</source>
        <translation>在程序继续之前，机械臂会停止。</translation>
    </message>
    <message>
        <source>The program cannot be resumed, only restarted.</source>
        <translation>程序无法继续，只能重新启动。</translation>
    </message>
    <message>
        <source>The arm may move immediately. Make sure that no one is within reach of the arm.</source>
        <translation>机械臂可能立即移动。请确认机械臂活动范围内没有人。</translation>
    </message>
    <message>
        <source>Resume program</source>
        <translation>继续程序</translation>
    </message>
    <message>
        <source>Start program</source>
        <translation>启动程序</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>停止并关闭</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>保持运行</translation>
    </message>
    <message>
        <source>Stop and continue</source>
        <translation>停止并继续</translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation>程序正在运行。请先停止程序。</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>保存项目</translation>
    </message>
    <message>
        <source>Keyboard jogging was disarmed, because an input field has the focus: the keys now edit the field. Arm the keyboard again to jog.</source>
        <translation>输入框获得焦点，因此已停用键盘点动：按键现在编辑该输入框。要点动，请重新启用键盘。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>robot, address</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1 — Tiller</source>
        <translation>%1 — Tiller</translation>
    </message>
    <message>
        <source>Keyboard jogging armed: arrow keys move along X and Y, PgUp and PgDn along Z; with Alt, they rotate the tool. Hold 1 to 6 and press + or − to move a joint. Space and Esc stop the arm.</source>
        <translation>键盘点动已启用：方向键沿 X 和 Y 移动，PgUp 和 PgDn 沿 Z 移动；加 Alt 旋转工具。按住 1 至 6 并按 + 或 − 移动关节。Space 和 Esc 停止机械臂。</translation>
    </message>
    <message>
        <source>Changes the theme, sizes, units, speed cap, devices and keyboard shortcuts.</source>
        <translation>配色、大小、单位、速度上限、设备和快捷键。</translation>
    </message>
    <message>
        <source>This activity stops when you close the window.</source>
        <translation>关闭窗口会将其停止。</translation>
    </message>
    <message>
        <source>This activity stops when you change the connection.</source>
        <translation>更改连接会将其停止。</translation>
    </message>
    <message>
        <source>Saves the project now. Tiller also saves all changes automatically. If another window or program has changed the file, Tiller asks whether to reload the file or keep both versions.</source>
        <translation>立即保存项目。Tiller 也会自动保存所有更改。如果其他窗口或程序更改了文件，将询问是重新加载还是保留两者。</translation>
    </message>
    <message>
        <source>Converts a project for a different robot model, keeping either the poses or the joint positions.</source>
        <translation>转换用于其他型号机器人的项目：保持位姿或关节。</translation>
    </message>
    <message>
        <source>A program is running. Stop the program before you open a different project.</source>
        <translation>程序正在运行。打开其他项目前请先停止程序。</translation>
    </message>
</context>
<context>
    <name>tiller::app::PanelDock</name>
    <message>
        <source>Dock</source>
        <translation>停靠</translation>
    </message>
    <message>
        <source>Moves this panel back to the main window.</source>
        <translation>将此面板移回主窗口。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Closes this panel. Use the View menu to show it again.</source>
        <translation>关闭此面板。可用“视图”菜单再次显示。</translation>
    </message>
    <message>
        <source>Move, float or close %1</source>
        <translation>移动、浮动或关闭 %1</translation>
    </message>
    <message>
        <source>Click to move, float or close this panel. Drag to move it.</source>
        <translation>点击：移动、浮动或关闭此面板。拖动：移到别处。</translation>
    </message>
</context>
<context>
    <name>tiller::app::PerspectiveActions</name>
    <message>
        <source>Save perspective</source>
        <translation>保存视角布局</translation>
    </message>
    <message>
        <source>Saves the current panel layout to the current perspective.</source>
        <translation>将当前面板排列保存到当前视角布局。</translation>
    </message>
    <message>
        <source>Save perspective as…</source>
        <translation>视角布局另存为…</translation>
    </message>
    <message>
        <source>Saves the current panel layout under a new name.</source>
        <translation>以新名称保存当前面板排列。</translation>
    </message>
    <message>
        <source>Save perspective as</source>
        <translation>视角布局另存为</translation>
    </message>
    <message>
        <source>Rename perspective…</source>
        <translation>重命名视角布局…</translation>
    </message>
    <message>
        <source>Renames the current perspective.</source>
        <translation>重命名当前视角布局。</translation>
    </message>
    <message>
        <source>Rename perspective</source>
        <translation>重命名视角布局</translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be renamed.</source>
        <translation>此视角布局是内置的，无法重命名。</translation>
    </message>
    <message>
        <source>Delete perspective…</source>
        <translation>删除视角布局…</translation>
    </message>
    <message>
        <source>Deletes the current perspective. The panel layout does not change.</source>
        <translation>删除当前视角布局。面板排列不变。</translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be deleted.</source>
        <translation>此视角布局是内置的，无法删除。</translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation>视角布局 %1</translation>
    </message>
    <message>
        <source>Perspective %1. Select a panel layout, or save the current layout.</source>
        <translation>视角布局 %1。选择面板排列，或保存当前排列。</translation>
    </message>
    <message>
        <source>Perspective name</source>
        <translation>视角布局的名称</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Delete perspective</source>
        <translation>删除视角布局</translation>
    </message>
    <message>
        <source>Delete the perspective “%1”? This cannot be undone.</source>
        <translation>删除视角布局“%1”？此操作无法撤销。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>This perspective is built in. Save it under a different name.</source>
        <translation>此视角布局是内置的。请以其他名称保存。</translation>
    </message>
</context>
<context>
    <name>tiller::app::Perspectives</name>
    <message>
        <source>Teach</source>
        <translation>示教</translation>
    </message>
    <message>
        <source>Shows the view, the waypoints next to it and the plots below.</source>
        <translation>显示视图，旁边是路点，下方是曲线图。</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>监视</translation>
    </message>
    <message>
        <source>Shows inputs and outputs, a smaller view next to them and taller plots below.</source>
        <translation>显示输入和输出，旁边是较小的视图，下方是较高的曲线图。</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Shows only the plots, as large as possible.</source>
        <translation>只显示曲线图，并尽可能大。</translation>
    </message>
    <message>
        <source>Shows the panels as you saved them.</source>
        <translation>按您保存的排列显示面板。</translation>
    </message>
    <message>
        <source>The perspective “%1” cannot be shown because the stored layout is damaged. Arrange the panels and save the perspective again.</source>
        <translation>无法显示视角布局“%1”：其在设置中的布局已损坏。请排列面板并重新保存。</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>请输入名称。</translation>
    </message>
    <message>
        <source>The maximum number of perspectives has been reached. Delete a perspective first.</source>
        <translation>视角布局已达上限。请先删除一个。</translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the layout of the earlier version is not compatible. Arrange the panels again. The new layout is saved automatically.</source>
        <translation>面板按视角布局“%1”排列：早期版本的布局不适用于此版本。请重新排列；新的排列会自动保存。</translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the stored layout is damaged or from another version. Arrange the panels again. The new layout is saved automatically.</source>
        <translation>面板按视角布局“%1”排列：设置中的布局已损坏或属于另一版本。请重新排列；新的排列会自动保存。</translation>
    </message>
    <message>
        <source>The name is too long. Enter a shorter name.</source>
        <translation>名称太长。请输入较短的名称。</translation>
    </message>
    <message>
        <source>A perspective with this name already exists. Choose a different name.</source>
        <translation>已有此名称的视角布局。请选择其他名称。</translation>
    </message>
</context>
<context>
    <name>tiller::app::RecordingSettings</name>
    <message>
        <source>Folder for recordings</source>
        <translation>录制文件夹</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the folder for recordings</source>
        <translation>选择录制文件夹</translation>
    </message>
    <message>
        <source>File name pattern</source>
        <translation>文件名模式</translation>
    </message>
    <message>
        <source>{date}, {time}, {robot} and {number} are replaced when a recording starts.</source>
        <translation>{date}、{time}、{robot} 和 {number} 在录制开始时填入。</translation>
    </message>
    <message>
        <source>Packets/row</source>
        <translation>数据包/行</translation>
    </message>
    <message>
        <source>Search signals</source>
        <translation>搜索信号</translation>
    </message>
    <message>
        <source>Signals in a recording</source>
        <translation>录制中的信号</translation>
    </message>
    <message>
        <source>All signals</source>
        <translation>所有信号</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>File name</source>
        <translation>文件名</translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation>实验室 UR5e</translation>
    </message>
    <message>
        <source>Example: %1. {date}, {time}, {robot}, {number} are placeholders. Existing files are never overwritten.</source>
        <translation>例如 %1。{date}、{time}、{robot} 和 {number} 是占位符。已有的文件绝不会被覆盖。</translation>
    </message>
    <message numerus="yes">
        <source>%n packet(s) per row: %1 rows per second from a robot that sends 500 packets per second.</source>
        <translation>
            <numerusform>每行 %n 个数据包：对每秒发送 500 个数据包的机器人为每秒 %1 行。</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording format</source>
        <translation>录制的格式</translation>
    </message>
    <message>
        <source>Free disk space to keep, in megabytes</source>
        <translation>要保留的磁盘空间（MB）</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Recording stops, and the file is saved, before the free disk space falls below this value.</source>
        <translation>在磁盘剩余空间低于此值之前，录制会停止并完成文件。</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Keep free</source>
        <translation>保留空闲</translation>
    </message>
    <message>
        <source>Maximum duration of a file, in minutes</source>
        <translation>单个文件的最长时间（分钟）</translation>
    </message>
    <message>
        <source>Maximum size of a file, in megabytes</source>
        <translation>单个文件的最大大小（兆字节）</translation>
    </message>
    <message>
        <source>Recorded time before the trigger, in seconds</source>
        <translation>触发前的记录时间（秒）</translation>
    </message>
    <message>
        <source>Recorded time after the trigger, in seconds</source>
        <translation>触发后的记录时间（秒）</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>无限制</translation>
    </message>
    <message>
        <source>A longer recording continues in a new file without losing packets.</source>
        <translation>较长的记录会在新文件中继续，不会丢失数据包。</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分钟</translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation>记录的元数据</translation>
    </message>
    <message>
        <source>When to enter metadata</source>
        <translation>何时输入元数据</translation>
    </message>
    <message>
        <source>Use for each recording</source>
        <translation>用于每个记录</translation>
    </message>
    <message>
        <source>Ask before each recording</source>
        <translation>每次记录前询问</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>触发条件</translation>
    </message>
    <message>
        <source>None: recording starts at once</source>
        <translation>无：立即开始记录</translation>
    </message>
    <message>
        <source>Combine conditions with “and” and “or”, for example:
norm(actual_TCP_force_0, actual_TCP_force_1) &gt; 20 and robot_mode = 7
actual_digital_input_bits:3 = 1
runtime_state changes
program starts</source>
        <translation>用“and”和“or”组合条件，例如：
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
        <translation>新文件</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>元数据</translation>
    </message>
    <message>
        <source>Before trigger</source>
        <translation>触发前</translation>
    </message>
    <message>
        <source>after</source>
        <translation>触发后</translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation>元数据…</translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>元数据（%n 个字段）…</numerusform>
        </translation>
    </message>
    <message>
        <source>With a trigger, Tiller records only while the condition is true, in numbered files.</source>
        <translation>设置触发条件后，Tiller 仅在条件成立时记录到编号文件中。</translation>
    </message>
</context>
<context>
    <name>tiller::app::ReportDialog</name>
    <message>
        <source>Include names and addresses of robots, inputs, outputs and files</source>
        <translation>包含机器人、输入、输出和文件的名称与地址</translation>
    </message>
    <message>
        <source>Report a problem</source>
        <translation>报告问题</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>What did you do? What did you expect? What happened?</source>
        <translation>您做了什么？期望什么？发生了什么？</translation>
    </message>
    <message>
        <source>Report files</source>
        <translation>报告中的文件</translation>
    </message>
    <message>
        <source>File content</source>
        <translation>此文件的内容</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>保存报告…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>The report is one file with the information that support needs. The complete content is listed below. You choose where to save the file. Tiller does not send it.</source>
        <translation>一个包含技术支持所需信息的文件。完整内容列在下面。文件保存在您选择的位置；Tiller 不会发送它。</translation>
    </message>
    <message>
        <source>Tiller report %1.zip</source>
        <translation>Tiller 报告 %1.zip</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Zip archives (*.zip)</source>
        <translation>Zip 压缩包 (*.zip)</translation>
    </message>
</context>
<context>
    <name>tiller::app::SampleDialog</name>
    <message>
        <source>Open sample project</source>
        <translation>打开示例项目</translation>
    </message>
    <message>
        <source>Each project was taught with a UR5e and runs on the simulated robot. You work on a copy. To keep your changes, save the project to a new file.</source>
        <translation>每个项目都是为 UR5e 示教的，可在模拟机器人上运行。您使用的是副本：保存时请选择新文件。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open “%1”</source>
        <translation>打开“%1”</translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Appearance and motion</source>
        <translation>外观与动作</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation>导出设置…</translation>
    </message>
    <message>
        <source>Save all settings to one file, for another computer or as a backup</source>
        <translation>将所有设置保存到一个文件，用于另一台计算机或作为备份</translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation>导入设置…</translation>
    </message>
    <message>
        <source>Show which settings a file will replace, then import them</source>
        <translation>显示将被替换的内容后，从文件导入设置</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Control size</source>
        <translation>控件大小</translation>
    </message>
    <message>
        <source>Compact</source>
        <translation>紧凑</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>鼠标</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>触摸</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Interface size</source>
        <translation>界面大小</translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation>长度单位</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Orientation format</source>
        <translation>方向格式</translation>
    </message>
    <message>
        <source>Roll, pitch, yaw in degrees</source>
        <translation>横滚、俯仰、偏航（度）</translation>
    </message>
    <message>
        <source>Rotation vector in radians, as in scripts</source>
        <translation>旋转矢量（弧度），与脚本相同</translation>
    </message>
    <message>
        <source>Tiller speed cap</source>
        <translation>Tiller 的速度上限</translation>
    </message>
    <message>
        <source>Maximum hold time</source>
        <translation>最长按住时间</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>After this time, a jog stops and its button must be pressed again. Freedrive has a limit of five minutes. A move to a position has a limit of its duration plus 5 s.</source>
        <translation>超过此时间后点动停止，须重新按下按钮。自由驱动：五分钟。移动到某位置：所需时间加 5 s。</translation>
    </message>
    <message>
        <source>Touch: large enough for fingers. In windows less than %1 px high, joint buttons, tabs and title bars remain smaller.</source>
        <translation>触摸：大小适合手指。在高度低于 %1 px 的窗口中，关节按钮、选项卡和标题栏保持较小。</translation>
    </message>
    <message>
        <source>Units for displaying and entering lengths, TCP speeds and orientations. The units in plots and files do not change.</source>
        <translation>长度、TCP 速度和方向的显示与输入单位。曲线图和文件中的单位不变。</translation>
    </message>
    <message>
        <source>Speed cap</source>
        <translation>速度上限</translation>
    </message>
    <message>
        <source>Scales text, controls, plots and the view.</source>
        <translation>缩放文字、控件、曲线图和视图。</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted, limited to %1 % on this screen.</source>
        <translation>下次启动 Tiller 时生效，在此屏幕上最大为 %1 %。</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted.</source>
        <translation>从下次启动 Tiller 起生效。</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Restore default shortcuts</source>
        <translation>恢复默认快捷键</translation>
    </message>
    <message>
        <source>Shortcut for %1</source>
        <translation>%1 的按键</translation>
    </message>
    <message>
        <source>%1 is reserved for stopping the arm.</source>
        <translation>%1 保留用于停止机械臂。</translation>
    </message>
    <message>
        <source>%1 is assigned to “%2”. Remove that shortcut first.</source>
        <translation>%1 已分配给“%2”。请先移除该快捷键。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>System language: %1</source>
        <translation>跟随系统：%1</translation>
    </message>
    <message>
        <source>Reopen window</source>
        <translation>重新打开窗口</translation>
    </message>
    <message>
        <source>Stops the arm, gives control back and reconnects. The plots restart. The project is saved.</source>
        <translation>停止机械臂，交还控制并重新连接。曲线图重新开始。项目会保存。</translation>
    </message>
    <message>
        <source>Language of the window and of the connection check. Files and scripts are not affected.</source>
        <translation>窗口和连接检查的语言。不影响文件和脚本。</translation>
    </message>
    <message>
        <source>Monitor only</source>
        <translation>仅监视</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>For PCs that only monitor: this window does not take control, set outputs or start programs. STOP still works.</source>
        <translation>用于仅监视的电脑：此窗口不获取控制、不设置输出、不启动程序。STOP 仍然有效。</translation>
    </message>
    <message>
        <source>Monitor only (set on the command line)</source>
        <translation>仅监视（由命令行设置）</translation>
    </message>
    <message>
        <source>Press the new shortcut in the field, or Backspace to remove the shortcut. While Tiller is in control, Space and Esc always stop the arm.</source>
        <translation>在框中按下新的快捷键；退格键可删除。Tiller 拥有控制时，空格键和 Esc 始终停止机械臂。</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted or the window is reopened. The plots then restart.</source>
        <translation>重新启动 Tiller 或重新打开窗口后生效。届时曲线图会重新开始。</translation>
    </message>
    <message>
        <source>Maximum speed of the TCP and elbow for all motion commanded by Tiller. A change takes effect immediately and stops any motion.</source>
        <translation>Tiller 所有运动中 TCP 和肘部的最大速度。立即生效，并停止正在进行的运动。</translation>
    </message>
    <message>
        <source>▲ Above %1. Manual mode and the enabling device of the teach pendant do not limit jogging from a PC. The header shows a warning. The cap is reset when Tiller is closed.</source>
        <translation>▲ 高于 %1。手动模式和示教器的使能装置不限制从 PC 的点动。页眉会显示警告。关闭 Tiller 后上限复位。</translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsTransfer</name>
    <message>
        <source>Tiller settings (*.json)</source>
        <translation>Tiller 的设置 (*.json)</translation>
    </message>
    <message>
        <source>Export settings</source>
        <translation>导出设置</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>导入设置</translation>
    </message>
    <message>
        <source>Settings exported to %1</source>
        <translation>设置已导出到 %1</translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed. %2</source>
        <translation>%1 未导入。没有任何更改。%2</translation>
    </message>
    <message>
        <source>Settings imported from %1. The previous settings were saved to %2.</source>
        <translation>已从 %1 导入设置。先前的设置已保存到 %2。</translation>
    </message>
</context>
<context>
    <name>tiller::app::Tutorial</name>
    <message>
        <source>First steps</source>
        <translation>第一步</translation>
    </message>
    <message>
        <source>Shows a checklist in the view, from powering on to recording.</source>
        <translation>在视图中显示从上电到录制的清单。</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>练习任务</translation>
    </message>
    <message>
        <source>Five tasks on the simulated robot. Each task checks the result.</source>
        <translation>模拟机器人上的五个任务。每个任务都会检查结果。</translation>
    </message>
    <message>
        <source>Practice works only with the built-in simulated robot. The current robot is “%1”. Connect to the simulated robot first.</source>
        <translation>练习仅适用于内置的模拟机器人。当前机器人是“%1”。请先连接模拟机器人。</translation>
    </message>
    <message>
        <source>Practice: add “%1”</source>
        <translation>练习：添加“%1”</translation>
    </message>
</context>
</TS>
