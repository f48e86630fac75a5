<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP" sourcelanguage="en">
<context>
    <name>ActionStep</name>
    <message>
        <source>No gripper is configured for this robot. Select a gripper under I/O &gt; Gripper.</source>
        <translation>このロボットにはグリッパーが設定されていません。「I/O &gt; グリッパー」で選択してください。</translation>
    </message>
    <message>
        <source>Run route</source>
        <translation>ルート</translation>
    </message>
    <message>
        <source>%1 did not turn on within %2 s. Check the connected device, then try again.</source>
        <translation>%1が%2 s以内にオンになりませんでした。接続されている機器を確認し、もう一度試してください。</translation>
    </message>
    <message>
        <source>%1 did not turn off within %2 s. Check the connected device, then try again.</source>
        <translation>%1が%2 s以内にオフになりませんでした。接続されている機器を確認し、もう一度試してください。</translation>
    </message>
    <message>
        <source>The action “%1” was not completed. %2</source>
        <translation>動作「%1」は完了しませんでした。%2</translation>
    </message>
    <message>
        <source>The gripper did not stop moving within %1 s. Check the gripper, then try again.</source>
        <translation>グリッパーが %1 s 以内に停止しませんでした。グリッパーを確認し、もう一度試してください。</translation>
    </message>
</context>
<context>
    <name>ActionTable</name>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>Power and safety</source>
        <translation>電源と安全</translation>
    </message>
    <message>
        <source>Control and programs</source>
        <translation>制御とプログラム</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>ウェイポイント</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>座標系</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>I/O</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>ログ</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>View</source>
        <translation>ビュー</translation>
    </message>
    <message>
        <source>Perspectives</source>
        <translation>パースペクティブ</translation>
    </message>
    <message>
        <source>Move panels</source>
        <translation>パネルの移動</translation>
    </message>
    <message>
        <source>Application</source>
        <translation>アプリケーション</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Program steps</source>
        <translation>プログラムのステップ</translation>
    </message>
</context>
<context>
    <name>ActionWords</name>
    <message>
        <source>%1 on</source>
        <translation>%1をオン</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1をオフ</translation>
    </message>
    <message>
        <source>%1 on for %2 s</source>
        <translation>%1を%2 sオン</translation>
    </message>
    <message>
        <source>%1 off for %2 s</source>
        <translation>%1を%2 sオフ</translation>
    </message>
    <message>
        <source>Wait until %1 is on (max. %2 s)</source>
        <translation>%1のオンを待つ（最大 %2 s）</translation>
    </message>
    <message>
        <source>Wait until %1 is off (max. %2 s)</source>
        <translation>%1のオフを待つ（最大 %2 s）</translation>
    </message>
    <message>
        <source>Wait until %1 is on</source>
        <translation>%1のオンを待つ</translation>
    </message>
    <message>
        <source>Wait until %1 is off</source>
        <translation>%1のオフを待つ</translation>
    </message>
    <message>
        <source>Wait %1 s</source>
        <translation>%1 s待つ</translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation>グリッパーを開く</translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation>グリッパーを閉じる</translation>
    </message>
    <message>
        <source>Set an output</source>
        <translation>出力を設定</translation>
    </message>
    <message>
        <source>Pulse an output</source>
        <translation>出力をパルス</translation>
    </message>
    <message>
        <source>Wait for an input</source>
        <translation>入力を待つ</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>待機</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Jog, teach, run and monitor a Universal Robots arm from a PC.</source>
        <translation>ユニバーサルロボットのアームを PC からジョグ、教示、運転、監視します。</translation>
    </message>
    <message>
        <source>Start with the built-in simulated UR5e.</source>
        <translation>内蔵のシミュレートされた UR5e で開始します。</translation>
    </message>
    <message>
        <source>Connect to the robot at this address or host name.</source>
        <translation>このアドレスまたはホスト名のロボットに接続します。</translation>
    </message>
    <message>
        <source>Run the scripted demonstration on the simulated robot, write its files to this folder, and exit.</source>
        <translation>シミュレートされたロボットでデモのスクリプトを実行し、ファイルをこのフォルダーに残して終了します。</translation>
    </message>
    <message>
        <source>Open this project file (.tiller).</source>
        <translation>このプロジェクトファイル (.tiller) を開きます。</translation>
    </message>
    <message>
        <source>Colour theme: light or dark.</source>
        <translation>配色：light（明）または dark（暗）。</translation>
    </message>
    <message>
        <source>see tiller --help</source>
        <translation>tiller --help を参照</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>予期しない引数 &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--theme must be light or dark, not &quot;%1&quot;</source>
        <translation>--theme には light か dark を指定します（&quot;%1&quot; は不可）</translation>
    </message>
    <message>
        <source>--robot and --simulator cannot be combined</source>
        <translation>--robot と --simulator は同時に使えません</translation>
    </message>
    <message>
        <source>--demo works only on the simulated robot and cannot be combined with --robot</source>
        <translation>--demo はシミュレートされたロボットだけで動きます（--robot とは併用できません）</translation>
    </message>
    <message>
        <source>--demo requires a folder</source>
        <translation>--demo にはフォルダーが必要です</translation>
    </message>
    <message>
        <source>--robot requires an address, e.g. --robot 192.168.0.10</source>
        <translation>--robot にはアドレスが必要です（例：--robot 192.168.0.10）</translation>
    </message>
    <message>
        <source>only one project can be opened; remove &quot;%1&quot;</source>
        <translation>開けるプロジェクトは一つだけです（&quot;%1&quot; は不可）</translation>
    </message>
    <message>
        <source>Monitor only: do not change anything on the robot; STOP still works. Cannot be turned off in Settings.</source>
        <translation>監視のみ：ロボットを一切変更しません。STOP は使えます。設定では解除できません。</translation>
    </message>
    <message>
        <source>--demo moves the simulated robot and cannot be combined with --monitor-only</source>
        <translation>--demo はシミュレートされたロボットを動かすため、--monitor-only と併用できません</translation>
    </message>
    <message>
        <source>Open these recordings in the plots.</source>
        <translation>これらの記録をグラフで開きます。</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>Joint positions</source>
        <translation>関節の位置</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>TCP の位置</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>関節の電流</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>TCP の力</translation>
    </message>
    <message>
        <source>%1: not compared</source>
        <translation>%1：比較していません</translation>
    </message>
    <message>
        <source>%1: no values</source>
        <translation>%1：値がありません</translation>
    </message>
    <message>
        <source>%1: within %2 at all times, maximum %3 at %4 s</source>
        <translation>%1：%2 を超えず、最大 %3（%4 s）</translation>
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
        <translation>%1 s でアームとモデルがずれ始めます：%2 が %3 ずれています</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the TCP deviates by %2</source>
        <translation>%1 s でアームとモデルがずれ始めます：TCP が %2 ずれています</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the current of %2 deviates by %3</source>
        <translation>%1 s でアームとモデルがずれ始めます：%2 の電流が %3 ずれています</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: a force of %2 acts on the TCP</source>
        <translation>%1 s でアームとモデルがずれ始めます：TCP に %2 の力がかかっています</translation>
    </message>
    <message>
        <source>The motion matches the model of a %1</source>
        <translation>動作は %1 のモデルと一致しています</translation>
    </message>
    <message>
        <source>Nothing to compare: the arm was powered off or guided by hand for the whole recording.</source>
        <translation>比較できるものがありませんでした：アームはずっと電源が切れていたか、手で動かされていました。</translation>
    </message>
    <message>
        <source>The arm deviates from the model from the start of the recording. Check the payload and the robot model, and check whether something was touching the arm.</source>
        <translation>アームとモデルは記録の最初から一致していません。ペイロード、ロボットの機種、アームへの接触がなかったかを確認してください。</translation>
    </message>
    <message>
        <source>From this time on, the arm was pushed or held, its payload differed, or a joint did not follow its target.</source>
        <translation>この時点以降、アームが押されたか押さえられた、ペイロードが違った、または関節が目標に追従しませんでした。</translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: its sampling interval is too long. Record every packet.</source>
        <translation>この記録はモデルと比較できません：行の間隔が広すぎます。すべてのパケットを記録してください。</translation>
    </message>
    <message>
        <source>Not compared with the arm model.</source>
        <translation>アームのモデルとは比較していません。</translation>
    </message>
    <message>
        <source>The compared values match the model of a %1; other values were not recorded</source>
        <translation>比較した値は %1 のモデルと一致します。その他の値は記録されていません</translation>
    </message>
    <message>
        <source>The recorded arm is a %1, but it was compared with the model of a %2</source>
        <translation>記録されたアームは %1 ですが、%2 のモデルと比較されました</translation>
    </message>
    <message>
        <source>No deviation from the model of a %1, but the recorded values may fit other models too</source>
        <translation>%1 のモデルとの差はありませんが、記録された値は他のモデルにも当てはまる可能性があります</translation>
    </message>
    <message>
        <source>Compare the recording with the model of a %1.</source>
        <translation>記録を %1 のモデルと比較してください。</translation>
    </message>
    <message>
        <source>%1: not compared because the recording has no %2; record all signals to an MCAP file</source>
        <translation>%1：比較していません。記録に %2 がありません。すべての信号を MCAP に記録してください</translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: target or actual joint positions are missing. Record all signals to an MCAP file.</source>
        <translation>この記録はモデルと比較できません：関節への指令または関節の位置がありません。すべての信号を MCAP に記録してください。</translation>
    </message>
    <message>
        <source>%1: exceeds %2 starting at %3 s (%4), maximum %5 at %6 s</source>
        <translation>%1：%3 s から %2 を超過（%4）、最大 %5（%6 s）</translation>
    </message>
</context>
<context>
    <name>ControllerCodes</name>
    <message>
        <source>Near a joint limit</source>
        <translation>関節限界の近く</translation>
    </message>
    <message>
        <source>A joint came close to its limit.</source>
        <translation>関節が可動範囲の端に近づきました。</translation>
    </message>
    <message>
        <source>Jog the joint away from the limit, or change the waypoint.</source>
        <translation>関節をジョグして限界から離すか、ウェイポイントを変更してください。</translation>
    </message>
    <message>
        <source>Near a tool orientation limit</source>
        <translation>ツール姿勢限界の近く</translation>
    </message>
    <message>
        <source>The tool orientation came close to the limit set in the safety configuration.</source>
        <translation>ツールが安全設定の限界近くまで回転しました。</translation>
    </message>
    <message>
        <source>Rotate the tool away from the limit, or change the waypoint.</source>
        <translation>ツールを戻すか、ウェイポイントを変更してください。</translation>
    </message>
    <message>
        <source>Near a safety plane</source>
        <translation>安全平面の近く</translation>
    </message>
    <message>
        <source>The arm came close to a safety plane.</source>
        <translation>アームが安全平面に近づきました。</translation>
    </message>
    <message>
        <source>Jog away from the plane, or change the waypoint.</source>
        <translation>平面から離れるようにジョグするか、ウェイポイントを変更してください。</translation>
    </message>
    <message>
        <source>Position deviates from path</source>
        <translation>位置が経路から外れています</translation>
    </message>
    <message>
        <source>The arm is not at the commanded position.</source>
        <translation>アームが指令された位置にありません。</translation>
    </message>
    <message>
        <source>Check for obstacles; check payload, centre of gravity and mounting; reduce the acceleration.</source>
        <translation>障害物を探し、ペイロード、重心、取り付けを確認し、加速度を下げてください。</translation>
    </message>
    <message>
        <source>Singularity</source>
        <translation>特異点</translation>
    </message>
    <message>
        <source>The linear move passes through a singularity of the arm.</source>
        <translation>直線動作がアームの特異姿勢を通ります。</translation>
    </message>
    <message>
        <source>Jog individual joints away from the singularity. Use MoveJ to pass through the region.</source>
        <translation>関節を一つずつジョグして抜け出し、この領域では MoveJ を使ってください。</translation>
    </message>
    <message>
        <source>Cannot hold position</source>
        <translation>位置を保持できません</translation>
    </message>
    <message>
        <source>The arm sagged or was pushed while at standstill.</source>
        <translation>停止中にアームが下がったか、押されました。</translation>
    </message>
    <message>
        <source>Check payload, centre of gravity and mounting.</source>
        <translation>ペイロード、重心、取り付けを確認してください。</translation>
    </message>
    <message>
        <source>Wrong payload or mounting</source>
        <translation>ペイロードまたは取り付けの誤り</translation>
    </message>
    <message>
        <source>The measured forces do not match the payload, or the arm was pushed when Freedrive started.</source>
        <translation>力がペイロードと合わないか、フリードライブ開始時に何かがアームを押しました。</translation>
    </message>
    <message>
        <source>Collision detected by a joint</source>
        <translation>関節が衝突を検出</translation>
    </message>
    <message>
        <source>A joint required more torque than expected for the motion.</source>
        <translation>関節が、動作から説明できる以上のトルクを必要としました。</translation>
    </message>
    <message>
        <source>Remove the obstacle. If the arm did not touch anything, check the payload.</source>
        <translation>障害物を取り除いてください。なければペイロードを確認してください。</translation>
    </message>
    <message>
        <source>Collision detected at the tool</source>
        <translation>ツールで衝突を検出</translation>
    </message>
    <message>
        <source>The force at the tool exceeded the limit.</source>
        <translation>ツールの力が許容値を超えました。</translation>
    </message>
    <message>
        <source>Position deviation</source>
        <translation>位置のずれ</translation>
    </message>
    <message>
        <source>A joint deviated from its commanded position.</source>
        <translation>関節が指令位置から外れました。</translation>
    </message>
    <message>
        <source>Check for obstacles, and check payload and mounting.</source>
        <translation>障害物を探し、ペイロードと取り付けを確認してください。</translation>
    </message>
    <message>
        <source>Too many protective stops</source>
        <translation>保護停止が多すぎます</translation>
    </message>
    <message>
        <source>One joint had fifty protective stops within eight hours.</source>
        <translation>一つの関節で 8 時間に 50 回の保護停止がありました。</translation>
    </message>
    <message>
        <source>Find and correct the cause of the stops, then restart the controller.</source>
        <translation>停止の原因を特定して取り除き、その後コントローラを再起動してください。</translation>
    </message>
    <message>
        <source>Sudden change in target position</source>
        <translation>目標位置の急変</translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in position.</source>
        <translation>プログラムが不連続な位置を指令しました。</translation>
    </message>
    <message>
        <source>Start the program at the current position of the arm, and send servo targets in small steps.</source>
        <translation>プログラムをアームの現在位置から始め、サーボの刻みを小さくしてください。</translation>
    </message>
    <message>
        <source>Sudden change in target speed</source>
        <translation>目標速度の急変</translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in speed.</source>
        <translation>プログラムが不連続な速度を指令しました。</translation>
    </message>
    <message>
        <source>Reduce the acceleration, or smooth the path.</source>
        <translation>加速度を下げるか、経路を滑らかにしてください。</translation>
    </message>
    <message>
        <source>Protective stop requested by a program</source>
        <translation>プログラムによる保護停止</translation>
    </message>
    <message>
        <source>The running program requested the stop.</source>
        <translation>実行中のプログラムが停止を要求しました。</translation>
    </message>
    <message>
        <source>See the preceding program messages in the log.</source>
        <translation>ログでプログラムの以前のメッセージを確認してください。</translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation>ロボットはローカル制御です</translation>
    </message>
    <message>
        <source>A script was sent, but the robot accepts commands only from its teach pendant.</source>
        <translation>スクリプトが送られましたが、ロボットはティーチペンダントからの指令だけを受け付けます。</translation>
    </message>
    <message>
        <source>Switch to Remote control on the teach pendant.</source>
        <translation>ティーチペンダントでリモート制御に切り替えてください。</translation>
    </message>
    <message>
        <source>Controller message C%1</source>
        <translation>コントローラーのメッセージ C%1</translation>
    </message>
    <message>
        <source>Tiller has no description of this message code.</source>
        <translation>このメッセージコードの説明は Tiller にありません。</translation>
    </message>
    <message>
        <source>Look up C%1 in the manufacturer&apos;s error code directory.</source>
        <translation>メーカーのエラーコード一覧で C%1 を調べてください。</translation>
    </message>
    <message>
        <source>Correct the payload and the mounting, and do not push the arm when Freedrive starts.</source>
        <translation>ペイロードと取り付けを直し、フリードライブの開始時にアームを押さないでください。</translation>
    </message>
</context>
<context>
    <name>DerivedSignal</name>
    <message>
        <source>compute a signal</source>
        <translation>信号を計算する</translation>
    </message>
    <message>
        <source>The signal “%1” does not exist. See the signal list for the names.</source>
        <translation>信号「%1」はありません。信号の一覧に名前があります。</translation>
    </message>
    <message>
        <source>The expression contains no signal. Add the name of a signal.</source>
        <translation>式に信号がありません。信号の名前を追加してください。</translation>
    </message>
    <message>
        <source>The expression contains too many signals. Use fewer signals.</source>
        <translation>式の信号が多すぎます。信号を減らしてください。</translation>
    </message>
    <message>
        <source>The expression must evaluate to one number.</source>
        <translation>一つの数になる必要があります。</translation>
    </message>
    <message>
        <source>The text is too long. Use a shorter name or expression.</source>
        <translation>テキストが長すぎます。名前または式を短くしてください。</translation>
    </message>
    <message>
        <source>Enter a name, an equals sign and an expression, for example |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</source>
        <translation>名前、等号、式を入力してください。例：|F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</translation>
    </message>
    <message>
        <source>Too many equals signs. Use == to compare values.</source>
        <translation>等号が多すぎます。比較には == を使ってください</translation>
    </message>
    <message>
        <source>The functions are nested too deeply. Use at most %1 levels.</source>
        <translation>関数の入れ子が深すぎます。%1 段までにしてください。</translation>
    </message>
    <message>
        <source>The closing parenthesis of “%1” is missing.</source>
        <translation>「%1」の閉じ括弧がありません。</translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression, a cut-off frequency in Hz and optionally the order (1 to 8), for example %1(actual_q_0, 10, 2).</source>
        <translation>「%1」には信号または式、遮断周波数 (Hz)、必要なら次数 (1〜8) を指定します。例：%1(actual_q_0, 10, 2)</translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression and a time window in seconds, for example %1(actual_q_0, 0.5).</source>
        <translation>「%1」には信号または式と、時間の幅 (秒) を指定します。例：%1(actual_q_0, 0.5)</translation>
    </message>
    <message>
        <source>The cut-off frequency of “%1” must be between %2 and %3 Hz.</source>
        <translation>「%1」の遮断周波数は %2〜%3 Hz です。</translation>
    </message>
    <message>
        <source>The time window of “%1” must be between 0.001 and 60 seconds.</source>
        <translation>「%1」の時間の幅は 0.001〜60 秒です。</translation>
    </message>
    <message>
        <source>The function “%1” does not exist.</source>
        <translation>関数「%1」はありません。</translation>
    </message>
    <message>
        <source>“%1” contains a decimal comma. Write decimal numbers with a point: %2</source>
        <translation>「%1」に小数点のカンマが含まれています。小数はピリオドで入力してください: %2</translation>
    </message>
</context>
<context>
    <name>DeviceTrainer</name>
    <message>
        <source>%1 in %2</source>
        <translation>%2 の %1</translation>
    </message>
    <message>
        <source>Device axes</source>
        <translation>デバイスの軸</translation>
    </message>
</context>
<context>
    <name>Doctor</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 と他 %2</translation>
    </message>
    <message>
        <source>The robot&apos;s software is too old. Update the software to %1.%2 or newer.</source>
        <translation>ロボットのソフトウェアが古すぎます。%1.%2 以降に更新してください。</translation>
    </message>
    <message>
        <source>Some values and the control registers are missing. Update the robot&apos;s software to %1.%2 or newer.</source>
        <translation>いくつかの値と制御用レジスターがありません。ロボットを %1.%2 以降に更新してください。</translation>
    </message>
    <message>
        <source>Inspect the arm and remove the cause. Then press “Recover…” in the Tiller header, or use the teach pendant.</source>
        <translation>アームを点検して原因を取り除き、復旧してください：ヘッダーの「復旧…」を押すか、ティーチペンダントを使います。</translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes, with the button in the Tiller header or on the teach pendant.</source>
        <translation>Tiller のヘッダーのボタンまたはティーチペンダントで、アームの電源を入れ、ブレーキを解除してください。</translation>
    </message>
    <message>
        <source>the RTDE port accepts connections but does not respond</source>
        <translation>RTDE ポートは接続を受けますが応答しません</translation>
    </message>
    <message>
        <source>the service on port %1 does not use RTDE</source>
        <translation>ポート %1 のサービスは RTDE ではありません</translation>
    </message>
    <message>
        <source>Too many RTDE clients are connected, or the controller has stopped responding. Close other programs, then restart the controller.</source>
        <translation>RTDE クライアントが多すぎるか、コントローラーが応答していません。他のプログラムを閉じ、コントローラーを再起動してください。</translation>
    </message>
    <message>
        <source>Check the address. The address may belong to another device, or another program may be using the port.</source>
        <translation>アドレスを確認してください：別の機器か、別のプログラムがポートを使っています。</translation>
    </message>
    <message>
        <source>protocol version %1</source>
        <translation>プロトコルバージョン %1</translation>
    </message>
    <message>
        <source>another program uses %1</source>
        <translation>別のプログラムが %1 を使用中</translation>
    </message>
    <message>
        <source>Close the other program that controls this robot (another Tiller window, ROS, ur_rtde).</source>
        <translation>このロボットを制御している別のプログラム（別のウィンドウ、ROS、ur_rtde）を終了してください。</translation>
    </message>
    <message>
        <source>this software version has no registers 24 to 47</source>
        <translation>このソフトウェアバージョンにはレジスター 24〜47 がありません</translation>
    </message>
    <message>
        <source>Update the robot&apos;s software to 3.9, 5.3 or newer.</source>
        <translation>ロボットのソフトウェアを 3.9、5.3 またはそれ以降に更新してください。</translation>
    </message>
    <message>
        <source>registers 24 to 47 are free</source>
        <translation>レジスター 24〜47 は空いています</translation>
    </message>
    <message>
        <source>a fieldbus adapter or another program uses %1</source>
        <translation>フィールドバスアダプターか別のプログラムが %1 を使用中</translation>
    </message>
    <message>
        <source>No action needed for jogging. To use these registers, disable EtherNet/IP, PROFINET or MODBUS in the robot&apos;s installation.</source>
        <translation>ジョグには対応不要です。これらのレジスターを使うには、ロボットのインストールで EtherNet/IP、PROFINET、MODBUS を無効にしてください。</translation>
    </message>
    <message>
        <source>registers 0 to 23 are free</source>
        <translation>レジスター 0〜23 は空いています</translation>
    </message>
    <message>
        <source>the robot accepts the subscription but sends no data</source>
        <translation>ロボットは購読を受け付けますがデータを送りません</translation>
    </message>
    <message>
        <source>Close other RTDE programs, then restart the robot&apos;s controller.</source>
        <translation>他の RTDE プログラムを閉じ、ロボットのコントローラーを再起動してください。</translation>
    </message>
    <message>
        <source>%1 of %2 packets per second</source>
        <translation>毎秒 %1 / %2 パケット</translation>
    </message>
    <message>
        <source>Packets are missing. Use a cable instead of a wireless link, and close other programs that put load on the robot or this PC.</source>
        <translation>パケットが欠けています。無線ではなくケーブルを使い、ロボットやこの PC に負荷をかける他のプログラムを閉じてください。</translation>
    </message>
    <message>
        <source>priority %1</source>
        <translation>優先度 %1</translation>
    </message>
    <message>
        <source>the system does not grant this user real-time priority</source>
        <translation>システムはこのユーザーにリアルタイム優先度を許可していません</translation>
    </message>
    <message>
        <source>CPUs may enter deep sleep states, which delay real-time loops</source>
        <translation>CPU が深いスリープ状態に入ることがあり、リアルタイムループが遅れます</translation>
    </message>
    <message>
        <source>TCP %1 mm from the flange, payload %2 kg</source>
        <translation>TCP はフランジから %1 mm、ペイロード %2 kg</translation>
    </message>
    <message>
        <source>If a tool is mounted, set the TCP and the payload in the robot&apos;s installation: a wrong payload causes protective stops and makes the arm drift in Freedrive.</source>
        <translation>ツールを付けている場合は、ロボットのインストールで TCP とペイロードを設定してください。誤ったペイロードは保護停止の原因になり、フリードライブでアームが勝手に動きます。</translation>
    </message>
    <message>
        <source>“%1” is not a valid address, and no host with this name was found</source>
        <translation>&quot;%1&quot; は有効なアドレスではなく、その名前のホストもありません</translation>
    </message>
    <message>
        <source>Enter the IP address shown on the teach pendant under About, or ask your network administrator for the host name.</source>
        <translation>ティーチペンダントの「情報」に表示される IP アドレスを入力するか、ネットワーク管理者にホスト名を確認してください。</translation>
    </message>
    <message>
        <source>%1 does not respond</source>
        <translation>%1 は応答しません</translation>
    </message>
    <message>
        <source>no network route to %1</source>
        <translation>%1 へのネットワーク経路がありません</translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and no firewall blocks the connection.</source>
        <translation>ロボットの電源とケーブルを確認し、間にファイアウォールがないことを確認してください。</translation>
    </message>
    <message>
        <source>Assign this PC an address in the robot&apos;s network (the same first three numbers), and check the cable.</source>
        <translation>この PC にロボットのネットワークのアドレス（最初の三つの数が同じ）を設定し、ケーブルを確認してください。</translation>
    </message>
    <message>
        <source>%1 responds, but provides no robot services</source>
        <translation>%1 は応答しますが、ロボットのサービスを提供していません</translation>
    </message>
    <message>
        <source>Check that this is the address of the robot. A robot that has just been switched on may need another minute.</source>
        <translation>ロボット自身のアドレスか確認してください。電源投入直後のロボットはもう 1 分かかります。</translation>
    </message>
    <message>
        <source>%1 responds</source>
        <translation>%1 は応答します</translation>
    </message>
    <message>
        <source>dashboard, port %1</source>
        <translation>ダッシュボード、ポート %1</translation>
    </message>
    <message>
        <source>port %1</source>
        <translation>ポート %1</translation>
    </message>
    <message>
        <source>port %1 is closed</source>
        <translation>ポート %1 は閉じています</translation>
    </message>
    <message>
        <source>port %1 does not respond</source>
        <translation>ポート %1 は応答しません</translation>
    </message>
    <message>
        <source>Enable this interface on the robot under Settings &gt; Security &gt; Services.</source>
        <translation>ロボットの「設定 &gt; セキュリティ &gt; サービス」でこのインターフェースを有効にしてください。</translation>
    </message>
    <message>
        <source>A firewall may be blocking this port. Allow TCP port %1 to the robot.</source>
        <translation>ファイアウォールがこのポートを遮っている可能性があります。ロボットへの TCP ポート %1 を許可してください。</translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant. Until then, Tiller can only monitor.</source>
        <translation>ティーチペンダント右上でロボットをリモート制御に切り替えてください。それまで Tiller は監視だけです。</translation>
    </message>
    <message>
        <source>the dashboard accepts connections but does not respond</source>
        <translation>ダッシュボードは接続を受けますが応答しません</translation>
    </message>
    <message>
        <source>the service on port %1 is not a dashboard server</source>
        <translation>ポート %1 の相手はダッシュボードではありません</translation>
    </message>
    <message>
        <source>Restart the robot&apos;s controller. If the problem persists, see the controller log.</source>
        <translation>ロボットのコントローラーを再起動してください。直らなければログを見てください。</translation>
    </message>
    <message>
        <source>Check the address, and check that no other program is using this port.</source>
        <translation>アドレスと、他のプログラムがこのポートを使っていないことを確認してください。</translation>
    </message>
    <message>
        <source>this series has no Local/Remote switch</source>
        <translation>このシリーズにはローカル／リモートの切り替えがありません</translation>
    </message>
    <message>
        <source>Remote</source>
        <translation>リモート</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>ローカル</translation>
    </message>
    <message>
        <source>neither the dashboard (port %1) nor the Robot API (port %2) is available</source>
        <translation>ダッシュボード（ポート %1）も Robot API（ポート %2）もありません</translation>
    </message>
    <message>
        <source>the primary interface sends no data about the arm</source>
        <translation>プライマリーインターフェースからアームの情報が得られません</translation>
    </message>
    <message>
        <source>Check that this is the address of the robot, and restart its controller.</source>
        <translation>ロボット自身のアドレスか確認し、コントローラーを再起動してください。</translation>
    </message>
    <message>
        <source>robot type %1 is not known to this version of Tiller</source>
        <translation>ロボット型式 %1 はこのバージョンの Tiller では未対応です</translation>
    </message>
    <message>
        <source>Monitoring works. Limits and previews use the dimensions that the robot reports; jog slowly at first.</source>
        <translation>監視は可能です。限界とプレビューはロボットが報告する寸法を使います。最初はゆっくりジョグしてください。</translation>
    </message>
    <message>
        <source>Address resolves</source>
        <translation>アドレスの解決</translation>
    </message>
    <message>
        <source>Host responds</source>
        <translation>ホストの応答</translation>
    </message>
    <message>
        <source>RTDE port</source>
        <translation>RTDE ポート</translation>
    </message>
    <message>
        <source>Primary port</source>
        <translation>プライマリーポート</translation>
    </message>
    <message>
        <source>Secondary port</source>
        <translation>セカンダリーポート</translation>
    </message>
    <message>
        <source>Real-time port</source>
        <translation>リアルタイムポート</translation>
    </message>
    <message>
        <source>Dashboard or Robot API</source>
        <translation>ダッシュボードまたは Robot API</translation>
    </message>
    <message>
        <source>RTDE protocol</source>
        <translation>RTDE プロトコル</translation>
    </message>
    <message>
        <source>Controller software</source>
        <translation>コントローラーのソフトウェア</translation>
    </message>
    <message>
        <source>Robot model</source>
        <translation>ロボット型式</translation>
    </message>
    <message>
        <source>Remote control</source>
        <translation>リモート制御</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>安全</translation>
    </message>
    <message>
        <source>Power and brakes</source>
        <translation>電源とブレーキ</translation>
    </message>
    <message>
        <source>Control registers free</source>
        <translation>制御用レジスターの空き</translation>
    </message>
    <message>
        <source>Data rate</source>
        <translation>データレート</translation>
    </message>
    <message>
        <source>Real-time priority on this PC</source>
        <translation>この PC のリアルタイム優先度</translation>
    </message>
    <message>
        <source>TCP and payload</source>
        <translation>TCP とペイロード</translation>
    </message>
    <message>
        <source>real-time loops can keep the CPUs out of deep sleep states</source>
        <translation>リアルタイムループは CPU の深いスリープ状態を防止できます</translation>
    </message>
    <message>
        <source>Enable the dashboard server on the robot under Settings &gt; Security &gt; Services. On PolyScope X, the Robot API requires version 10.11 or newer.</source>
        <translation>ロボットの「設定 &gt; セキュリティ &gt; サービス」で Dashboard Server を有効にしてください。PolyScope X の Robot API は 10.11 以降が必要です。</translation>
    </message>
    <message>
        <source>Robot API %1, port %2; popups can be closed only on the teach pendant</source>
        <translation>Robot API %1、ポート %2。ポップアップを閉じられるのはティーチペンダントだけです</translation>
    </message>
    <message>
        <source>Fieldbus registers free</source>
        <translation>フィールドバス用レジスターの空き</translation>
    </message>
    <message>
        <source>Wake-up latency on this PC</source>
        <translation>この PC のウェイクアップ遅延</translation>
    </message>
</context>
<context>
    <name>Freedrive</name>
    <message>
        <source>All axes</source>
        <translation>全軸</translation>
    </message>
    <message>
        <source>Position only</source>
        <translation>位置のみ</translation>
    </message>
    <message>
        <source>Orientation only</source>
        <translation>姿勢のみ</translation>
    </message>
    <message>
        <source>XY plane</source>
        <translation>XY 平面</translation>
    </message>
    <message>
        <source>Z only</source>
        <translation>Z のみ</translation>
    </message>
    <message>
        <source>Wait for standstill before you start Freedrive.</source>
        <translation>静止を待ってからフリードライブを開始してください。</translation>
    </message>
    <message>
        <source>The arm would drift: the robot measures %1 with a payload of %2 kg. Do not touch the tool, or correct the payload and the TCP.</source>
        <translation>ペイロード %2 kg でアームは %1 を検出しており、勝手に動くおそれがあります。ツールから手を離すか、ペイロードと TCP を修正してください。</translation>
    </message>
</context>
<context>
    <name>Gamepad</name>
    <message>
        <source>left bumper</source>
        <translation>左バンパー</translation>
    </message>
    <message>
        <source>Left stick: X and Y. Right stick: Z and rotation. Hold the right bumper to rotate with both sticks.</source>
        <translation>左スティックは X と Y、右スティックは Z と回転。右バンパーを押している間、両スティックで回転。</translation>
    </message>
</context>
<context>
    <name>InterfaceSize</name>
    <message>
        <source>This screen has a high resolution. Increase “Interface size” in Settings to enlarge text, controls and plots.</source>
        <translation>この画面は高解像度です。設定の「画面要素のサイズ」を大きくすると、文字、ボタン、グラフが拡大されます。</translation>
    </message>
</context>
<context>
    <name>JogActions</name>
    <message>
        <source>Jog speed %1</source>
        <translation>ジョグ速度 %1</translation>
    </message>
    <message>
        <source>Jog step %1, %2°</source>
        <translation>ジョグステップ %1、%2°</translation>
    </message>
    <message>
        <source>Arm or disarm keyboard jogging</source>
        <translation>キーボードジョグを有効／無効にする</translation>
    </message>
    <message>
        <source>While the keyboard is armed, the arrow keys move the arm and a border surrounds the window. The keyboard is disarmed after 30 s without use.</source>
        <translation>キーボードが有効な間、矢印キーがアームを動かし、ウィンドウが枠で囲まれます。30 秒間使わないと無効になります。</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse…</source>
        <translation>ゲームパッドと SpaceMouse…</translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation>各デバイスの現在の値と、アームが動く方向を表示します。</translation>
    </message>
    <message>
        <source>Zero here</source>
        <translation>ここをゼロに</translation>
    </message>
    <message>
        <source>Shows the TCP displacement from the current position. Press again to show the displacement since the start of the last motion.</source>
        <translation>この位置からの TCP の移動量を表示します。もう一度押すと、最後の動作の開始からの移動量になります。</translation>
    </message>
    <message>
        <source>Stops the arm. The next press uses this speed.</source>
        <translation>アームを止めます。次に押すとこの速度になります。</translation>
    </message>
    <message>
        <source>Moves the arm by this distance while the button is held.</source>
        <translation>ボタンを押している間、アームをこの距離だけ動かします。</translation>
    </message>
    <message>
        <source>Each press moves the arm by this distance.</source>
        <translation>押すたびにアームをこの距離だけ動かします。</translation>
    </message>
    <message>
        <source>Jog until contact (%1 N)</source>
        <translation>接触までジョグ（%1 N）</translation>
    </message>
    <message>
        <source>Moves slowly while the button is held and stops when the contact force reaches this value.</source>
        <translation>ボタンを押している間ゆっくり動き、接触力がこの値に達すると止まります。</translation>
    </message>
    <message>
        <source>Other jog speed…</source>
        <translation>他のジョグ速度…</translation>
    </message>
    <message>
        <source>Sets the TCP speed. Rotation and joint speeds change in proportion.</source>
        <translation>TCP の速度を設定します。回転と関節の速度は比例して変わります。</translation>
    </message>
    <message>
        <source>Other jog step…</source>
        <translation>他のジョグステップ…</translation>
    </message>
    <message>
        <source>Sets the step length. The step angle does not change.</source>
        <translation>ステップの長さを設定します。ステップの角度は変わりません。</translation>
    </message>
    <message>
        <source>Other jog angle…</source>
        <translation>他の回転ステップ…</translation>
    </message>
    <message>
        <source>Sets the step angle of tool and joint rotations. The step length does not change.</source>
        <translation>ツールと関節の回転ステップの角度を設定します。ステップの長さは変わりません。</translation>
    </message>
    <message>
        <source>Other contact force for jogging…</source>
        <translation>ジョグの他の接触力…</translation>
    </message>
    <message>
        <source>Sets the contact force in N that ends the motion.</source>
        <translation>動作を終える接触力を N で設定します。</translation>
    </message>
    <message>
        <source>Freedrive: %1</source>
        <translation>フリードライブ：%1</translation>
    </message>
    <message>
        <source>Selects the axes that can be moved by hand during Freedrive.</source>
        <translation>フリードライブ中に手で動かせる軸を選択します。</translation>
    </message>
</context>
<context>
    <name>JogColumn</name>
    <message>
        <source>Tool</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>View</source>
        <translation>ビュー</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>ベース</translation>
    </message>
</context>
<context>
    <name>JointNames</name>
    <message>
        <source>Base</source>
        <translation>ベース</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>肩</translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation>肘</translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation>手首1</translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation>手首2</translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation>手首3</translation>
    </message>
</context>
<context>
    <name>KeyStateProbe</name>
    <message>
        <source>Key-state check unavailable on this platform (%1): Tiller relies on window events to detect key releases.</source>
        <translation>このプラットフォームではキー状態を確認できません（%1）：キーを離したことはウィンドウのイベントで検出します。</translation>
    </message>
    <message>
        <source>Key-state check active: Tiller checks with the display server every 10 ms whether the button or key is still pressed.</source>
        <translation>キー状態の確認は有効です：ボタンやキーが押されているかを 10 ms ごとにディスプレイサーバーで確認します。</translation>
    </message>
    <message>
        <source>Key-state check unavailable: Tiller could not open a second connection to the display server. Tiller relies on window events to detect key releases.</source>
        <translation>キー状態を確認できません：ディスプレイサーバーへの 2 番目の接続がありません。キーを離したことはウィンドウのイベントで検出します。</translation>
    </message>
</context>
<context>
    <name>LimiterAdvice</name>
    <message>
        <source>Elbow almost straight</source>
        <translation>肘がほぼ伸びています</translation>
    </message>
    <message>
        <source>Elbow almost straight: %1 speed</source>
        <translation>肘がほぼ伸びています：速度の %1</translation>
    </message>
    <message>
        <source>bend the elbow</source>
        <translation>肘を曲げる</translation>
    </message>
    <message>
        <source>jog %1 or bend the elbow</source>
        <translation>%1 へジョグするか肘を曲げる</translation>
    </message>
    <message>
        <source>Wrist near the base axis</source>
        <translation>手首がベース軸の近く</translation>
    </message>
    <message>
        <source>Wrist near the base axis: %1 speed</source>
        <translation>手首がベース軸の近く：速度の %1</translation>
    </message>
    <message>
        <source>move outwards</source>
        <translation>外側へ動かす</translation>
    </message>
    <message>
        <source>jog %1 or rotate the base</source>
        <translation>%1 へジョグするかベースを回す</translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°</source>
        <translation>手首2が 0° か 180° の近く</translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°: %1 speed</source>
        <translation>手首2が 0° か 180° の近く：速度の %1</translation>
    </message>
    <message>
        <source>rotate wrist 2</source>
        <translation>手首2を回す</translation>
    </message>
    <message>
        <source>jog %1 or rotate wrist 2</source>
        <translation>%1 へジョグするか手首2を回す</translation>
    </message>
    <message>
        <source>%1 %2° from its limit</source>
        <translation>%1 は限界まで %2°</translation>
    </message>
    <message>
        <source>rotate %1 %2</source>
        <translation>%1 を %2 に回す</translation>
    </message>
    <message>
        <source>jog %1 or rotate %2 %3</source>
        <translation>%1 へジョグするか %2 を %3 に回す</translation>
    </message>
    <message>
        <source>TCP at the speed cap: %1 speed</source>
        <translation>TCP が速度上限：速度の %1</translation>
    </message>
    <message>
        <source>change the cap in Settings</source>
        <translation>設定で上限を変更</translation>
    </message>
    <message>
        <source>Elbow at the speed cap: %1 speed</source>
        <translation>肘が速度上限：速度の %1</translation>
    </message>
    <message>
        <source>Rotation at the speed cap: %1 speed</source>
        <translation>回転が速度上限：速度の %1</translation>
    </message>
    <message>
        <source>%1 at its maximum speed: %2 speed</source>
        <translation>%1 が最高速度：速度の %2</translation>
    </message>
    <message>
        <source>choose a lower speed</source>
        <translation>遅い速度を選ぶ</translation>
    </message>
    <message>
        <source>move away</source>
        <translation>離れる方向へ移動</translation>
    </message>
    <message>
        <source>jog %1</source>
        <translation>%1へジョグ</translation>
    </message>
    <message>
        <source>%1 is %2 from %3: %4 speed</source>
        <translation>%1は%3まで%2：速度の%4</translation>
    </message>
    <message>
        <source>%1 is %2 from %3</source>
        <translation>%1は%3まで%2</translation>
    </message>
</context>
<context>
    <name>LocalSimulator</name>
    <message>
        <source>Simulated UR5e</source>
        <translation>シミュレートされた UR5e</translation>
    </message>
</context>
<context>
    <name>ModeLook</name>
    <message>
        <source>FREEDRIVE</source>
        <translation>フリードライブ</translation>
    </message>
    <message>
        <source>The arm can be moved by hand.</source>
        <translation>アームを手で動かせます。</translation>
    </message>
    <message>
        <source>MOVING</source>
        <translation>動作中</translation>
    </message>
    <message>
        <source>The robot reports that the arm is moving.</source>
        <translation>ロボットはアームが動作中と報告しています。</translation>
    </message>
    <message>
        <source>Remote</source>
        <translation>リモート</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>ローカル</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>手動</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>データなし</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>制御を取得中…</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>フリードライブ</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>準備完了</translation>
    </message>
    <message>
        <source>In control</source>
        <translation>制御中</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>拒否</translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation>制御なし</translation>
    </message>
    <message>
        <source>Commands take longer than 20 ms: the arm responds with a delay. Jog slowly.</source>
        <translation>指令に 20 ms 以上かかっています：アームの反応が遅れます。ゆっくりジョグしてください。</translation>
    </message>
    <message>
        <source>Good: the arm responds immediately and stops within 250 ms if the link fails.</source>
        <translation>良好：アームはすぐに反応し、接続が切れると 250 ms 以内に停止します。</translation>
    </message>
    <message>
        <source>Last 10 s: %1 packets, %2 late, %3 lost</source>
        <translation>直近 10 秒：%1 パケット、遅れ %2、欠落 %3</translation>
    </message>
    <message>
        <source>Since connecting: %1 packets, %2 late, %3 lost</source>
        <translation>接続以来：%1 パケット、遅れ %2、欠落 %3</translation>
    </message>
    <message>
        <source>A packet counts as late when it arrives more than half a period after its expected time.</source>
        <translation>予定より半周期以上遅く届いたパケットを「遅れ」と数えます。</translation>
    </message>
    <message>
        <source>No robot connected</source>
        <translation>ロボット未接続</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>接続中…</translation>
    </message>
    <message>
        <source>Late: %1 s</source>
        <translation>遅れ：%1 s</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source> · %1 late</source>
        <translation> · 遅れ %1</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · 欠落 %1</translation>
    </message>
    <message>
        <source>LINK · JOG STOPS</source>
        <translation>リンク · ジョグ停止</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>リンク</translation>
    </message>
    <message>
        <source>LINK · JOG MAY STOP</source>
        <translation>リンク · 停止の恐れ</translation>
    </message>
    <message>
        <source>LINK · ARM LAGS</source>
        <translation>リンク · 動作の遅れ</translation>
    </message>
    <message>
        <source>LINK · GOOD</source>
        <translation>リンク · 良好</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>接続…</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>電源オン</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>ブレーキ解除</translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation>復旧…</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>制御を取得</translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation>アームの電源を入れます。ブレーキはかかったままです。</translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation>アームが数ミリ下がることがあります。離れてください。</translation>
    </message>
    <message>
        <source>Shows the cause of the stop, the five seconds before it, and the recovery steps. The arm does not move.</source>
        <translation>停止の原因、停止前の 5 秒、復旧の手順を表示します。アームは動きません。</translation>
    </message>
    <message>
        <source>Data late</source>
        <translation>データ遅延</translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation>ロボットで制御プログラムを開始します。別のプログラムを停止する前に確認します。</translation>
    </message>
    <message>
        <source>Monitoring</source>
        <translation>監視中</translation>
    </message>
    <message>
        <source>Select the simulator or enter the address of a robot.</source>
        <translation>シミュレーターを選ぶか、ロボットのアドレスを入力してください。</translation>
    </message>
    <message>
        <source>Packets are late or lost: jogging may stop and plots may have gaps. Use a cable instead of a wireless link, and close other programs.</source>
        <translation>パケットが遅れるか届きません：ジョグが止まったり、グラフに隙間ができます。無線ではなくケーブルを使い、他のプログラムを閉じてください。</translation>
    </message>
</context>
<context>
    <name>ModeWords</name>
    <message>
        <source>No controller</source>
        <translation>コントローラーなし</translation>
    </message>
    <message>
        <source>The robot&apos;s controller is not running. Restart the control box.</source>
        <translation>ロボットのコントローラーが動いていません。コントロールボックスを再起動してください。</translation>
    </message>
    <message>
        <source>Arm disconnected</source>
        <translation>アーム未接続</translation>
    </message>
    <message>
        <source>The controller has no connection to the arm. See the teach pendant for the cause.</source>
        <translation>コントローラーがアームと通信していません。ティーチペンダントを見てください。</translation>
    </message>
    <message>
        <source>Confirm safety</source>
        <translation>安全の確認</translation>
    </message>
    <message>
        <source>Confirm the safety configuration on the teach pendant.</source>
        <translation>ティーチペンダントで安全設定を確認してください。</translation>
    </message>
    <message>
        <source>Booting</source>
        <translation>起動中</translation>
    </message>
    <message>
        <source>The arm is starting. Wait a few seconds.</source>
        <translation>アームが起動中です。数秒お待ちください。</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>電源オフ</translation>
    </message>
    <message>
        <source>The arm is powered off. Power on the arm.</source>
        <translation>アームの電源がオフです。電源を入れてください。</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>電源オン</translation>
    </message>
    <message>
        <source>The arm is powered on and initializing. Wait a moment.</source>
        <translation>アームに電源が入り、準備しています。しばらくお待ちください。</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>待機</translation>
    </message>
    <message>
        <source>The brakes are engaged. Release the brakes.</source>
        <translation>ブレーキがかかっています。解除してください。</translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation>バックドライブ</translation>
    </message>
    <message>
        <source>The arm is being moved by hand with its brakes released. Release the Freedrive button.</source>
        <translation>ブレーキを解除した状態で、アームを手で動かしています。フリードライブボタンを離してください。</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>稼働中</translation>
    </message>
    <message>
        <source>Updating firmware</source>
        <translation>ファームウェア更新中</translation>
    </message>
    <message>
        <source>The joints&apos; firmware is being updated. Do not switch off the power until the update is complete.</source>
        <translation>関節のファームウェアを更新しています。更新が終わるまで電源を切らないでください。</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>通常</translation>
    </message>
    <message>
        <source>No safety stop is active.</source>
        <translation>安全停止は作動していません。</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>低減</translation>
    </message>
    <message>
        <source>The reduced safety limits are active.</source>
        <translation>低減された安全限界が有効です。</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>保護停止</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>リカバリー</translation>
    </message>
    <message>
        <source>The arm is outside a safety limit. Use the teach pendant to move the arm back within the limits.</source>
        <translation>アームが安全限界の外にあります。ティーチペンダントで限界内に戻してください。</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>安全防護停止</translation>
    </message>
    <message>
        <source>A safeguard is open. Close it and, if a reset is configured, press the reset button.</source>
        <translation>安全防護が開いています。閉じて、リセットが設定されていれば押してください。</translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation>システム非常停止</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>非常停止</translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation>安全違反</translation>
    </message>
    <message>
        <source>A safety limit was exceeded and power was cut. Check the cause, then restart the safety system.</source>
        <translation>安全限界を超え、電源が切られました。原因を調べてから安全システムを再起動してください。</translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation>安全故障</translation>
    </message>
    <message>
        <source>The safety system found a fault. Check the robot&apos;s log, then restart the safety system.</source>
        <translation>安全システムが故障を検出しました。ロボットのログを確認してから安全システムを再起動してください。</translation>
    </message>
    <message>
        <source>Validate joints</source>
        <translation>関節の検証</translation>
    </message>
    <message>
        <source>A joint was replaced. Validate the joints on the teach pendant.</source>
        <translation>関節が交換されました。ティーチペンダントで関節を検証してください。</translation>
    </message>
    <message>
        <source>Undefined</source>
        <translation>未定義</translation>
    </message>
    <message>
        <source>The controller does not report its safety mode. Check the teach pendant.</source>
        <translation>コントローラーが安全モードを報告しません。ティーチペンダントを確認してください。</translation>
    </message>
    <message>
        <source>Automatic safeguard stop</source>
        <translation>自動安全防護停止</translation>
    </message>
    <message>
        <source>The automatic mode safeguard is open. Close it, or switch to manual mode.</source>
        <translation>自動モードの安全防護が開いています。閉じるか手動モードに切り替えてください。</translation>
    </message>
    <message>
        <source>Enabling device stop</source>
        <translation>イネーブル装置停止</translation>
    </message>
    <message>
        <source>The enabling device is not held. Hold it in its middle position.</source>
        <translation>イネーブル装置が握られていません。中間位置で握ってください。</translation>
    </message>
    <message>
        <source>Pendant enabling stop</source>
        <translation>ペンダントイネーブル停止</translation>
    </message>
    <message>
        <source>IMMI emergency stop</source>
        <translation>IMMI 非常停止</translation>
    </message>
    <message>
        <source>IMMI safeguard stop</source>
        <translation>IMMI 安全防護停止</translation>
    </message>
    <message>
        <source>The moulding machine&apos;s safeguard is open. Close it.</source>
        <translation>成形機の安全防護が開いています。閉じてください。</translation>
    </message>
    <message>
        <source>PROFIsafe waiting</source>
        <translation>PROFIsafe 待機</translation>
    </message>
    <message>
        <source>The robot is waiting for the PROFIsafe controller. Check the fieldbus and the PROFIsafe parameters.</source>
        <translation>ロボットは PROFIsafe コントローラーを待っています。フィールドバスと PROFIsafe のパラメーターを確認してください。</translation>
    </message>
    <message>
        <source>PROFIsafe automatic stop</source>
        <translation>PROFIsafe 自動停止</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an automatic mode safeguard stop. Clear the request on that controller.</source>
        <translation>PROFIsafe コントローラーが自動モードの安全防護停止を要求しています。PROFIsafe コントローラー側で解除してください。</translation>
    </message>
    <message>
        <source>PROFIsafe safeguard stop</source>
        <translation>PROFIsafe 安全防護停止</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests a safeguard stop. Clear the request on that controller.</source>
        <translation>PROFIsafe コントローラーが安全防護停止を要求しています。PROFIsafe コントローラー側で解除してください。</translation>
    </message>
    <message>
        <source>PROFIsafe emergency stop</source>
        <translation>PROFIsafe 非常停止</translation>
    </message>
    <message>
        <source>Safety API stop</source>
        <translation>Safety API 停止</translation>
    </message>
    <message>
        <source>A program requests a safeguard stop through the safety API. Clear the request in that program.</source>
        <translation>プログラムが安全 API を通じて安全防護停止を要求しています。そのプログラムで要求を解除してください。</translation>
    </message>
    <message>
        <source>I/O plane stop</source>
        <translation>I/O 平面停止</translation>
    </message>
    <message>
        <source>The tool crossed a safety plane that is enabled by an input. Move the tool back with the teach pendant, or turn the input off.</source>
        <translation>入力で有効になった安全平面をツールが越えました。ティーチペンダントで外へ出すか、入力を切ってください。</translation>
    </message>
    <message>
        <source>Program stopping</source>
        <translation>プログラム停止中</translation>
    </message>
    <message>
        <source>The program on the robot is stopping.</source>
        <translation>ロボットのプログラムを終了しています。</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>プログラムなし</translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation>ロボットでプログラムは動いていません。</translation>
    </message>
    <message>
        <source>Program running</source>
        <translation>プログラム再生中</translation>
    </message>
    <message>
        <source>A program is running on the robot and may move the arm.</source>
        <translation>ロボットでプログラムが動いており、アームを動かすことがあります。</translation>
    </message>
    <message>
        <source>Program pausing</source>
        <translation>プログラム一時停止へ</translation>
    </message>
    <message>
        <source>The program is pausing.</source>
        <translation>プログラムを一時停止しています。</translation>
    </message>
    <message>
        <source>Program paused</source>
        <translation>プログラム一時停止</translation>
    </message>
    <message>
        <source>Press “Play” to continue the interrupted motion, or stop the program to discard it.</source>
        <translation>再生すると中断した動作を続けます。破棄するにはプログラムを停止してください。</translation>
    </message>
    <message>
        <source>Program resuming</source>
        <translation>プログラム再開中</translation>
    </message>
    <message>
        <source>The program is resuming, and the arm may move.</source>
        <translation>プログラムを再開しています：アームが動くことがあります。</translation>
    </message>
    <message>
        <source>Unknown robot mode %1. See the teach pendant.</source>
        <translation>不明なロボットモード %1。ティーチペンダントを見てください。</translation>
    </message>
    <message>
        <source>Unknown safety mode %1. See the teach pendant.</source>
        <translation>不明な安全モード %1。ティーチペンダントを見てください。</translation>
    </message>
    <message>
        <source>Unknown program state %1. See the teach pendant.</source>
        <translation>不明なプログラム状態 %1。ティーチペンダントを見てください。</translation>
    </message>
    <message>
        <source>The brakes are released. The arm is at standstill.</source>
        <translation>ブレーキは解除され、アームは静止しています。</translation>
    </message>
    <message>
        <source>The controller stopped the arm. Find the cause, wait 5 s, then unlock the protective stop.</source>
        <translation>コントローラーがアームを止めました。原因を調べ、5 秒待ってから保護停止のロックを解除してください。</translation>
    </message>
    <message>
        <source>The cell&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation>セルの非常停止が押されています。解除してから電源を入れ、ブレーキを解除してください。</translation>
    </message>
    <message>
        <source>The emergency stop button of the robot is pressed. Twist it clockwise to release it, then power on the arm and release the brakes.</source>
        <translation>ロボットの非常停止ボタンが押されています。時計回りに回して解除してから電源を入れ、ブレーキを解除してください。</translation>
    </message>
    <message>
        <source>The moulding machine&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation>成形機の非常停止が押されています。解除してから電源を入れ、ブレーキを解除してください。</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an emergency stop. Clear the request on that controller, then power on the arm and release the brakes.</source>
        <translation>PROFIsafe コントローラーが非常停止を要求しています。そちらで解除してから電源を入れ、ブレーキを解除してください。</translation>
    </message>
    <message>
        <source>The enabling button of the teach pendant is not held. Hold it in its middle position.</source>
        <translation>ペンダントのイネーブルスイッチが握られていません。中間位置で握ってください。</translation>
    </message>
</context>
<context>
    <name>OutputGripper</name>
    <message>
        <source>The robot did not confirm the outputs. Another program or the installation may control them.</source>
        <translation>ロボットが出力を確認しませんでした。別のプログラムかインストールが使っている可能性があります。</translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation>グリッパー：閉じる</translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation>グリッパー：開く</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>保留中…</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>open requested</source>
        <translation>開指令中</translation>
    </message>
    <message>
        <source>close requested</source>
        <translation>閉指令中</translation>
    </message>
    <message>
        <source>both outputs off</source>
        <translation>両出力オフ</translation>
    </message>
    <message>
        <source>both outputs on</source>
        <translation>両出力オン</translation>
    </message>
    <message>
        <source>Choose different outputs for closing and opening.</source>
        <translation>異なる二つの出力を選んでください：一方が閉じ、他方が開きます。</translation>
    </message>
</context>
<context>
    <name>PanelActions</name>
    <message>
        <source>Record</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Records the robot data to a file until you stop the recording.</source>
        <translation>停止するまで、ロボットのデータをファイルに記録します。</translation>
    </message>
    <message>
        <source>A recording is already running.</source>
        <translation>すでに記録中です。</translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation>先にロボットに接続してください。</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>記録を停止</translation>
    </message>
    <message>
        <source>Stops the recording and completes its file.</source>
        <translation>記録を停止し、ファイルを完成させます。</translation>
    </message>
    <message>
        <source>No recording is running.</source>
        <translation>記録は実行されていません。</translation>
    </message>
    <message>
        <source>Pause or resume the plots</source>
        <translation>グラフを一時停止／再開</translation>
    </message>
    <message>
        <source>Freezes the plots while data and recording continue. Press again to return to the newest samples.</source>
        <translation>グラフを止めます。データと記録は続きます。もう一度押すと最新のサンプルに戻ります。</translation>
    </message>
    <message>
        <source>Export the plots…</source>
        <translation>グラフをエクスポート…</translation>
    </message>
    <message>
        <source>Saves the visible range as an image, PDF page or table of values.</source>
        <translation>表示範囲を画像、PDF ページ、または値の表として保存します。</translation>
    </message>
    <message>
        <source>Plots: last %1</source>
        <translation>グラフ：直近 %1</translation>
    </message>
    <message>
        <source>Sets the time range of the plots.</source>
        <translation>グラフの時間範囲を設定します。</translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation>入出力を検索</translation>
    </message>
    <message>
        <source>Finds a terminal or a register by its number or name.</source>
        <translation>番号か名前で端子やレジスターを探します。</translation>
    </message>
    <message>
        <source>Rename selected input or output</source>
        <translation>選んだ入出力の名前を変更</translation>
    </message>
    <message>
        <source>Renames the input or output in the selected row of the I/O tab.</source>
        <translation>I/O タブで選択した行の入出力の名前を変更します。</translation>
    </message>
    <message>
        <source>Switch selected output</source>
        <translation>選んだ出力を切り替え</translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on or off.</source>
        <translation>I/O タブで選択した出力をオンまたはオフにします。</translation>
    </message>
    <message>
        <source>Pulse selected output</source>
        <translation>選んだ出力をパルス</translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on for 0.5 s, then off.</source>
        <translation>I/O タブで選択した出力を 0.5 秒オンにし、その後オフにします。</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>ログを検索</translation>
    </message>
    <message>
        <source>Shows only entries that contain the search text.</source>
        <translation>検索語を含む項目だけを表示します。</translation>
    </message>
    <message>
        <source>Log: show all</source>
        <translation>ログ：すべて表示</translation>
    </message>
    <message>
        <source>Log: show warnings and errors</source>
        <translation>ログ：警告とエラーを表示</translation>
    </message>
    <message>
        <source>Log: show errors only</source>
        <translation>ログ：エラーを表示</translation>
    </message>
    <message>
        <source>Selects which log entries are shown.</source>
        <translation>表示するログ項目を選びます。</translation>
    </message>
    <message>
        <source>Copy the log</source>
        <translation>ログをコピー</translation>
    </message>
    <message>
        <source>Copies the selected entries. If no entry is selected, copies all visible entries.</source>
        <translation>選択した行、または表示中の全行をコピーします。</translation>
    </message>
    <message>
        <source>Export the log…</source>
        <translation>ログをエクスポート…</translation>
    </message>
    <message>
        <source>Writes the visible entries to a file.</source>
        <translation>表示中の項目をファイルに書き出します。</translation>
    </message>
    <message>
        <source>Search plot signals</source>
        <translation>グラフの信号を検索</translation>
    </message>
    <message>
        <source>Opens the list of all signals. To add a signal to a plot, drag it, double-click it or press Return.</source>
        <translation>全信号の一覧を開きます。ドラッグ、ダブルクリック、または Return でグラフに追加します。</translation>
    </message>
    <message>
        <source>New plot page</source>
        <translation>新しいグラフページ</translation>
    </message>
    <message>
        <source>Adds an empty page at the end. All pages share the time axis.</source>
        <translation>空のページを最後に追加します。全ページの時間軸は共通です。</translation>
    </message>
    <message>
        <source>Show the entire history</source>
        <translation>全履歴を表示</translation>
    </message>
    <message>
        <source>Shows all data in memory and scales each plot automatically.</source>
        <translation>メモリーにある全データを表示し、各グラフの目盛りを自動調整します。</translation>
    </message>
    <message>
        <source>Add note…</source>
        <translation>メモを追加…</translation>
    </message>
    <message>
        <source>Adds a note at the selected cursor if it is visible, otherwise at the end of the plots.</source>
        <translation>選択したカーソルが表示されていればその位置に、そうでなければプロットの末尾にメモを追加します。</translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation>%1 の表示／非表示</translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation>%1 を切り離す</translation>
    </message>
    <message>
        <source>Moves the panel to a separate window, e.g. on a second screen, or back to the main window.</source>
        <translation>第二画面用に独立したウィンドウにする、または戻します。</translation>
    </message>
    <message>
        <source>Moves the panel to this side of the main window.</source>
        <translation>パネルをメインウィンドウのこの側へ移動します。</translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation>標準のグラフを表示</translation>
    </message>
    <message>
        <source>Replaces the pages of live data with the standard page. Pages with recordings are kept.</source>
        <translation>ライブデータのページを標準ページに置き換えます。記録のページは残ります。</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>記録を開く…</translation>
    </message>
    <message>
        <source>Shows a recording or a table of another program on its own page.</source>
        <translation>記録または他のプログラムの表を専用のページに表示します。</translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation>記録を閉じる</translation>
    </message>
    <message>
        <source>Removes all opened recordings from the plots. The files are kept.</source>
        <translation>開いている記録をすべてグラフから取り除きます。ファイルは残ります。</translation>
    </message>
    <message>
        <source>No recording is open.</source>
        <translation>記録は開かれていません。</translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation>アームのモデルと比較…</translation>
    </message>
    <message>
        <source>Compares the displayed recording with the model of its arm.</source>
        <translation>表示中の記録をそのアームのモデルと比較します。</translation>
    </message>
    <message>
        <source>Show the page of a recording first.</source>
        <translation>まず記録のページを表示してください。</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>カーソルの値</translation>
    </message>
    <message>
        <source>Shows or hides the table of values at the cursors and between them.</source>
        <translation>カーソルの位置とその間の値の表を表示または非表示にします。</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>スペクトルとXY</translation>
    </message>
    <message>
        <source>Shows or hides the spectrum and the XY plot of two signals.</source>
        <translation>スペクトルと2つの信号のXYグラフを表示または非表示にします。</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 を左へ移動</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 を右へ移動</translation>
    </message>
    <message>
        <source>%1 to the top</source>
        <translation>%1 を上へ移動</translation>
    </message>
    <message>
        <source>%1 to the bottom</source>
        <translation>%1 を下へ移動</translation>
    </message>
    <message>
        <source>Plots: start or stop playback</source>
        <translation>グラフ：再生を開始または停止</translation>
    </message>
    <message>
        <source>Moves cursor A in real time through the recording or the paused plots. The Layout menu contains other speeds.</source>
        <translation>カーソル A を記録または一時停止中のプロットの中で実時間で動かします。「配置」メニューで他の速度を選べます。</translation>
    </message>
</context>
<context>
    <name>PlotMenu</name>
    <message>
        <source>Remove lane %1</source>
        <translation>レーン %1 を削除</translation>
    </message>
    <message>
        <source>Add note here…</source>
        <translation>ここにメモを追加…</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 を表示</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 を隠す</translation>
    </message>
    <message>
        <source>Show values of %1 at the cursors</source>
        <translation>カーソル位置の %1 の値を表示</translation>
    </message>
    <message>
        <source>Move %1 to a separate plot</source>
        <translation>%1 を独立したグラフへ</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 を削除</translation>
    </message>
    <message>
        <source>Warn when %1</source>
        <translation>%1 のとき警告</translation>
    </message>
    <message>
        <source>Do not warn when %1</source>
        <translation>%1 のとき警告しない</translation>
    </message>
    <message>
        <source>Rate of change of %1</source>
        <translation>%1 の変化率</translation>
    </message>
    <message>
        <source>Moving mean of %1 over 0.5 s</source>
        <translation>%1 の 0.5 秒移動平均</translation>
    </message>
    <message>
        <source>Mean %1</source>
        <translation>平均 %1</translation>
    </message>
    <message>
        <source>Norm of the curves in this plot</source>
        <translation>このグラフの曲線のノルム</translation>
    </message>
    <message>
        <source>New plot below</source>
        <translation>下に新しいグラフ</translation>
    </message>
    <message>
        <source>New plot to the right</source>
        <translation>右に新しいグラフ</translation>
    </message>
    <message>
        <source>Remove this plot</source>
        <translation>このグラフを削除</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>すべて表示</translation>
    </message>
    <message>
        <source>Low-pass filter of %1 at 10 Hz</source>
        <translation>%1 の 10 Hz ローパスフィルター</translation>
    </message>
    <message>
        <source>Filtered %1</source>
        <translation>フィルター後の %1</translation>
    </message>
    <message>
        <source>Left axis</source>
        <translation>左の軸</translation>
    </message>
    <message>
        <source>Right axis</source>
        <translation>右の軸</translation>
    </message>
    <message>
        <source>Edit %1…</source>
        <translation>%1 を編集…</translation>
    </message>
    <message>
        <source>Axis limits…</source>
        <translation>軸の範囲…</translation>
    </message>
    <message>
        <source>Scale to curves</source>
        <translation>曲線に合わせる</translation>
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
        <translation>保護停止を待っています。</translation>
    </message>
    <message>
        <source>The arm is in a protective stop. Press “Recover…” in the header.</source>
        <translation>アームは保護停止中です。ヘッダーの「復旧」を押してください。</translation>
    </message>
    <message>
        <source>Unlocked. The arm is not running yet: follow the steps on the recovery page.</source>
        <translation>ロック解除済み。アームはまだ稼働していません：復旧ページの手順に従ってください。</translation>
    </message>
    <message>
        <source>Unlocked. Take control again.</source>
        <translation>ロック解除済み。もう一度制御を取得してください。</translation>
    </message>
    <message>
        <source>The arm is running and under your control again.</source>
        <translation>アームは稼働し、再び制御下にあります。</translation>
    </message>
    <message>
        <source>No new frame yet. Use “3 points” in the Frames tab.</source>
        <translation>新しい座標系はまだありません。座標系タブの「3 点」を使ってください。</translation>
    </message>
    <message>
        <source>“%1” meets the requirements.</source>
        <translation>「%1」は条件を満たしています。</translation>
    </message>
    <message>
        <source>The Z axis of “%1” differs from the base Z axis by %2°. The third point must be on the +Y side.</source>
        <translation>「%1」の Z 軸はベースの Z 軸から %2° ずれています。3 点目は +Y 側です。</translation>
    </message>
    <message>
        <source>The X axis of “%1” differs from the base Y axis by %2°.</source>
        <translation>「%1」の X 軸はベースの Y 軸から %2° ずれています。</translation>
    </message>
    <message>
        <source>“%1” was not taught with the arm: the TCP was never at its origin.</source>
        <translation>「%1」はアームで教示されていません：TCP が原点に位置したことがありません。</translation>
    </message>
    <message>
        <source>The waypoint was deleted. Press “Start” to add a new waypoint.</source>
        <translation>ウェイポイントは削除されました。「開始」を押すと新しく追加します。</translation>
    </message>
    <message>
        <source>“%1” has not changed. The arm is %2 away from the waypoint along X.</source>
        <translation>「%1」は元の位置です。アームは X に沿って %2 離れています。</translation>
    </message>
    <message>
        <source>“%1” has moved by %2 and is %3 from the expected position.</source>
        <translation>「%1」は %2 動き、期待される位置から %3 離れています。</translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the tool orientation changed.</source>
        <translation>「%1」は期待される位置にありますが、ツールの向きが変わりました。</translation>
    </message>
    <message>
        <source>“%1” matches the part again.</source>
        <translation>「%1」は再び部品の位置と一致しています。</translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the arm is not. Touch up the waypoint with the arm at the part.</source>
        <translation>「%1」は期待される位置にありますが、アームは違います。アームを部品の位置に動かして修正教示してください。</translation>
    </message>
    <message>
        <source>Slowed down to %1. Continue.</source>
        <translation>%1 まで減速しました。続けてください。</translation>
    </message>
    <message>
        <source>No limit reached yet. The line below the pad will show the limit.</source>
        <translation>まだ限界に達していません。パッドの下の行に限界が表示されます。</translation>
    </message>
    <message>
        <source>Limit reached. Now jog back: %1 of %2.</source>
        <translation>限界に達しました。ジョグで戻ってください：%2 のうち %1。</translation>
    </message>
    <message>
        <source>You reached the limit and moved back.</source>
        <translation>限界に達し、そこから戻りました。</translation>
    </message>
    <message>
        <source>Recording: %1 s of %2 s.</source>
        <translation>記録中：%2 s のうち %1 s。</translation>
    </message>
    <message>
        <source>The recording is too short. Record for at least three seconds.</source>
        <translation>記録が短すぎます。3 秒以上記録してください。</translation>
    </message>
    <message>
        <source>No recording yet. Press “Record” above the plots.</source>
        <translation>まだ記録がありません。グラフの上の「記録」を押してください。</translation>
    </message>
    <message>
        <source>Recorded. Enter the force shown in the plot.</source>
        <translation>記録しました。グラフに表示された力を入力してください。</translation>
    </message>
    <message>
        <source>%1 does not match the recording. Look at the Fz curve.</source>
        <translation>%1 は記録と一致しません。Fz の曲線を見てください。</translation>
    </message>
    <message>
        <source>Correct: the force was %1.</source>
        <translation>正解：力は %1 でした。</translation>
    </message>
    <message>
        <source>Recover from a protective stop</source>
        <translation>保護停止からの復旧</translation>
    </message>
    <message>
        <source>Teach a frame</source>
        <translation>座標系の教示</translation>
    </message>
    <message>
        <source>Touch up a waypoint</source>
        <translation>ウェイポイントの修正教示</translation>
    </message>
    <message>
        <source>Find the reach limit</source>
        <translation>到達限界を見つける</translation>
    </message>
    <message>
        <source>Record and measure</source>
        <translation>記録と計測</translation>
    </message>
    <message>
        <source>Press “Start” to simulate a collision that causes a protective stop. Find out what stopped the arm, wait five seconds, unlock the arm and take control again.</source>
        <translation>「開始」を押すと、保護停止を起こす衝突をシミュレートします。アームが停止した原因を調べ、5 秒待ち、ロックを解除し、もう一度制御を取得してください。</translation>
    </message>
    <message>
        <source>Teach a frame from three points in the Frames tab. Its X axis must point along the base Y+ direction and its Z axis up: record the origin, then a point further along Y+, then a point further along X−.</source>
        <translation>座標系タブで 3 点から座標系を教示してください。X 軸はベースの Y+ 方向、Z 軸は上向きにします：原点、次に Y+ 方向の点、次に X− 方向の点を記録します。</translation>
    </message>
    <message>
        <source>Press “Start” to add a waypoint “part” at the current position of the arm. The part then moves by %1 along the base X+ direction. Jog to the part, select the waypoint and touch it up (U).</source>
        <translation>「開始」を押すと、アームの現在位置にウェイポイント「部品」を追加します。その後、部品はベースの X+ 方向に %1 動きます。そこへジョグし、ウェイポイントを選んで修正教示 (U) してください。</translation>
    </message>
    <message>
        <source>Jog outwards, away from the base, until a limit halves the speed. The line below the pad shows the limit and how to move away from it. Then jog back by %1.</source>
        <translation>限界で速度が半分になるまで、ベースから外側へジョグしてください。パッドの下の行に限界と抜け出し方が表示されます。その後 %1 戻ってください。</translation>
    </message>
    <message>
        <source>Press “Start” to simulate a hand pressing on the tool from above. Record for at least three seconds, then stop. Read the force Fz in the plots and enter the value.</source>
        <translation>「開始」を押すと、ツールを上から押す手をシミュレートします。3 秒以上記録して停止してください。グラフで力 Fz を読み取り、入力してください。</translation>
    </message>
    <message>
        <source>part</source>
        <translation>部品</translation>
    </message>
</context>
<context>
    <name>ProgramText</name>
    <message>
        <source>Maximum distance</source>
        <translation>最大距離</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>失敗にする</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>続行</translation>
    </message>
    <message>
        <source>“%1” is %2. The value must be between %3 and %4.</source>
        <translation>「%1」は %2 です。%3〜%4 にしてください。</translation>
    </message>
    <message>
        <source>The group “%1” contains no waypoints. Add waypoints to the group, or select a different group.</source>
        <translation>グループ「%1」にウェイポイントがありません。グループにウェイポイントを追加するか、別のグループを選んでください。</translation>
    </message>
    <message>
        <source>“%1” refers to an item that was deleted from the project. Select a different item.</source>
        <translation>「%1」はプロジェクトから削除された項目を参照しています。別の項目を選んでください。</translation>
    </message>
    <message>
        <source>“%1” must come directly after “%2”.</source>
        <translation>「%1」は「%2」の直後に置いてください。</translation>
    </message>
    <message>
        <source>“%1” must be inside “%2”.</source>
        <translation>「%1」は「%2」の中に置いてください。</translation>
    </message>
    <message>
        <source>Steps in “Watch in parallel” cannot move the arm. Move this step out of the section.</source>
        <translation>並列のステップはアームを動かせません。このステップを区間の外に移動してください。</translation>
    </message>
    <message>
        <source>This version of Tiller does not support the step “%1”. Update Tiller, or delete the step.</source>
        <translation>このバージョンの Tiller はステップ「%1」に対応していません。Tiller を更新するか、ステップを削除してください。</translation>
    </message>
    <message>
        <source>A program can start only at a top-level step, and not at a branch such as Else. Select a different step.</source>
        <translation>プログラムは最上位のステップからのみ開始でき、Else のような分岐からは開始できません。別のステップを選んでください。</translation>
    </message>
    <message>
        <source>The project does not contain this program. Select a different program.</source>
        <translation>プロジェクトにこのプログラムはありません。別のプログラムを選んでください。</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a %2. Use “Adapt project to this robot…” first.</source>
        <translation>プロジェクトは %1 で教示されましたが、ロボットは %2 です。先に「プロジェクトをこのロボットに合わせる…」を使ってください。</translation>
    </message>
    <message>
        <source>A program with parameters cannot be started directly. Use a “Call program” step in another program.</source>
        <translation>パラメーターのあるプログラムは直接開始できません。別のプログラムのステップから呼び出してください。</translation>
    </message>
    <message>
        <source>The program has no steps. Add steps first.</source>
        <translation>プログラムにステップがありません。先にステップを追加してください。</translation>
    </message>
    <message>
        <source>The variable “%1” has a different type elsewhere in the program. Use the same type or a different name.</source>
        <translation>変数「%1」はプログラムの別の場所で異なる型です。同じ型か別の名前を使ってください。</translation>
    </message>
    <message>
        <source>Program calls are nested too deeply. Use fewer levels of calls.</source>
        <translation>プログラムの呼び出しの入れ子が深すぎます。階層を減らしてください。</translation>
    </message>
    <message>
        <source>“%1” was taught with a different TCP than the waypoints before it. Set the active TCP, or put the step in a TCP section.</source>
        <translation>「%1」は前のウェイポイントと別の TCP で教示されました。有効な TCP を設定するか、ステップを TCP 区間に入れてください。</translation>
    </message>
    <message>
        <source>The blend radii of this move and the previous move (%1 and %2) exceed the distance of %3 between the two targets. Reduce a blend radius.</source>
        <translation>この動作と前の動作のブレンド半径 (%1 と %2) が、2 つの目標間の距離 %3 を超えています。半径を小さくしてください。</translation>
    </message>
    <message>
        <source>The expression is empty. Enter an expression.</source>
        <translation>式が空です。式を入力してください。</translation>
    </message>
    <message>
        <source>An expression must be a single line.</source>
        <translation>式は 1 行にしてください。</translation>
    </message>
    <message>
        <source>“%1” is not a valid variable name. Use letters, digits and underscores, and do not start with a digit.</source>
        <translation>「%1」は有効な変数名ではありません。英数字とアンダースコアを使い、数字で始めないでください。</translation>
    </message>
    <message>
        <source>The name “%1” is reserved. Use a different name.</source>
        <translation>名前「%1」は予約されています。別の名前を使ってください。</translation>
    </message>
    <message>
        <source>The arm comes too close to itself.</source>
        <translation>アームが自身に近づきすぎます。</translation>
    </message>
    <message>
        <source>The arm comes too close to “%1”.</source>
        <translation>アームが「%1」に近づきすぎます。</translation>
    </message>
    <message>
        <source>The arm comes too close to the floor.</source>
        <translation>アームが床に近づきすぎます。</translation>
    </message>
    <message>
        <source>The step failed and ended the program.</source>
        <translation>ステップが失敗し、プログラムが終了しました。</translation>
    </message>
    <message>
        <source>The program did not end within %1 s.</source>
        <translation>プログラムは %1 s 以内に終了しませんでした。</translation>
    </message>
    <message>
        <source>The preview was cancelled.</source>
        <translation>プレビューは取り消されました。</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>入出力</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>待機</translation>
    </message>
    <message>
        <source>Tool and speed</source>
        <translation>ツールと速度</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>制御</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>オペレーター</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>構造</translation>
    </message>
    <message>
        <source>Set variable</source>
        <translation>変数を設定</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>型</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>True or false</source>
        <translation>真または偽</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>テキスト</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>姿勢</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Call program</source>
        <translation>プログラムを呼び出す</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>Parameter values</source>
        <translation>パラメーター値</translation>
    </message>
    <message>
        <source>The program “%1” requires %2 comma-separated values, but the step passes %3.</source>
        <translation>プログラム「%1」にはコンマ区切りの値が %2 個必要ですが、ステップが渡すのは %3 個です。</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>ケース</translation>
    </message>
    <message>
        <source>“Default” must be the last branch of a Switch.</source>
        <translation>既定は分岐の最後に置いてください。</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>コメント</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>既定</translation>
    </message>
    <message>
        <source>Else if</source>
        <translation>それ以外で条件</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Else</source>
        <translation>それ以外</translation>
    </message>
    <message>
        <source>End program</source>
        <translation>プログラムを終了</translation>
    </message>
    <message>
        <source>The program failed.</source>
        <translation>プログラムが失敗しました。</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>For each pattern cell</source>
        <translation>パターンの各セル</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>For each waypoint</source>
        <translation>各ウェイポイント</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>グループ</translation>
    </message>
    <message>
        <source>Force section</source>
        <translation>力区間</translation>
    </message>
    <message>
        <source>Reference frame</source>
        <translation>基準座標系</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>ベース</translation>
    </message>
    <message>
        <source>Section frame</source>
        <translation>区間の座標系</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>速度制限</translation>
    </message>
    <message>
        <source>Frame section</source>
        <translation>座標系区間</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>座標系</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>グリッパー</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation>閉じる出力</translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation>開く出力</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Input to check</source>
        <translation>入力を確認</translation>
    </message>
    <message>
        <source>If the input is off</source>
        <translation>入力がオフの場合</translation>
    </message>
    <message>
        <source>Select different outputs for opening and closing.</source>
        <translation>開と閉には別々の出力を選んでください。</translation>
    </message>
    <message>
        <source>The gripper is not holding an object.</source>
        <translation>グリッパーが物体を保持していません。</translation>
    </message>
    <message>
        <source>If</source>
        <translation>条件分岐</translation>
    </message>
    <message>
        <source>Exit loop</source>
        <translation>ループを抜ける</translation>
    </message>
    <message>
        <source>“Exit loop” must be inside a loop.</source>
        <translation>ループを抜けるステップはループの中に置いてください。</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>ループ</translation>
    </message>
    <message>
        <source>Repetitions (0: endless)</source>
        <translation>繰り返し回数（0：無限）</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>カウンター</translation>
    </message>
    <message>
        <source>This loop may never end and contains no delay. Add a Wait step.</source>
        <translation>このループは終わらない可能性があり、待ち時間がありません。「待機」ステップを追加してください。</translation>
    </message>
    <message>
        <source>A loop can have 1 to %1 positions; this loop has %2.</source>
        <translation>ループの位置は 1〜%1 個です。現在 %2 個です。</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Wait for the operator</source>
        <translation>オペレーターを待つ</translation>
    </message>
    <message>
        <source>MoveC</source>
        <translation>MoveC</translation>
    </message>
    <message>
        <source>Via</source>
        <translation>経由</translation>
    </message>
    <message>
        <source>To</source>
        <translation>終点</translation>
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
        <translation>ブレンド</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>姿勢</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Fixed to arc</source>
        <translation>円弧に固定</translation>
    </message>
    <message>
        <source>Move through a group</source>
        <translation>グループを通る</translation>
    </message>
    <message>
        <source>Run waypoint actions</source>
        <translation>ウェイポイントの動作を実行</translation>
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
        <translation>相対移動</translation>
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
        <translation>距離がゼロです。X、Y または Z の値を入力してください。</translation>
    </message>
    <message>
        <source>The waypoint “%1” moves the gripper. In a program, use the Gripper step and turn off “Run waypoint actions”.</source>
        <translation>ウェイポイント「%1」はグリッパーを動かします。プログラムでは「グリッパー」ステップを使い、「ウェイポイントの動作を実行」をオフにしてください。</translation>
    </message>
    <message>
        <source>Waypoint</source>
        <translation>ウェイポイント</translation>
    </message>
    <message>
        <source>Approach distance</source>
        <translation>アプローチ距離</translation>
    </message>
    <message>
        <source>The arm cannot reach “%1”. Change the waypoint, or select a different waypoint.</source>
        <translation>アームは「%1」に到達できません。ウェイポイントを変更するか、別のウェイポイントを選んでください。</translation>
    </message>
    <message>
        <source>Set either a waypoint or a pose, not both.</source>
        <translation>ウェイポイントか姿勢のどちらか一方を設定してください。</translation>
    </message>
    <message>
        <source>Set a waypoint or a pose.</source>
        <translation>ウェイポイントか姿勢を設定してください。</translation>
    </message>
    <message>
        <source>Move until</source>
        <translation>条件まで移動</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>終了条件</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Input is on</source>
        <translation>入力オン</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>入力</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>If not reached</source>
        <translation>到達しない場合</translation>
    </message>
    <message>
        <source>Select an input.</source>
        <translation>入力を選択してください。</translation>
    </message>
    <message>
        <source>The input did not turn on within the maximum distance. Check the sensor and its wiring.</source>
        <translation>最大距離内で入力がオンになりませんでした。センサーと配線を確認してください。</translation>
    </message>
    <message>
        <source>No contact was detected within the maximum distance.</source>
        <translation>最大距離内で接触が検出されませんでした。</translation>
    </message>
    <message>
        <source>Write to the log</source>
        <translation>ログに書く</translation>
    </message>
    <message>
        <source>On error</source>
        <translation>エラー時</translation>
    </message>
    <message>
        <source>Set payload</source>
        <translation>ペイロードを設定</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>ペイロード</translation>
    </message>
    <message>
        <source>Pulse output</source>
        <translation>出力パルス</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>On</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>質問</translation>
    </message>
    <message>
        <source>Questions require robot software 5.6 or newer.</source>
        <translation>質問にはロボットのソフトウェア 5.6 以降が必要です。</translation>
    </message>
    <message>
        <source>URScript</source>
        <translation>URScript</translation>
    </message>
    <message>
        <source>Names that begin with “tiller_” are reserved.</source>
        <translation>「tiller_」で始まる名前は予約されています。</translation>
    </message>
    <message>
        <source>Each block in the script needs an “end”.</source>
        <translation>スクリプトの各ブロックには「end」が必要です。</translation>
    </message>
    <message>
        <source>Set analog output</source>
        <translation>アナログ出力を設定</translation>
    </message>
    <message>
        <source>Set output</source>
        <translation>出力を設定</translation>
    </message>
    <message>
        <source>Set register</source>
        <translation>レジスターを設定</translation>
    </message>
    <message>
        <source>Integer</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>実数</translation>
    </message>
    <message>
        <source>Boolean</source>
        <translation>真偽値</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>レジスター</translation>
    </message>
    <message>
        <source>Programs can set registers only up to %1.</source>
        <translation>プログラムが設定できるレジスターは %1 までです。</translation>
    </message>
    <message>
        <source>Speed section</source>
        <translation>速度区間</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>分岐</translation>
    </message>
    <message>
        <source>A Switch must contain at least one Case.</source>
        <translation>分岐にはケースが少なくとも 1 つ必要です。</translation>
    </message>
    <message>
        <source>Only Case and Default can be placed directly in a Switch.</source>
        <translation>分岐の直下に置けるのはケースと既定だけです。</translation>
    </message>
    <message>
        <source>TCP section</source>
        <translation>TCP 区間</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>“Try” must be followed directly by “On error”.</source>
        <translation>「試行」の直後には「エラー時」が必要です。</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>待機</translation>
    </message>
    <message>
        <source>Wait for condition</source>
        <translation>条件を待つ</translation>
    </message>
    <message>
        <source>On timeout</source>
        <translation>タイムアウト時</translation>
    </message>
    <message>
        <source>The condition did not become true before the timeout.</source>
        <translation>条件が時間内に真になりませんでした。</translation>
    </message>
    <message>
        <source>Wait for input</source>
        <translation>入力を待つ</translation>
    </message>
    <message>
        <source>%1 did not change to the expected state before the timeout.</source>
        <translation>%1 は時間内に期待される状態になりませんでした。</translation>
    </message>
    <message>
        <source>Watch in parallel</source>
        <translation>並列監視</translation>
    </message>
    <message>
        <source>A parallel watch must be at the top level of the program.</source>
        <translation>並列監視はプログラムの最上位に置いてください。</translation>
    </message>
    <message>
        <source>While</source>
        <translation>条件が真の間</translation>
    </message>
    <message>
        <source>At %1 s: %2</source>
        <translation>%1 s 時点: %2</translation>
    </message>
    <message>
        <source>Step %1 (%2) at %3 s: %4</source>
        <translation>ステップ %1 (%2)、%3 s 時点: %4</translation>
    </message>
    <message>
        <source>“%1” must be between %2 and %3.</source>
        <translation>「%1」は %2 から %3 の範囲で指定してください。</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>ステップ %1: %2</translation>
    </message>
    <message>
        <source>The TCP of the robot differs from the TCP of the program&apos;s waypoints. Set the active TCP of the project, or use a TCP section.</source>
        <translation>ロボットの TCP がプログラムのウェイポイントの TCP と異なります。プロジェクトのアクティブな TCP を設定するか、TCP 区間を使ってください。</translation>
    </message>
    <message>
        <source>Preview the program first.</source>
        <translation>先にプログラムをプレビューしてください。</translation>
    </message>
    <message>
        <source>The preview found problems. Fix them, then preview the program again.</source>
        <translation>プレビューで問題が見つかりました。修正してから、もう一度プレビューしてください。</translation>
    </message>
    <message>
        <source>Move the arm to the start position first.</source>
        <translation>先にアームを開始位置へ移動してください。</translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation>プログラムが実行中です。先にプログラムを停止してください。</translation>
    </message>
    <message>
        <source>The program ended after %1 s.</source>
        <translation>プログラムは %1 秒後に終了しました。</translation>
    </message>
    <message>
        <source>Step %1 (%2) failed and ended the program.</source>
        <translation>ステップ %1 (%2) が失敗し、プログラムが終了しました。</translation>
    </message>
    <message>
        <source>Stopped in step %1 (%2): %3</source>
        <translation>ステップ %1 (%2) で停止: %3</translation>
    </message>
    <message>
        <source>Stopped before the first step: %1</source>
        <translation>最初のステップの前に停止: %1</translation>
    </message>
    <message>
        <source>Later steps use the variable “%1” from step %2 (%3). Start at that step or earlier.</source>
        <translation>後のステップがステップ %2 (%3) の変数「%1」を使用します。そのステップ以前から開始してください。</translation>
    </message>
    <message>
        <source>Later steps depend on step %1 (%2). Start at that step or earlier.</source>
        <translation>後のステップにはステップ %1 (%2) が必要です。そのステップ以前から開始してください。</translation>
    </message>
    <message>
        <source>The preview does not reach this step. Select a different step.</source>
        <translation>プレビューはこのステップに到達しません。別のステップを選んでください。</translation>
    </message>
    <message>
        <source>The simulated program does not complete step %1 (%2).</source>
        <translation>シミュレーションではステップ%1（%2）が完了しません。</translation>
    </message>
    <message>
        <source>The arm has left the start position of step %1 (%2).</source>
        <translation>アームがステップ%1（%2）の開始位置から離れています。</translation>
    </message>
    <message>
        <source>The gripper may hold a part and would close again (%1).</source>
        <translation>グリッパーが部品を保持している可能性があり、再び閉じます（%1）。</translation>
    </message>
    <message>
        <source>The gripper may have lost a part (%1).</source>
        <translation>グリッパーが部品を落とした可能性があります（%1）。</translation>
    </message>
    <message>
        <source>%1 would turn on again.</source>
        <translation>%1が再びオンになります。</translation>
    </message>
    <message>
        <source>%1 would have a different value.</source>
        <translation>%1の値が異なります。</translation>
    </message>
    <message>
        <source>The program would wait in step %1 (%2).</source>
        <translation>プログラムがステップ%1（%2）で待機し続けます。</translation>
    </message>
    <message>
        <source>The program would fail in step %1 (%2).</source>
        <translation>プログラムがステップ%1（%2）で失敗します。</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>チェックはキャンセルされました。</translation>
    </message>
    <message>
        <source>An analog output would have a different value.</source>
        <translation>アナログ出力の値が異なります。</translation>
    </message>
    <message>
        <source>A register would have a different value.</source>
        <translation>レジスタの値が異なります。</translation>
    </message>
    <message>
        <source>The variable “%1” would have a different value.</source>
        <translation>変数「%1」の値が変わります。</translation>
    </message>
    <message>
        <source>The TCP or the payload would differ.</source>
        <translation>TCPまたはペイロードが異なります。</translation>
    </message>
    <message>
        <source>The program would run different steps.</source>
        <translation>プログラムが別のステップを実行します。</translation>
    </message>
    <message>
        <source>The arm would end at a different position.</source>
        <translation>アームの最終位置が異なります。</translation>
    </message>
    <message>
        <source>✔ Continue</source>
        <translation>✔ 続行</translation>
    </message>
    <message>
        <source>↩ Move back</source>
        <translation>↩ 戻す</translation>
    </message>
    <message>
        <source>✖ Unsafe</source>
        <translation>✖ 安全でない</translation>
    </message>
    <message>
        <source>Simulated, after a stop in this step:</source>
        <translation>シミュレーション（このステップで停止した後）：</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>未到達</translation>
    </message>
    <message>
        <source>can continue</source>
        <translation>続行可能</translation>
    </message>
    <message>
        <source>can continue after moving back</source>
        <translation>戻した後に続行可能</translation>
    </message>
    <message>
        <source>cannot continue safely</source>
        <translation>安全に続行できません</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>保護停止</translation>
    </message>
    <message>
        <source>Stop by the operator</source>
        <translation>オペレーターによる停止</translation>
    </message>
    <message>
        <source>Connection loss</source>
        <translation>接続の切断</translation>
    </message>
    <message>
        <source>Power loss</source>
        <translation>電源喪失</translation>
    </message>
    <message>
        <source>Simulated: the program cannot continue safely. %1</source>
        <translation>シミュレーション：プログラムは安全に続行できません。%1</translation>
    </message>
    <message>
        <source>Simulated: the program can continue from step %1 (%2).</source>
        <translation>シミュレーション：プログラムはステップ%1（%2）から続行できます。</translation>
    </message>
    <message>
        <source>The stop was inside a force section, so the contact cannot be restored.</source>
        <translation>力区間内で停止したため、接触を復元できません。</translation>
    </message>
    <message>
        <source>The relative move is only partly complete.</source>
        <translation>相対移動は途中まで実行されています。</translation>
    </message>
    <message>
        <source>The URScript text was only partly executed.</source>
        <translation>URScriptテキストは途中まで実行されています。</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>重大度</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>タイムアウト</translation>
    </message>
    <message>
        <source>A program cannot continue inside a section or a called program. The next run starts from the beginning.</source>
        <translation>セクション内または呼び出されたプログラム内からは再開できません。次の実行は最初から始まります。</translation>
    </message>
    <message>
        <source>A program cannot continue in the middle of this step. The next run starts from the beginning.</source>
        <translation>このステップの途中からは再開できません。次の実行は最初から始まります。</translation>
    </message>
    <message>
        <source>paused on the robot</source>
        <translation>ロボット側で一時停止</translation>
    </message>
    <message>
        <source>the speed, acceleration or blend is not a number, or a time is set</source>
        <translation>速度、加速度またはブレンドが数値でないか、時間が指定されています</translation>
    </message>
    <message>
        <source>not imported</source>
        <translation>インポートされていません</translation>
    </message>
    <message>
        <source>%1, disabled</source>
        <translation>%1、無効</translation>
    </message>
    <message>
        <source>the program has no name</source>
        <translation>プログラムに名前がありません</translation>
    </message>
    <message>
        <source>the project already has a program &apos;%1&apos;; choose another name</source>
        <translation>プロジェクトにはすでにプログラム「%1」があります。別の名前を選択してください</translation>
    </message>
    <message>
        <source>the file is too large for a program</source>
        <translation>ファイルがプログラムとしては大きすぎます</translation>
    </message>
    <message>
        <source>the file is not text in UTF-8</source>
        <translation>ファイルがUTF-8のテキストではありません</translation>
    </message>
    <message>
        <source>this line ends a block that was not opened</source>
        <translation>この行は、開かれていないブロックを閉じています</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>%1行目：%2</translation>
    </message>
    <message>
        <source>the program contains a return</source>
        <translation>プログラムにreturnが含まれています</translation>
    </message>
    <message>
        <source>the program has too many statements</source>
        <translation>プログラムの文が多すぎます</translation>
    </message>
    <message>
        <source>the script of the steps does not compile</source>
        <translation>ステップのスクリプトをコンパイルできません</translation>
    </message>
    <message>
        <source>the program is too complex</source>
        <translation>プログラムが複雑すぎます</translation>
    </message>
    <message>
        <source>the file contains no statements</source>
        <translation>ファイルに文がありません</translation>
    </message>
    <message>
        <source>the file contains %1 functions or parameters, but no statement that calls a function; add the call</source>
        <translation>ファイルには%1個の関数またはパラメーターがありますが、関数を呼び出す文がありません。呼び出しを追加してください</translation>
    </message>
    <message>
        <source>the program contains no statements</source>
        <translation>プログラムに文がありません</translation>
    </message>
    <message>
        <source>Installation</source>
        <translation>インストール設定</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>無効</translation>
    </message>
    <message>
        <source>In this project, programs begin with the TCP of the tool &apos;%1&apos;.</source>
        <translation>このプロジェクトでは、プログラムはツール「%1」のTCPで始まります。</translation>
    </message>
    <message>
        <source>The program does not set the TCP. Its waypoints require the TCP %1.</source>
        <translation>プログラムはTCPを設定しません。そのウェイポイントにはTCP %1が必要です。</translation>
    </message>
    <message>
        <source>the TCP applies until the end of the program</source>
        <translation>TCPはプログラムの終わりまで有効です</translation>
    </message>
    <message>
        <source>the program does not call this function</source>
        <translation>プログラムはこの関数を呼び出しません</translation>
    </message>
    <message>
        <source>imported as a program</source>
        <translation>プログラムとしてインポート</translation>
    </message>
    <message>
        <source>part of a waypoint</source>
        <translation>ウェイポイントの一部</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a different model. Adapt the project to the robot first.</source>
        <translation>プロジェクトは%1で教示されましたが、ロボットは別の機種です。先にプロジェクトをロボットに合わせてください。</translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>シミュレーション：%1</translation>
    </message>
    <message>
        <source>Step %1 failed and ended the program.</source>
        <translation>ステップ%1が失敗し、プログラムが終了しました。</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>step numbers</comment>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>ステップ %1</translation>
    </message>
    <message>
        <source>steps %1</source>
        <translation>ステップ %1</translation>
    </message>
    <message>
        <source>The position of the arm is unknown because no robot data arrive. Check the connection to the robot.</source>
        <translation>ロボットのデータが届かないため、アームの位置が不明です。ロボットとの接続を確認してください。</translation>
    </message>
    <message>
        <source>It is unknown whether the program completed, because robot data were missing at its end. Check the workpiece.</source>
        <translation>終了時にロボットのデータが欠落していたため、プログラムが完了したかどうか不明です。ワークを確認してください。</translation>
    </message>
    <message>
        <source>Last known step: %1 (%2). %3</source>
        <translation>最後に確認されたステップ: %1 (%2)。%3</translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation>実行中のプログラムはありません。</translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation>プログラムはロボット側で一時停止中です。ティーチペンダントで再開してください。</translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation>先にプログラムを一時停止してください。</translation>
    </message>
    <message>
        <source>Wait until the robot has confirmed the new value of “%1”.</source>
        <translation>ロボットが「%1」の新しい値を確認するまで待ってください。</translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation>「%1」は数値ではありません。数値を入力してください。</translation>
    </message>
    <message>
        <source>“%1” is not a whole number. Enter a number without decimals.</source>
        <translation>「%1」は整数ではありません。小数のない数値を入力してください。</translation>
    </message>
    <message>
        <source>“%1” is not True or False. Enter one of these values.</source>
        <translation>「%1」は True または False ではありません。どちらかの値を入力してください。</translation>
    </message>
    <message>
        <source>List</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>行列</translation>
    </message>
    <message>
        <source>A URScript step in this program could move the arm after a change.</source>
        <translation>このプログラムの URScript ステップが、変更後にアームを動かす可能性があります。</translation>
    </message>
    <message>
        <source>Only numbers and True or False values can be changed.</source>
        <translation>変更できるのは数値と True または False の値だけです。</translation>
    </message>
    <message>
        <source>The program has no variable “%1”.</source>
        <translation>プログラムに変数「%1」はありません。</translation>
    </message>
    <message>
        <source>Variable “%1”: %2 → %3</source>
        <translation>変数「%1」: %2 → %3</translation>
    </message>
    <message>
        <source>The robot did not confirm the new value of “%1”. Check the value in the list.</source>
        <translation>ロボットは「%1」の新しい値を確認しませんでした。リストの値を確認してください。</translation>
    </message>
    <message>
        <source>The robot does not report its variables. Wait until the connection is restored.</source>
        <translation>ロボットが変数を送信していません。接続が復旧するまでお待ちください。</translation>
    </message>
    <message>
        <source>The recoverability check did not reach step %1 (%2). Check again with the inputs of the run to find out whether the program can continue.</source>
        <translation>続行可能性のチェックはステップ %1 (%2) に到達しませんでした。プログラムを続行できるかどうか、実行時の入力でもう一度チェックしてください。</translation>
    </message>
    <message>
        <source>This variable is set by URScript text. Only variables of a “Set variable” step can be changed.</source>
        <translation>この変数は URScript テキストで設定されています。変更できるのは「変数を設定」ステップの変数だけです。</translation>
    </message>
    <message>
        <source>“%1” is not set. Select or enter a value.</source>
        <translation>「%1」が設定されていません。値を選択または入力してください。</translation>
    </message>
    <message>
        <source>“%1” has an invalid value. Enter a different value.</source>
        <translation>「%1」の値が無効です。別の値を入力してください。</translation>
    </message>
    <message>
        <source>“%1” cannot contain steps. Move its steps to another section.</source>
        <translation>「%1」にはステップを入れられません。ステップを別のセクションに移動してください。</translation>
    </message>
    <message>
        <source>A program cannot call itself. Select a different program.</source>
        <translation>プログラムは自分自身を呼び出せません。別のプログラムを選択してください。</translation>
    </message>
    <message>
        <source>Unexpected character “%1”. Remove this character.</source>
        <translation>予期しない文字「%1」です。この文字を削除してください。</translation>
    </message>
    <message>
        <source>“%1” cannot be part of an expression. Remove this word.</source>
        <translation>「%1」は式に使えません。この語を削除してください。</translation>
    </message>
    <message>
        <source>The brackets do not match. Add or remove a bracket.</source>
        <translation>括弧が対応していません。括弧を追加または削除してください。</translation>
    </message>
    <message>
        <source>a Message step cannot have this title</source>
        <translation>メッセージのステップにこのタイトルは使えません</translation>
    </message>
    <message>
        <source>the payload is not given as numbers in the permitted range</source>
        <translation>ペイロードが許容範囲内の数値で指定されていません</translation>
    </message>
    <message>
        <source>the target cannot be stored as a waypoint or as the pose of a step</source>
        <translation>目標をウェイポイントにもステップの姿勢にもできません</translation>
    </message>
    <message>
        <source>the External Control node runs a script from another computer, which cannot be imported. Remove this node from the program.</source>
        <translation>External Controlノードは別のコンピューターのスクリプトを実行するため、インポートできません。このノードをプログラムから削除してください。</translation>
    </message>
    <message>
        <source>the blocks are nested too deeply</source>
        <translation>ブロックの入れ子が深すぎます</translation>
    </message>
    <message>
        <source>a block extends beyond its node</source>
        <translation>ブロックがノードの範囲を超えています</translation>
    </message>
    <message>
        <source>the line contains several statements</source>
        <translation>1行に複数の文があります</translation>
    </message>
    <message>
        <source>the block that begins on line %1 has no end</source>
        <translation>%1行目で始まるブロックに終わりがありません</translation>
    </message>
    <message>
        <source>no step corresponds to this statement</source>
        <translation>この文を生成するステップはありません</translation>
    </message>
    <message>
        <source>The program uses output integer register 46 or 47, to which Tiller writes the number of the running step. Use different registers.</source>
        <translation>プログラムは整数出力レジスター46または47を使用していますが、Tillerはそこに実行中のステップの番号を書き込みます。別のレジスターを使用してください。</translation>
    </message>
    <message>
        <source>a disabled node in a section that is imported as URScript text</source>
        <translation>テキストになった部分の無効なノード</translation>
    </message>
    <message>
        <source>the condition cannot be used in a step</source>
        <translation>条件をステップの条件にできません</translation>
    </message>
    <message>
        <source>no step corresponds to a thread, or to a function with parameters or a result</source>
        <translation>引数や戻り値のある関数とスレッドに対応するステップはありません</translation>
    </message>
    <message>
        <source>the type or the scope of the variable cannot be determined</source>
        <translation>変数の型またはスコープを特定できません</translation>
    </message>
    <message>
        <source>%1. Save the program on the teach pendant and copy its .script file to the same folder, or change the program.</source>
        <translation>%1。ティーチペンダントでプログラムを保存し、その.scriptファイルを同じフォルダーにコピーするか、プログラムを変更してください。</translation>
    </message>
    <message>
        <source>The nodes cannot be imported: %1. The script saved by the teach pendant was imported instead.</source>
        <translation>ノードを変換できません：%1。代わりに、ティーチペンダントが保存したスクリプトをインポートしました。</translation>
    </message>
    <message>
        <source>%1. Complete the program on the teach pendant first.</source>
        <translation>%1。先にティーチペンダントでプログラムを完成させてください。</translation>
    </message>
    <message>
        <source>ended on the robot (teach pendant, another client or halt)</source>
        <translation>ロボット側で終了（ティーチペンダント、別のクライアントまたは halt）</translation>
    </message>
    <message>
        <source>a program from another client has taken over</source>
        <translation>別のクライアントのプログラムがロボットを制御しています</translation>
    </message>
    <message>
        <source>The values of a program from another client cannot be changed.</source>
        <translation>他のクライアントのプログラムの値は変更できません。</translation>
    </message>
    <message>
        <source>the statement is nested too deeply</source>
        <translation>入れ子が深すぎます</translation>
    </message>
    <message>
        <source>The program cannot pause before this step. Select a different step.</source>
        <translation>このステップの前では一時停止できません。別のステップを選択してください。</translation>
    </message>
    <message>
        <source>The move is only partly complete.</source>
        <translation>移動は途中までしか実行されていません。</translation>
    </message>
</context>
<context>
    <name>ProjectLock</name>
    <message>
        <source>%1 on %2</source>
        <translation>%2の%1</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>プロセス %1</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>別のプログラム</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>No robot connected. Choose a robot at the top left.</source>
        <translation>ロボット未接続。左上で選んでください。</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>接続中…</translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically.</source>
        <translation>ロボットからのデータなし。自動で再接続します。</translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation>ロボットのデータが遅れています。新しいデータを待っています。</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>制御を取得中…</translation>
    </message>
    <message>
        <source>Not in control. Press “Take control” in the header.</source>
        <translation>制御なし。ヘッダーの「制御を取得」を押してください。</translation>
    </message>
    <message>
        <source>Robot data are out of date. Wait for new data.</source>
        <translation>ロボットのデータが古いです。届くまで待ってください。</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>ロボット未接続。接続するか、シミュレーターを試してください。</translation>
    </message>
    <message>
        <source>The arm is moving. Stop the arm first, then store the position.</source>
        <translation>アームが動作中です。先にアームを停止してから、位置を保存してください。</translation>
    </message>
</context>
<context>
    <name>RecordingChoice</name>
    <message>
        <source>A file name must not be empty or begin with a period.</source>
        <translation>ファイル名は空にできず、ピリオドで始めることもできません。</translation>
    </message>
    <message>
        <source>A file name cannot contain “%1”.</source>
        <translation>ファイル名に「%1」は使えません。</translation>
    </message>
    <message>
        <source>This name is too long.</source>
        <translation>この名前は長すぎます。</translation>
    </message>
    <message>
        <source>Not a condition: “%1”. Examples: actual_TCP_force_2 &gt; 20, robot_mode = 7, actual_digital_input_bits:3 = 1, runtime_state changes.</source>
        <translation>「%1」は条件ではありません。例: actual_TCP_force_2 &gt; 20、robot_mode = 7、actual_digital_input_bits:3 = 1、runtime_state changes</translation>
    </message>
    <message>
        <source>There is no signal “%1”. Vectors have one signal per number, such as actual_q_0.</source>
        <translation>信号「%1」はありません。ベクトルには数値ごとに信号があります（例: actual_q_0）。</translation>
    </message>
</context>
<context>
    <name>RecoveryGuide</name>
    <message>
        <source>Safety mode is Normal again</source>
        <translation>安全モードが「通常」に戻りました</translation>
    </message>
    <message>
        <source>The arm can be moved. Motions interrupted by the stop do not resume. Press the button again for each motion.</source>
        <translation>アームを動かせます。停止前の動作は再開しません：動作ごとに新しく押す必要があります。</translation>
    </message>
    <message>
        <source>The arm is ready. Take control to move the arm, or continue on the teach pendant.</source>
        <translation>アームは準備完了です。動かすには制御を取得するか、ティーチペンダントで続けてください。</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>制御を取得中…</translation>
    </message>
    <message>
        <source>No data from the robot</source>
        <translation>ロボットからのデータなし</translation>
    </message>
    <message>
        <source>Waiting for the connection…</source>
        <translation>接続を待っています…</translation>
    </message>
    <message>
        <source>I have inspected the arm. No one is touching it, and nothing is trapped.</source>
        <translation>アームを点検した。誰も触れておらず、何も挟まっていない。</translation>
    </message>
    <message>
        <source>The cause of the stop is known and has been removed.</source>
        <translation>停止の原因が分かり、取り除いた。</translation>
    </message>
    <message>
        <source>Payload and TCP match the mounted tool.</source>
        <translation>ペイロードと TCP は取り付けたツールと一致している。</translation>
    </message>
    <message>
        <source>Unlocking is available in %1 s</source>
        <translation>あと %1 s で解除可能</translation>
    </message>
    <message>
        <source>I have inspected the arm and the robot&apos;s log, and I know the cause.</source>
        <translation>アームとロボットのログを確認し、原因を把握した。</translation>
    </message>
    <message>
        <source>The cause has been removed, and no one is within reach of the arm.</source>
        <translation>原因を取り除き、アームの届く範囲に誰もいない。</translation>
    </message>
    <message>
        <source>No action is needed in Tiller. This state ends when the cause is removed.</source>
        <translation>Tiller での操作は不要です。原因が取り除かれると、この状態は終わります。</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>ロック解除</translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation>安全を再起動</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>電源オン</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>ブレーキ解除</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>制御を取得</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>Replay</name>
    <message>
        <source>REPLAY</source>
        <translation>再生中</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>データなし</translation>
    </message>
    <message>
        <source>history at %1 s</source>
        <translation>履歴の%1 s</translation>
    </message>
    <message>
        <source>at %1 s in %2</source>
        <translation>%2 の %1 s</translation>
    </message>
</context>
<context>
    <name>RetracePath</name>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation>たどれる軌跡がありません。まずアームをジョグしてください。</translation>
    </message>
</context>
<context>
    <name>RobotActions</name>
    <message>
        <source>Connect to a robot first.</source>
        <translation>先にロボットに接続してください。</translation>
    </message>
    <message>
        <source>Give control back first.</source>
        <translation>先に制御を返却してください。</translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation>ロボットでプログラムは動いていません。</translation>
    </message>
    <message>
        <source>A program is already running.</source>
        <translation>すでにプログラムが実行中です。</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>接続…</translation>
    </message>
    <message>
        <source>Select the simulator, a robot or a project.</source>
        <translation>シミュレーター、ロボット、プロジェクトを選びます。</translation>
    </message>
    <message>
        <source>Simulated robot</source>
        <translation>シミュレートされたロボット</translation>
    </message>
    <message>
        <source>Starts the simulated robot and connects to it.</source>
        <translation>シミュレートされたロボットを起動して接続します。</translation>
    </message>
    <message>
        <source>Check the connection…</source>
        <translation>接続を確認…</translation>
    </message>
    <message>
        <source>Select a robot first.</source>
        <translation>先にロボットを選んでください。</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>切断</translation>
    </message>
    <message>
        <source>Stops Tiller&apos;s motion, then closes the connection.</source>
        <translation>Tiller による動作を止めてから接続を閉じます。</translation>
    </message>
    <message>
        <source>No robot is connected.</source>
        <translation>ロボットは接続されていません。</translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation>アームの電源を入れます。ブレーキはかかったままです。</translation>
    </message>
    <message>
        <source>The arm is powered on or powering on.</source>
        <translation>アームの電源は入っているか、投入中です。</translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation>アームが数ミリ下がることがあります。離れてください。</translation>
    </message>
    <message>
        <source>Stops programs, engages the brakes and powers the arm off.</source>
        <translation>プログラムを停止し、ブレーキをかけ、アームの電源を切ります。</translation>
    </message>
    <message>
        <source>The arm is powered off.</source>
        <translation>アームの電源はオフです。</translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation>復旧…</translation>
    </message>
    <message>
        <source>Shows the cause of the stop and the recovery steps.</source>
        <translation>アームを停止させた原因と復旧の手順を表示します。</translation>
    </message>
    <message>
        <source>The safety system reports no stop.</source>
        <translation>安全システムは停止を報告していません。</translation>
    </message>
    <message>
        <source>Resets the safety system after a violation or fault. The arm stays powered off.</source>
        <translation>違反や故障の後、安全システムをリセットします。アームの電源は切れたままです。</translation>
    </message>
    <message>
        <source>Available only after a safety violation or fault.</source>
        <translation>安全違反または安全上の故障の後にのみ実行できます。</translation>
    </message>
    <message>
        <source>Closes the popups on the teach pendant.</source>
        <translation>ティーチペンダントのポップアップを閉じます。</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>制御を取得</translation>
    </message>
    <message>
        <source>Already in control.</source>
        <translation>すでに制御中です。</translation>
    </message>
    <message>
        <source>Give control back</source>
        <translation>制御を返却</translation>
    </message>
    <message>
        <source>Ends the control program on the robot.</source>
        <translation>ロボットの制御プログラムを終えます。</translation>
    </message>
    <message>
        <source>Not in control.</source>
        <translation>制御していません。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Software stop of all motion. Not an emergency stop.</source>
        <translation>すべての動作のソフトウェア停止。非常停止ではありません。</translation>
    </message>
    <message>
        <source>Load program…</source>
        <translation>プログラムを読み込む…</translation>
    </message>
    <message>
        <source>Loads a program on the robot by name.</source>
        <translation>ロボット上のプログラムを名前で読み込みます。</translation>
    </message>
    <message>
        <source>Starts the loaded program or resumes the paused program. The arm may move immediately.</source>
        <translation>読み込んだプログラムを開始、または一時停止中のプログラムを再開します：アームがすぐに動くことがあります。</translation>
    </message>
    <message>
        <source>Pauses the running program.</source>
        <translation>実行中のプログラムを一時停止します。</translation>
    </message>
    <message>
        <source>Stops the program on the robot.</source>
        <translation>ロボットのプログラムを停止します。</translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation>ロボットで制御プログラムを開始します。別のプログラムを停止する前に確認します。</translation>
    </message>
    <message>
        <source>Checks the connection between this PC and the robot and suggests fixes.</source>
        <translation>この PC とロボットの接続を調べ、対処を示します。</translation>
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
        <translation>出力 %1：%2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>%1: on</source>
        <translation>%1：オン</translation>
    </message>
    <message>
        <source>%1: off</source>
        <translation>%1：オフ</translation>
    </message>
    <message>
        <source>Analog output %1: %2 %3</source>
        <translation>アナログ出力 %1：%2 %3</translation>
    </message>
    <message>
        <source>Input int register %1</source>
        <translation>整数入力レジスター %1</translation>
    </message>
    <message>
        <source>Speed slider: %1 %</source>
        <translation>速度スライダー：%1 %</translation>
    </message>
    <message>
        <source>%1: on for %2 s</source>
        <translation>%1：%2 s間オン</translation>
    </message>
    <message>
        <source>%1: off for %2 s</source>
        <translation>%1：%2 s間オフ</translation>
    </message>
    <message>
        <source>The robot times pulses only while Tiller is in control. Take control first, or switch the output on and off manually.</source>
        <translation>ロボットがパルスの時間を計測するのは、Tiller が制御しているときだけです。先に制御を取得するか、出力を手動でオン・オフしてください。</translation>
    </message>
    <message>
        <source>The robot did not end the pulse on %1 because the program on the robot was stopped or paused. Tiller switches the output off.</source>
        <translation>プログラムが停止または一時停止されたため、ロボットは%1のパルスを終了しませんでした。Tillerが出力をオフにします。</translation>
    </message>
    <message>
        <source>Input float register %1</source>
        <translation>実数入力レジスター %1</translation>
    </message>
    <message>
        <source>Input bit register %1</source>
        <translation>ビット入力レジスター %1</translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation>速度スライダー</translation>
    </message>
    <message>
        <source>The robot cannot time pulses while a program is running. Stop the program first, or switch the output on and off manually.</source>
        <translation>プログラムの実行中、ロボットはパルスの時間を制御できません。先にプログラムを停止するか、出力を手動でオン・オフしてください。</translation>
    </message>
</context>
<context>
    <name>RobotServices</name>
    <message>
        <source>%1 failed. %2</source>
        <translation>%1 に失敗しました。%2</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>電源オン</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>ブレーキ解除</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>電源オフ</translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation>安全を再起動</translation>
    </message>
    <message>
        <source>Close popups</source>
        <translation>ポップアップを閉じる</translation>
    </message>
    <message>
        <source>Play program</source>
        <translation>プログラム再生</translation>
    </message>
    <message>
        <source>Pause program</source>
        <translation>プログラム一時停止</translation>
    </message>
    <message>
        <source>Stop program</source>
        <translation>プログラム停止</translation>
    </message>
    <message>
        <source>Protective stop unlocked by the operator</source>
        <translation>操作者が保護停止のロックを解除</translation>
    </message>
    <message>
        <source>Load program %1</source>
        <translation>プログラム %1 の読み込み</translation>
    </message>
    <message>
        <source>The program on the robot was stopped.</source>
        <translation>ロボットのプログラムを停止しました。</translation>
    </message>
    <message>
        <source>The program on the robot could not be stopped. Stop the program on the teach pendant. %1</source>
        <translation>ロボットのプログラムを停止できませんでした：ティーチペンダントで停止してください。%1</translation>
    </message>
    <message>
        <source>The robot was switched to Local control: the motion was stopped and control was given back. Switch the robot to Remote control on the teach pendant, then take control again.</source>
        <translation>ロボットがローカル制御に切り替わりました：動作を止め、制御を返却しました。ティーチペンダントでリモート制御に戻し、もう一度制御を取得してください。</translation>
    </message>
    <message>
        <source>Unlock protective stop</source>
        <translation>保護停止のロックを解除</translation>
    </message>
    <message>
        <source>The robot sends no data, so a stop may not reach the robot. Press the emergency stop if the arm must stop.</source>
        <translation>ロボットからデータが届かないため、停止指令が届かない可能性があります。アームを止める必要がある場合は非常停止を押してください。</translation>
    </message>
</context>
<context>
    <name>RobotTooling</name>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller は制御中ではありません。先に制御を取得してください。</translation>
    </message>
    <message>
        <source>TCP and payload can be set only at standstill. Wait until the arm has stopped.</source>
        <translation>TCP とペイロードは静止中にのみ設定できます。アームが止まるまで待ってください。</translation>
    </message>
    <message>
        <source>TCP set on the robot: %1</source>
        <translation>ロボットに TCP を設定：%1</translation>
    </message>
    <message>
        <source>Payload set on the robot: %1</source>
        <translation>ロボットにペイロードを設定：%1</translation>
    </message>
</context>
<context>
    <name>SampleProjects</name>
    <message>
        <source>Pick and place</source>
        <translation>ピックアンドプレース</translation>
    </message>
    <message>
        <source>Picks a part from a feeder and places it in one of six tray cells. The cells are defined in the frame of the tray and move with it.</source>
        <translation>部品を供給器から取り、トレーの六つのセルの一つに置きます。セルはトレーの座標系で定義され、一緒に動きます。</translation>
    </message>
    <message>
        <source>Gluing along a path</source>
        <translation>経路に沿った接着</translation>
    </message>
    <message>
        <source>Applies a bead around a lid with rounded corners in slow, straight moves. Blends keep the nozzle moving through the corners.</source>
        <translation>角の丸いふたの周りをゆっくり直線で塗ります。ブレンドにより角でもノズルが動き続けます。</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>計測</translation>
    </message>
    <message>
        <source>A probe touches a part from above and from four sides. Each touch starts at an approach waypoint with the tool tilted.</source>
        <translation>プローブが部品に上と四方から触れます。それぞれツールを傾けて接近点から始めます。</translation>
    </message>
</context>
<context>
    <name>SceneActions</name>
    <message>
        <source>Default view (perspective)</source>
        <translation>標準の視点（透視）</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>正面から見る</translation>
    </message>
    <message>
        <source>Base X to the right, Z up.</source>
        <translation>ベースの X が右、Z が上。</translation>
    </message>
    <message>
        <source>Look from the side</source>
        <translation>側面から見る</translation>
    </message>
    <message>
        <source>Base Y to the right, Z up.</source>
        <translation>ベースの Y が右、Z が上。</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>上から見る</translation>
    </message>
    <message>
        <source>Base X to the right, Y up.</source>
        <translation>ベースの X が右、Y が上。</translation>
    </message>
    <message>
        <source>Fit everything in the view</source>
        <translation>全体をビューに収める</translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view without changing the viewing direction.</source>
        <translation>視線方向を変えずに、アーム、目標、ウェイポイントを画面に収めます。</translation>
    </message>
    <message>
        <source>Shows the arm diagonally from the front, slightly from above, and fits everything in the view.</source>
        <translation>アームを斜め前方のやや上から表示し、全体をビューに収めます。</translation>
    </message>
</context>
<context>
    <name>SessionRecording</name>
    <message>
        <source>Cannot record: connect to a robot first.</source>
        <translation>記録できません：先にロボットに接続してください。</translation>
    </message>
    <message>
        <source>Recording to %1</source>
        <translation>%1 に記録中</translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n rows to %1</source>
        <translation>
            <numerusform>%n 行を %1 に記録しました</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording continues without notes. %1</source>
        <translation>メモなしで記録を続けます。%1</translation>
    </message>
    <message>
        <source>Not recorded, because the robot does not accept a second connection: %1</source>
        <translation>ロボットが 2 つ目の接続を拒否したため記録されません: %1</translation>
    </message>
    <message numerus="yes">
        <source>The recording has gaps: %n packets are missing.</source>
        <translation>
            <numerusform>記録に欠落があります: %n パケットがありません。</numerusform>
        </translation>
    </message>
    <message>
        <source>The current recording does not contain %1. Start a new recording to record displayed signals.</source>
        <translation>現在の記録には %1 が含まれていません。表示中の信号を記録するには、新しい記録を開始してください。</translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. These signals are not recorded: %1</source>
        <translation>ロボットはこれほど多くの信号を同時に送信できません。記録されない信号：%1</translation>
    </message>
    <message>
        <source>Waiting for the trigger %1 to record to %2</source>
        <translation>トリガー %1 を待機中。記録先: %2</translation>
    </message>
    <message>
        <source>The trigger has not occurred. No file was written.</source>
        <translation>トリガーは発生しませんでした。ファイルは作成されていません。</translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n files; the last one is %1</source>
        <translation>
            <numerusform>%n 個のファイルに記録しました。最後のファイル: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SettingsFile</name>
    <message>
        <source>Invalid value for the setting “%1”.</source>
        <translation>設定「%1」の値が無効です。</translation>
    </message>
    <message>
        <source>The file is too large for a settings file.</source>
        <translation>設定ファイルとしては大きすぎます。</translation>
    </message>
    <message>
        <source>The file is damaged at byte %1: %2.</source>
        <translation>ファイルのバイト %1 が壊れています：%2。</translation>
    </message>
    <message>
        <source>The file contains no Tiller settings.</source>
        <translation>ファイルに Tiller の設定がありません。</translation>
    </message>
    <message>
        <source>The file was written by a newer version of Tiller. Update Tiller to import the file.</source>
        <translation>このファイルは新しいバージョンの Tiller で作成されました。Tiller を更新してから取り込んでください。</translation>
    </message>
    <message>
        <source>The file contains no version number.</source>
        <translation>ファイルにバージョン番号がありません。</translation>
    </message>
    <message>
        <source>The list of settings is missing or too long.</source>
        <translation>ファイルに設定の一覧がないか、長すぎます。</translation>
    </message>
    <message>
        <source>“%1” is not a valid setting name.</source>
        <translation>「%1」は有効な設定名ではありません。</translation>
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
        <translation>関節</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>入出力</translation>
    </message>
    <message>
        <source>Modes and states</source>
        <translation>モードと状態</translation>
    </message>
    <message>
        <source>Power and temperature</source>
        <translation>電力と温度</translation>
    </message>
    <message>
        <source>Speed and program</source>
        <translation>速度とプログラム</translation>
    </message>
    <message>
        <source>Payload and tool</source>
        <translation>ペイロードとツール</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>レジスター</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>TCP の力</translation>
    </message>
    <message>
        <source>TCP torque</source>
        <translation>TCP のトルク</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>TCP の位置</translation>
    </message>
    <message>
        <source>TCP rotation vector</source>
        <translation>TCP の回転ベクトル</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>TCP の速度</translation>
    </message>
    <message>
        <source>TCP angular speed</source>
        <translation>TCP の回転速度</translation>
    </message>
    <message>
        <source>TCP acceleration</source>
        <translation>TCP の加速度</translation>
    </message>
    <message>
        <source>Target TCP position</source>
        <translation>TCP の目標位置</translation>
    </message>
    <message>
        <source>Target TCP rotation vector</source>
        <translation>TCP の目標回転ベクトル</translation>
    </message>
    <message>
        <source>Target TCP speed</source>
        <translation>TCP の目標速度</translation>
    </message>
    <message>
        <source>Target TCP angular speed</source>
        <translation>TCP の目標回転速度</translation>
    </message>
    <message>
        <source>Raw sensor force</source>
        <translation>センサーの生の力</translation>
    </message>
    <message>
        <source>Raw sensor torque</source>
        <translation>センサーの生のトルク</translation>
    </message>
    <message>
        <source>TCP force, norm</source>
        <translation>TCP の力、ノルム</translation>
    </message>
    <message>
        <source>Tool accelerometer</source>
        <translation>フランジの加速度計</translation>
    </message>
    <message>
        <source>Elbow position</source>
        <translation>肘の位置</translation>
    </message>
    <message>
        <source>Elbow speed</source>
        <translation>肘の速度</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>運動量</translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation>関節位置</translation>
    </message>
    <message>
        <source>Joint speeds</source>
        <translation>関節速度</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>関節電流</translation>
    </message>
    <message>
        <source>Joint temperatures</source>
        <translation>関節温度</translation>
    </message>
    <message>
        <source>Joint voltages</source>
        <translation>関節電圧</translation>
    </message>
    <message>
        <source>Target joint positions</source>
        <translation>目標関節位置</translation>
    </message>
    <message>
        <source>Target joint speeds</source>
        <translation>目標関節速度</translation>
    </message>
    <message>
        <source>Target joint accelerations</source>
        <translation>目標関節加速度</translation>
    </message>
    <message>
        <source>Target joint currents</source>
        <translation>目標関節電流</translation>
    </message>
    <message>
        <source>Target joint torques</source>
        <translation>目標関節トルク</translation>
    </message>
    <message>
        <source>Joint control currents</source>
        <translation>関節制御電流</translation>
    </message>
    <message>
        <source>Allowed current deviation</source>
        <translation>電流の許容偏差</translation>
    </message>
    <message>
        <source>Position deviation, ratio to limit</source>
        <translation>位置偏差と限界の比</translation>
    </message>
    <message>
        <source>Collision detection, ratio to limit</source>
        <translation>衝突検出と限界の比</translation>
    </message>
    <message>
        <source>Joint modes</source>
        <translation>関節モード</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>デジタル入力</translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation>デジタル出力</translation>
    </message>
    <message>
        <source>Analog input 0</source>
        <translation>アナログ入力 0</translation>
    </message>
    <message>
        <source>Analog input 1</source>
        <translation>アナログ入力 1</translation>
    </message>
    <message>
        <source>Analog output 0</source>
        <translation>アナログ出力 0</translation>
    </message>
    <message>
        <source>Analog output 1</source>
        <translation>アナログ出力 1</translation>
    </message>
    <message>
        <source>Tool analog input 0</source>
        <translation>ツールアナログ入力 0</translation>
    </message>
    <message>
        <source>Tool analog input 1</source>
        <translation>ツールアナログ入力 1</translation>
    </message>
    <message>
        <source>Robot mode</source>
        <translation>ロボットモード</translation>
    </message>
    <message>
        <source>Safety mode</source>
        <translation>安全モード</translation>
    </message>
    <message>
        <source>Safety status</source>
        <translation>安全状態</translation>
    </message>
    <message>
        <source>Program state</source>
        <translation>プログラム状態</translation>
    </message>
    <message>
        <source>Robot status</source>
        <translation>ロボット状態</translation>
    </message>
    <message>
        <source>Safety bits</source>
        <translation>安全ビット</translation>
    </message>
    <message>
        <source>Tool mode</source>
        <translation>ツールモード</translation>
    </message>
    <message>
        <source>Main voltage</source>
        <translation>主電圧</translation>
    </message>
    <message>
        <source>Arm voltage</source>
        <translation>アーム電圧</translation>
    </message>
    <message>
        <source>Arm current</source>
        <translation>アーム電流</translation>
    </message>
    <message>
        <source>I/O current</source>
        <translation>I/O の電流</translation>
    </message>
    <message>
        <source>Tool temperature</source>
        <translation>ツール温度</translation>
    </message>
    <message>
        <source>Tool voltage</source>
        <translation>ツール電圧</translation>
    </message>
    <message>
        <source>Tool current</source>
        <translation>ツール電流</translation>
    </message>
    <message>
        <source>Speed scaling</source>
        <translation>速度スケーリング</translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation>速度スライダー</translation>
    </message>
    <message>
        <source>Control step time</source>
        <translation>制御ステップの時間</translation>
    </message>
    <message>
        <source>Script line</source>
        <translation>スクリプト行</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>コントローラー時刻</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>ペイロード</translation>
    </message>
    <message>
        <source>Payload centre of gravity</source>
        <translation>ペイロードの重心</translation>
    </message>
    <message>
        <source>TCP offset</source>
        <translation>TCP オフセット</translation>
    </message>
    <message>
        <source>TCP rotation</source>
        <translation>TCP 回転</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>電源オン</translation>
    </message>
    <message>
        <source>Program running</source>
        <translation>プログラム実行中</translation>
    </message>
    <message>
        <source>Freedrive button</source>
        <translation>フリードライブボタン</translation>
    </message>
    <message>
        <source>Power button</source>
        <translation>電源ボタン</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>通常</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>低減</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>保護停止</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>リカバリー</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>安全防護停止</translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation>システム非常停止</translation>
    </message>
    <message>
        <source>Robot emergency stop</source>
        <translation>ロボット非常停止</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>非常停止</translation>
    </message>
    <message>
        <source>Violation</source>
        <translation>違反</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Enabling device</source>
        <translation>イネーブル装置</translation>
    </message>
    <message>
        <source>Bit %1</source>
        <translation>ビット %1</translation>
    </message>
    <message>
        <source>Output registers, floats</source>
        <translation>出力レジスター、実数</translation>
    </message>
    <message>
        <source>Input registers, floats</source>
        <translation>入力レジスター、実数</translation>
    </message>
    <message>
        <source>Output registers, integers</source>
        <translation>出力レジスター、整数</translation>
    </message>
    <message>
        <source>Input registers, integers</source>
        <translation>入力レジスター、整数</translation>
    </message>
    <message>
        <source>Output registers, bits</source>
        <translation>出力レジスター、ビット</translation>
    </message>
    <message>
        <source>Input registers, bits</source>
        <translation>入力レジスター、ビット</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>Stopped due to safety</source>
        <translation>安全による停止</translation>
    </message>
</context>
<context>
    <name>SpaceMouse</name>
    <message>
        <source>left button</source>
        <translation>左ボタン</translation>
    </message>
    <message>
        <source>The tool follows the motion of the cap.</source>
        <translation>ツールはキャップの動きに従います。</translation>
    </message>
</context>
<context>
    <name>Spectrum</name>
    <message>
        <source>compute a spectrum</source>
        <translation>スペクトルの計算</translation>
    </message>
    <message>
        <source>The range contains fewer than %1 samples. Select a longer range.</source>
        <translation>サンプルが%1個より少なくなっています。範囲を長くしてください。</translation>
    </message>
    <message>
        <source>Values are missing in this range. Select a range without gaps.</source>
        <translation>この範囲には値の欠けがあります。欠けのない範囲を選んでください。</translation>
    </message>
    <message>
        <source>Not enough memory. Select a shorter range.</source>
        <translation>メモリーが足りません：短い範囲を選択してください。</translation>
    </message>
</context>
<context>
    <name>StartProject</name>
    <message>
        <source>The last project no longer exists: %1</source>
        <translation>前回のプロジェクトがありません：%1</translation>
    </message>
</context>
<context>
    <name>StateLane</name>
    <message>
        <source>Protective stop</source>
        <translation>保護停止</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>リカバリー</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>安全防護停止</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>非常停止</translation>
    </message>
    <message>
        <source>Enabling device released</source>
        <translation>イネーブル装置が離された</translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation>安全違反</translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation>安全故障</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>電源オフ</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>起動中</translation>
    </message>
    <message>
        <source>Brakes on</source>
        <translation>ブレーキ中</translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation>バックドライブ</translation>
    </message>
    <message>
        <source>Not running</source>
        <translation>非稼働</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>データなし</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>フリードライブ</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation>%1 へジョグ</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>動作中</translation>
    </message>
    <message>
        <source>At standstill</source>
        <translation>静止中</translation>
    </message>
    <message>
        <source>Late data</source>
        <translation>データ遅延</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Enter an IP address, such as 192.168.0.10, or a host name.</source>
        <translation>192.168.0.10 のような IP アドレスか、ホスト名を入力してください。</translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and this PC is on the same network.</source>
        <translation>ロボットの電源、ケーブル、この PC が同じネットワークにあることを確認してください。</translation>
    </message>
    <message>
        <source>Enable the interface on the robot under Settings &gt; Security &gt; Services. A robot that has just started may need another minute.</source>
        <translation>ロボットの「設定 &gt; セキュリティ &gt; サービス」でインターフェースを有効にしてください。起動直後のロボットはもう 1 分かかることがあります。</translation>
    </message>
    <message>
        <source>The robot may be restarting or switching between Local and Remote control. Wait a minute, then connect again.</source>
        <translation>再起動中か、ローカルとリモートを切り替えている可能性があります。1 分待ってから、もう一度接続してください。</translation>
    </message>
    <message>
        <source>The robot does not respond. Check the cable and the address.</source>
        <translation>ロボットが応答しません。ケーブルとアドレスを確認してください。</translation>
    </message>
    <message>
        <source>No more data received. Check the cable. Tiller reconnects automatically; motion does not resume.</source>
        <translation>データが届かなくなりました。ケーブルを確認してください。自動で再接続します。動作は再開しません。</translation>
    </message>
    <message>
        <source>The response is not valid for this protocol. Check the address and the port.</source>
        <translation>応答がプロトコルに合っていません。アドレスとポートを確認してください。</translation>
    </message>
    <message>
        <source>If newer software is available for this robot, update the robot.</source>
        <translation>このロボット用の新しいソフトウェアがあれば、ロボットを更新してください。</translation>
    </message>
    <message>
        <source>The robot&apos;s software does not provide this value.</source>
        <translation>ロボットのソフトウェアにこの値はありません。</translation>
    </message>
    <message>
        <source>Another program or a fieldbus on the robot uses these registers. Close the other program, or disable the fieldbus in the installation.</source>
        <translation>別のプログラムかロボットのフィールドバスがこれらのレジスターを使っています：そのプログラムを閉じるか、インストールでフィールドバスを無効にしてください。</translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation>先にロボットに接続してください。</translation>
    </message>
    <message>
        <source>Take control first.</source>
        <translation>先に制御を取得してください。</translation>
    </message>
    <message>
        <source>Power on the arm, release the brakes and clear any safety stop first.</source>
        <translation>先にアームの電源を入れ、ブレーキを解除し、安全停止があれば解除してください。</translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant.</source>
        <translation>ティーチペンダント右上でロボットをリモート制御に切り替えてください。</translation>
    </message>
    <message>
        <source>Choose a target within the reach of the arm and a speed below the speed cap.</source>
        <translation>アームの範囲内の目標と上限内の速度を選んでください。</translation>
    </message>
    <message>
        <source>The arm cannot reach this pose. Move the target closer or rotate the tool.</source>
        <translation>アームはこの姿勢に到達できません：点を近づけるか、ツールを回してください。</translation>
    </message>
    <message>
        <source>The robot could not run the program. See the log for the controller&apos;s message.</source>
        <translation>ロボットはプログラムを実行できませんでした。コントローラーのメッセージはログにあります。</translation>
    </message>
    <message>
        <source>Check that the file exists and that you have permission to read it.</source>
        <translation>ファイルが存在し、読めることを確認してください。</translation>
    </message>
    <message>
        <source>Choose a folder that you have permission to write to.</source>
        <translation>書き込めるフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>The file was not changed. Open a backup, or repair the file at the reported position.</source>
        <translation>ファイルは変更されていません。バックアップを開くか、示された箇所を修正してください。</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Address not found</source>
        <translation>アドレスが見つかりません</translation>
    </message>
    <message>
        <source>Robot not reachable</source>
        <translation>ロボットに到達できません</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>接続拒否</translation>
    </message>
    <message>
        <source>Connection closed by the robot</source>
        <translation>ロボットが接続を終了</translation>
    </message>
    <message>
        <source>Timed out</source>
        <translation>タイムアウト</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>取り消し</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>接続が切れました</translation>
    </message>
    <message>
        <source>Protocol error</source>
        <translation>プロトコルエラー</translation>
    </message>
    <message>
        <source>Not supported by this robot</source>
        <translation>このロボットでは非対応</translation>
    </message>
    <message>
        <source>Value not available</source>
        <translation>値がありません</translation>
    </message>
    <message>
        <source>Registers in use</source>
        <translation>レジスター使用中</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>未接続</translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation>制御なし</translation>
    </message>
    <message>
        <source>Robot not ready</source>
        <translation>ロボットの準備ができていません</translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation>ロボットはローカル制御です</translation>
    </message>
    <message>
        <source>Outside the limits</source>
        <translation>範囲外</translation>
    </message>
    <message>
        <source>Invalid value</source>
        <translation>無効な値</translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation>到達不可</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Refused by the robot</source>
        <translation>ロボットが拒否</translation>
    </message>
    <message>
        <source>Program error on the robot</source>
        <translation>ロボットのプログラムエラー</translation>
    </message>
    <message>
        <source>Cannot read the file</source>
        <translation>ファイルを読めません</translation>
    </message>
    <message>
        <source>Cannot write the file</source>
        <translation>ファイルに書けません</translation>
    </message>
    <message>
        <source>File is damaged</source>
        <translation>ファイルが壊れています</translation>
    </message>
    <message>
        <source>Disk full</source>
        <translation>ディスクが一杯</translation>
    </message>
    <message>
        <source>Internal error</source>
        <translation>内部エラー</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>button or key released</source>
        <translation>ボタンまたはキーを離した</translation>
    </message>
    <message>
        <source>pointer left the button</source>
        <translation>ポインターがボタンから外れた</translation>
    </message>
    <message>
        <source>focus lost</source>
        <translation>フォーカスを失った</translation>
    </message>
    <message>
        <source>another window became active</source>
        <translation>別のウィンドウがアクティブになった</translation>
    </message>
    <message>
        <source>window closed</source>
        <translation>ウィンドウを閉じた</translation>
    </message>
    <message>
        <source>a dialog or menu opened</source>
        <translation>ダイアログかメニューが開いた</translation>
    </message>
    <message>
        <source>another button or key pressed</source>
        <translation>別のボタンまたはキーが押された</translation>
    </message>
    <message>
        <source>Esc pressed</source>
        <translation>Esc が押された</translation>
    </message>
    <message>
        <source>Space pressed</source>
        <translation>Space が押された</translation>
    </message>
    <message>
        <source>STOP pressed</source>
        <translation>STOP が押された</translation>
    </message>
    <message>
        <source>input device lost</source>
        <translation>入力デバイスを失った</translation>
    </message>
    <message>
        <source>robot data arrived too late</source>
        <translation>ロボットのデータが古い</translation>
    </message>
    <message>
        <source>robot or safety mode changed</source>
        <translation>ロボットか安全のモードが変わった</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>接続切断</translation>
    </message>
    <message>
        <source>limit reached</source>
        <translation>限界に到達</translation>
    </message>
    <message>
        <source>control lost</source>
        <translation>制御を失った</translation>
    </message>
    <message>
        <source>target reached</source>
        <translation>目標に到達</translation>
    </message>
    <message>
        <source>stopped by a program</source>
        <translation>プログラムが停止</translation>
    </message>
    <message>
        <source>contact detected</source>
        <translation>接触を検出</translation>
    </message>
    <message>
        <source>target cannot be reached</source>
        <translation>目標に到達できない</translation>
    </message>
    <message>
        <source>could not verify that the button or key is still pressed</source>
        <translation>ボタンまたはキーが押されていることを確認できない</translation>
    </message>
    <message>
        <source>maximum hold time reached; press again</source>
        <translation>最大保持時間に達しました。もう一度押してください</translation>
    </message>
    <message>
        <source>PolyScope X before 10.11 does not accept these commands over the network. Use the teach pendant.</source>
        <translation>10.11 より前の PolyScope X は、これらの指令をネットワーク経由では受け付けません：ティーチペンダントを使ってください。</translation>
    </message>
    <message>
        <source>PolyScope X cannot close popups over the network. Use the teach pendant.</source>
        <translation>PolyScope X ではポップアップをネットワーク経由で閉じられません：ティーチペンダントを使ってください。</translation>
    </message>
    <message>
        <source>Monitoring. Take control to move the arm.</source>
        <translation>監視のみです。アームを動かすには制御を取得してください。</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>制御を取得中…</translation>
    </message>
    <message>
        <source>Control was given back. Take control to move the arm.</source>
        <translation>制御を返却しました。アームを動かすには制御を取得してください。</translation>
    </message>
    <message>
        <source>The control program on the robot was stopped. Take control again.</source>
        <translation>制御プログラムがロボットで停止されました。もう一度制御を取得してください。</translation>
    </message>
    <message>
        <source>The control program was replaced or does not respond. Take control again.</source>
        <translation>制御プログラムが置き換えられたか、応答していません。もう一度制御を取得してください。</translation>
    </message>
    <message>
        <source>The connection was lost. Take control again.</source>
        <translation>リンクが切れました。もう一度制御を取得してください。</translation>
    </message>
    <message>
        <source>Your script is running. Tiller regains control when the script ends.</source>
        <translation>スクリプトが実行中です。終了すると Tiller に制御が戻ります。</translation>
    </message>
    <message>
        <source>Free some space on the disk, then save or record again.</source>
        <translation>ディスクの空きを増やしてから、もう一度保存または記録してください。</translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. Turn off “Monitor only” in Settings, or start Tiller without --monitor-only.</source>
        <translation>監視のみ：このウィンドウはロボットを変更しません。設定で「監視のみ」をオフにするか、--monitor-only なしで Tiller を起動してください。</translation>
    </message>
    <message>
        <source>No current data from the robot. Check the network connection to the robot.</source>
        <translation>ロボットから最新のデータが届いていません。ロボットとのネットワーク接続を確認してください。</translation>
    </message>
    <message>
        <source>selection or modifier key changed</source>
        <translation>選択または修飾キーの変更</translation>
    </message>
    <message>
        <source>the window did not respond</source>
        <translation>ウィンドウが応答しませんでした</translation>
    </message>
    <message>
        <source>not measured: no data during the stop</source>
        <translation>測定なし: 停止中のデータがありません</translation>
    </message>
    <message>
        <source>not measured: another program is moving the arm</source>
        <translation>測定なし: 別のプログラムがアームを動かしています</translation>
    </message>
    <message>
        <source>the PC is going to sleep</source>
        <translation>PC がスリープ</translation>
    </message>
    <message>
        <source>the robot did not receive the stop command</source>
        <translation>ロボットが停止指令を受信していません</translation>
    </message>
    <message>
        <source>servo target too far from the previous target</source>
        <translation>サーボ目標が前の目標から離れすぎている</translation>
    </message>
</context>
<context>
    <name>WaypointClipboard</name>
    <message>
        <source>the value is missing</source>
        <translation>値がありません</translation>
    </message>
    <message>
        <source>“%1” is not a number</source>
        <translation>「%1」は数ではありません</translation>
    </message>
    <message>
        <source>%1 is outside the range %2 to %3</source>
        <translation>%1 は %2〜%3 の範囲外です</translation>
    </message>
    <message>
        <source>Line %1, column “%2”: %3.</source>
        <translation>行 %1、列「%2」：%3。</translation>
    </message>
    <message>
        <source>“%1” must be “J” or “L”</source>
        <translation>「%1」は「J」または「L」でなければなりません</translation>
    </message>
    <message>
        <source>“%1” must be “joints” or “pose”</source>
        <translation>「%1」は「joints」または「pose」でなければなりません</translation>
    </message>
    <message>
        <source>the project has no frame named “%1”</source>
        <translation>このプロジェクトに座標系「%1」はありません</translation>
    </message>
    <message>
        <source>The text is not a table of waypoints. Copy a waypoint from the list to see the columns, or use the six values of a pose.</source>
        <translation>これはウェイポイントの表ではありません。一覧から一つコピーして列を確かめるか、姿勢の六つの数を貼り付けてください。</translation>
    </message>
    <message>
        <source>“%1” is not a waypoint colour (none, blue, orange, green, pink, yellow or sky)</source>
        <translation>「%1」はウェイポイントの色（none、blue、orange、green、pink、yellow、sky）ではありません</translation>
    </message>
</context>
<context>
    <name>WaypointExchange</name>
    <message>
        <source>Line %1: the closing quotation mark is missing.</source>
        <translation>行 %1：閉じ引用符がありません。</translation>
    </message>
</context>
<context>
    <name>tiller::ActionsDialog</name>
    <message>
        <source>Actions at “%1”</source>
        <translation>「%1」での動作</translation>
    </message>
    <message numerus="yes">
        <source>Actions at %n waypoints</source>
        <translation>
            <numerusform>%n個のウェイポイントでの動作</numerusform>
        </translation>
    </message>
    <message>
        <source>“Run route (hold)” runs these actions in order at the waypoint while the button is held.</source>
        <translation>「ルート」でウェイポイントに着くと、ボタンを押している間、この順に実行されます。</translation>
    </message>
    <message>
        <source>These waypoints have different actions. “Apply” replaces them all with the actions below.</source>
        <translation>これらのウェイポイントの動作は異なります。「適用」を押すと、すべてが下の動作になります。</translation>
    </message>
    <message>
        <source>Actions in order</source>
        <translation>動作の順序</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Remove the selected action</source>
        <translation>選んだ動作を削除</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>Move the selected action up</source>
        <translation>選んだ動作を上へ移動</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下へ</translation>
    </message>
    <message>
        <source>Move the selected action down</source>
        <translation>選んだ動作を下へ移動</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Terminal</source>
        <translation>端子</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>タイムアウト</translation>
    </message>
    <message>
        <source>After this time, the action fails with a message. With 0, the action waits while the button is held, up to one hour.</source>
        <translation>この時間を過ぎると待機は失敗し、メッセージを表示します。0：ボタンを押している間、最大 1 時間待ちます。</translation>
    </message>
    <message>
        <source>Add an action after the selected action</source>
        <translation>選んだ動作の後に動作を追加</translation>
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
        <translation>%1 の範囲</translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation>%1 の値</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>%1 を設定</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>名前を変更…</translation>
    </message>
    <message>
        <source>Scale…</source>
        <translation>スケール…</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>%1 の名前</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>%1 のスケール</translation>
    </message>
    <message>
        <source>e.g. bar; empty: no scaling</source>
        <translation>例：bar。空：換算なし</translation>
    </message>
    <message>
        <source>At 4 mA or 0 V</source>
        <translation>4 mA または 0 V で</translation>
    </message>
    <message>
        <source>At 20 mA or 10 V</source>
        <translation>20 mA または 10 V で</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>%1: %2
To rename or scale the signal, right-click it, or press F2 or Shift+F2.</source>
        <translation>%1：%2
F2 で名前変更、Shift+F2 でスケール、または右クリック。</translation>
    </message>
</context>
<context>
    <name>tiller::ArmKey</name>
    <message>
        <source>Keyboard armed</source>
        <translation>キーボード有効</translation>
    </message>
    <message>
        <source>Arm keyboard</source>
        <translation>キーボードを有効に</translation>
    </message>
    <message>
        <source>While the keyboard is armed, holding an arrow key moves the arm. A border around the window shows that the keyboard is armed.</source>
        <translation>キーボードが有効な間、押している矢印キーがアームを動かします。ウィンドウの枠は、キーボードが有効であることを示します。</translation>
    </message>
    <message>
        <source>Arrow keys move along X and Y, PgUp and PgDn along Z; with Alt, they rotate the tool. Hold 1 to 6 and press + or − to move a joint. Space and Esc stop the arm. To disarm the keyboard, click this button or wait 30 s.</source>
        <translation>矢印は X と Y、PgUp と PgDn は Z、Alt で回転、1〜6 と + − で関節が動きます。Space と Esc で停止。クリックするか 30 秒待つとキーボードは無効になります。</translation>
    </message>
</context>
<context>
    <name>tiller::CellPage</name>
    <message>
        <source>Size %1</source>
        <translation>サイズ %1</translation>
    </message>
    <message>
        <source>Shown and checked for collisions</source>
        <translation>表示と衝突確認の対象</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Enter a name for the box or plane.</source>
        <translation>箱または平面の名前を入力してください。</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>「%1」の名前を「%2」に変更</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>セル</translation>
    </message>
    <message>
        <source>No boxes or planes yet.
Move the TCP to a corner of an obstacle and press “Teach corner”.</source>
        <translation>箱も平面もまだありません。
TCPを障害物の角に移動し、「角をここに」を押してください。</translation>
    </message>
    <message>
        <source>Check for collisions</source>
        <translation>衝突を確認</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Centre of the box. Press Return to apply the values. Only the box changes; the robot does not move.</source>
        <translation>箱の中心です。Enterで適用します。変わるのは箱だけで、ロボットは動きません。</translation>
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
        <translation>箱</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>「%1」を追加</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>First corner recorded</source>
        <translation>最初の角を記録しました</translation>
    </message>
    <message>
        <source>Move the TCP to the opposite corner and press “Teach corner 2”.</source>
        <translation>TCPを反対側の角に移動し、「もう一つの角」を押してください。</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>The corners must differ by at least 1 mm along X, Y and Z. Move the TCP to the opposite corner of the box.</source>
        <translation>二つの角は X、Y、Z のそれぞれで 1 mm 以上離れている必要があります。TCPを箱の反対側の角に移動してください。</translation>
    </message>
    <message>
        <source>Move “%1”</source>
        <translation>「%1」を移動</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>「%1」を複製</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>「%1」を削除</translation>
    </message>
    <message>
        <source>Set the floor</source>
        <translation>床を設定</translation>
    </message>
    <message>
        <source>Remove the floor</source>
        <translation>床を削除</translation>
    </message>
    <message>
        <source>Change the safety distance</source>
        <translation>安全距離を変更</translation>
    </message>
    <message>
        <source>Teach corner 2</source>
        <translation>もう一つの角</translation>
    </message>
    <message>
        <source>Teach corner</source>
        <translation>角をここに</translation>
    </message>
    <message>
        <source>%1 · %2 in %3</source>
        <translation>%1 · %3の%2</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>ベース</translation>
    </message>
    <message>
        <source>Length along X</source>
        <translation>X方向の長さ</translation>
    </message>
    <message>
        <source>Length along Y</source>
        <translation>Y方向の長さ</translation>
    </message>
    <message>
        <source>Length along Z</source>
        <translation>Z方向の長さ</translation>
    </message>
    <message>
        <source>Point on the plane, X</source>
        <translation>平面上の点、X</translation>
    </message>
    <message>
        <source>Point on the plane, Y</source>
        <translation>平面上の点、Y</translation>
    </message>
    <message>
        <source>Point on the plane, Z</source>
        <translation>平面上の点、Z</translation>
    </message>
    <message>
        <source>Normal X, towards the arm</source>
        <translation>法線 X（アーム側）</translation>
    </message>
    <message>
        <source>Normal Y, towards the arm</source>
        <translation>法線 Y（アーム側）</translation>
    </message>
    <message>
        <source>Normal Z, towards the arm</source>
        <translation>法線 Z（アーム側）</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>When off, the box or plane is neither shown nor checked for collisions.</source>
        <translation>オフの場合、箱または平面は表示も衝突確認もされません。</translation>
    </message>
    <message>
        <source>Horizontal plane in the base frame that the arm must stay above.</source>
        <translation>アームがその上に留まるべきベース座標系の水平面です。</translation>
    </message>
    <message>
        <source>Floor height</source>
        <translation>床の高さ</translation>
    </message>
    <message>
        <source>Safety distance</source>
        <translation>安全距離</translation>
    </message>
    <message>
        <source>Jogging stops at this distance from objects in the cell and between parts of the arm. Moves that would bring the arm closer are refused.</source>
        <translation>ジョグは、セルとの間およびアームの各部の間がこの距離になると停止します。それより近づく動作は拒否されます。</translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation>TCP位置</translation>
    </message>
    <message>
        <source>Set the floor to the TCP height</source>
        <translation>床をTCPの高さに設定</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Teach a box corner at the TCP</source>
        <translation>箱の角をTCPに設定</translation>
    </message>
    <message>
        <source>Teach plane</source>
        <translation>平面をここに</translation>
    </message>
    <message>
        <source>Add a plane through the TCP, perpendicular to the tool</source>
        <translation>TCPを通りツールに垂直な平面を追加</translation>
    </message>
    <message>
        <source>New box</source>
        <translation>新しい箱</translation>
    </message>
    <message>
        <source>Add a box numerically</source>
        <translation>数値で箱を追加</translation>
    </message>
    <message>
        <source>Add a plane through the TCP</source>
        <translation>TCPを通る平面を追加</translation>
    </message>
    <message>
        <source>Add a plane numerically</source>
        <translation>数値で平面を追加</translation>
    </message>
    <message>
        <source>Move the box or plane to the TCP</source>
        <translation>箱または平面をTCPへ移動</translation>
    </message>
    <message>
        <source>Rename box or plane</source>
        <translation>箱または平面の名前を変更</translation>
    </message>
    <message>
        <source>Duplicate box or plane</source>
        <translation>箱または平面を複製</translation>
    </message>
    <message>
        <source>Delete box or plane</source>
        <translation>箱または平面を削除</translation>
    </message>
    <message>
        <source>Resize “%1”</source>
        <translation>「%1」のサイズを変更</translation>
    </message>
    <message>
        <source>The normal must not be zero. Enter at least one nonzero component.</source>
        <translation>法線をゼロにはできません。先に成分を入力してください。</translation>
    </message>
    <message>
        <source>Rotate “%1”</source>
        <translation>「%1」を回転</translation>
    </message>
    <message>
        <source>missing frame</source>
        <translation>座標系がありません</translation>
    </message>
    <message>
        <source>Turn on the collision check of “%1”</source>
        <translation>「%1」の衝突確認をオンにする</translation>
    </message>
    <message>
        <source>Turn off the collision check of “%1”</source>
        <translation>「%1」の衝突確認をオフにする</translation>
    </message>
    <message>
        <source>Turn collision check on or off</source>
        <translation>衝突の確認をオンまたはオフにする</translation>
    </message>
    <message>
        <source>The cell already contains “%1”. Choose a different name.</source>
        <translation>セルには既に「%1」があります。別の名前を選んでください。</translation>
    </message>
</context>
<context>
    <name>tiller::ChecklistItem</name>
    <message>
        <source>done</source>
        <translation>済み</translation>
    </message>
    <message>
        <source>not done yet</source>
        <translation>まだ</translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonBand</name>
    <message>
        <source>Comparison with the arm model</source>
        <translation>アームのモデルとの比較</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>比較…</translation>
    </message>
    <message>
        <source>Compare this recording with the arm model using different limits</source>
        <translation>この記録をアームのモデルと別の限界値で比較します</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Go to time</source>
        <translation>時刻へ移動</translation>
    </message>
    <message>
        <source>Cancel the comparison</source>
        <translation>比較をキャンセル</translation>
    </message>
    <message>
        <source>Place cursor A where the arm and the model diverge</source>
        <translation>アームとモデルがずれ始める時点にカーソル A を置きます</translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonDialog</name>
    <message>
        <source>Compare with the arm model</source>
        <translation>アームのモデルと比較</translation>
    </message>
    <message>
        <source>The simulated arm follows the recorded joint targets, and its motion is compared with the recorded motion. The model includes neither contact nor friction.</source>
        <translation>関節への指令をシミュレーションのアームに与え、その動きを記録と比較します。モデルには接触も摩擦も含まれません。</translation>
    </message>
    <message>
        <source>Arm model</source>
        <translation>アームのモデル</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>アーム</translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation>関節の位置</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>TCP の位置</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>関節の電流</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>TCP の力</translation>
    </message>
    <message>
        <source>Signals with a limit of 0 are not compared.</source>
        <translation>限界値が 0 のものは比較しません。</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Minimum duration</source>
        <translation>最小継続時間</translation>
    </message>
</context>
<context>
    <name>tiller::CurveDialog</name>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>倍率</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>オフセット</translation>
    </message>
    <message>
        <source>Displayed value = value × scale + offset</source>
        <translation>表示値 = 値 × 倍率 + オフセット</translation>
    </message>
    <message>
        <source>Choose the colour</source>
        <translation>色を選択</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Automatic colour</source>
        <translation>自動の色</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>線</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>実線</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>破線</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>点線</translation>
    </message>
    <message>
        <source>Value axis</source>
        <translation>値軸</translation>
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
        <translation>色</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>名前を入力してください。</translation>
    </message>
    <message>
        <source>Name and unit cannot contain = [ ].</source>
        <translation>名前と単位に = [ ] は使用できません。</translation>
    </message>
    <message>
        <source>Enter a number other than 0 as the scale.</source>
        <translation>倍率には 0 以外の数値を入力してください。</translation>
    </message>
    <message>
        <source>Enter a number as the offset.</source>
        <translation>オフセットには数値を入力してください。</translation>
    </message>
</context>
<context>
    <name>tiller::DecimalSpinBox</name>
    <message>
        <source>“%1” is out of range (%2 to %3). The value is still %4.</source>
        <translation>「%1」は範囲外です (%2～%3)。値は %4 のままです。</translation>
    </message>
</context>
<context>
    <name>tiller::DeviceTrainer</name>
    <message>
        <source>Enable motion (until Tiller is closed)</source>
        <translation>アームを動かす（Tiller を閉じるまで）</translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation>主軸のみ</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation>ゲームパッドと SpaceMouse</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>デバイス</translation>
    </message>
    <message>
        <source>Direction in which the arm would move</source>
        <translation>アームが動く方向</translation>
    </message>
    <message>
        <source>Hold-to-run</source>
        <translation>イネーブル</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation>ゲームパッドも SpaceMouse も見つかりません。接続すると自動で検出されます。</translation>
    </message>
    <message>
        <source>● held (%1)</source>
        <translation>● 押下中（%1）</translation>
    </message>
    <message>
        <source>○ not held: hold the %1</source>
        <translation>○ 未押下：%1 を押し続けてください</translation>
    </message>
    <message>
        <source>none (neutral)</source>
        <translation>なし（中立）</translation>
    </message>
    <message>
        <source>With the keyboard armed (Ctrl+J): arrow keys for X and Y; PgUp and PgDn for Z; Alt with these keys for rotation; 1 to 6 with + and − for joints; Home for the home position; End to align; Backspace to move back; F for Freedrive; Ctrl for slower; Shift for faster. Space and Esc stop the arm.</source>
        <translation>キーボード（有効な間、Ctrl+J）：矢印：X と Y、PgUp、PgDn：Z、Alt 併用：回転、1〜6 と + −：関節、Home：ホーム、End：整列、Backspace：戻る、F：フリードライブ、Ctrl：遅く、Shift：速く。Space と Esc で停止。</translation>
    </message>
</context>
<context>
    <name>tiller::EmptyState</name>
    <message>
        <source>Nothing found</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>Nothing found with these filters.</source>
        <translation>この条件では見つかりません。</translation>
    </message>
    <message>
        <source>Nothing found for “%1”.
Clear the search to see everything.</source>
        <translation>「%1」は見つかりません。
検索を空にするとすべて表示します。</translation>
    </message>
</context>
<context>
    <name>tiller::FirstSteps</name>
    <message>
        <source>Power on (header)</source>
        <translation>電源オン（ヘッダー）</translation>
    </message>
    <message>
        <source>Release brakes (header)</source>
        <translation>ブレーキ解除（ヘッダー）</translation>
    </message>
    <message>
        <source>Take control and hold a jog button</source>
        <translation>制御を取得、ジョグボタンを押す</translation>
    </message>
    <message>
        <source>Teach here (T)</source>
        <translation>ここを教示 (T)</translation>
    </message>
    <message>
        <source>Jog away and hold “Go to” (G)</source>
        <translation>離れて、移動を押し続ける (G)</translation>
    </message>
    <message>
        <source>Record (above the plots)</source>
        <translation>記録（グラフの上）</translation>
    </message>
</context>
<context>
    <name>tiller::FirstStepsCard</name>
    <message>
        <source>First steps</source>
        <translation>最初のステップ</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>練習課題</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>The list will not appear again. Use the command “First steps” to reopen it.</source>
        <translation>一覧は自動では再表示されません。コマンド「最初のステップ」で表示できます。</translation>
    </message>
    <message>
        <source>First steps · %1 of %2</source>
        <translation>最初のステップ · %1 / %2</translation>
    </message>
</context>
<context>
    <name>tiller::FrameDetails</name>
    <message>
        <source>Selected frame</source>
        <translation>選んだ座標系</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>In the base frame. Press Return to apply the values. Only the frame changes; the robot does not move.</source>
        <translation>ベース座標系での値。Return で適用します。変わるのは座標系だけで、ロボットは動きません。</translation>
    </message>
    <message>
        <source>not used by any waypoint</source>
        <translation>使用しているウェイポイントなし</translation>
    </message>
    <message numerus="yes">
        <source>used by %n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイントが使用</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the TCP</source>
        <translation>TCP から %1</translation>
    </message>
</context>
<context>
    <name>tiller::FrameEditing</name>
    <message>
        <source>No waypoints moved with the frame.</source>
        <translation>一緒に動いたウェイポイントはありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints moved with the frame.</source>
        <translation>
            <numerusform>%n 個のウェイポイントが一緒に動きました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Waypoints out of reach: %n.</source>
        <translation>
            <numerusform>到達不可のウェイポイント：%n 個。</numerusform>
        </translation>
    </message>
    <message>
        <source>frame</source>
        <translation>座標系</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>「%1」を教示</translation>
    </message>
    <message>
        <source>The frame moves by %1 (%2, base frame).</source>
        <translation>座標系が %1 移動します（%2、ベース座標系）。</translation>
    </message>
    <message>
        <source>No waypoint uses this frame.</source>
        <translation>この座標系を使うウェイポイントはありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints move with the frame.</source>
        <translation>
            <numerusform>%n 個のウェイポイントが一緒に動きます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>「%1」を修正教示しますか？</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>修正教示</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>「%1」を修正教示</translation>
    </message>
    <message>
        <source>Touched up “%1”</source>
        <translation>「%1」を修正教示しました</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>「%1」を複製</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>「%1」を削除しますか？</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints use this frame. They keep their positions and are converted to Base.</source>
        <translation>
            <numerusform>%n 個のウェイポイントがこれで与えられています。位置はそのままで、ベースで与えられます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation>座標系を削除</translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation>「%1」の姿勢を変更</translation>
    </message>
    <message>
        <source>The pose of “%1” was changed. %2</source>
        <translation>「%1」の姿勢を変更しました。%2</translation>
    </message>
</context>
<context>
    <name>tiller::FrameModel</name>
    <message>
        <source>Enter a name for the frame.</source>
        <translation>座標系の名前を入力してください。</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>ベース</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>View</source>
        <translation>ビュー</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>「%1」を「%2」に名前変更</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>原点 %1</translation>
    </message>
    <message>
        <source>Origin in Base, X Y Z, %1</source>
        <translation>ベースでの原点、X Y Z、%1</translation>
    </message>
    <message>
        <source>Rotation, rad</source>
        <translation>回転 rad</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Rotation vector in Base, radians</source>
        <translation>ベースでの回転ベクトル、ラジアン</translation>
    </message>
    <message>
        <source>Roll, pitch and yaw in Base</source>
        <translation>ベースでのロール、ピッチ、ヨー</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Waypoints that move with the frame</source>
        <translation>座標系とともに動くウェイポイント</translation>
    </message>
    <message>
        <source>TCP %1</source>
        <translation>TCP %1</translation>
    </message>
    <message>
        <source>Distance from the TCP, %1</source>
        <translation>TCP からの距離、%1</translation>
    </message>
    <message>
        <source>“%1” is a built-in frame. Choose a different name.</source>
        <translation>「%1」は組み込みの座標系です。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>A frame named “%1” already exists. Choose a different name.</source>
        <translation>「%1」は別の座標系の名前です。別の名前を選んでください。</translation>
    </message>
</context>
<context>
    <name>tiller::FrameTable</name>
    <message>
        <source>Frames</source>
        <translation>座標系</translation>
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
        <translation>3 点から座標系</translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation>座標系を取り消す</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>On +X</source>
        <translation>+X 上</translation>
    </message>
    <message>
        <source>Towards +Y</source>
        <translation>+Y 側</translation>
    </message>
    <message>
        <source>Record the origin at the TCP</source>
        <translation>ここを原点として記録</translation>
    </message>
    <message>
        <source>Record the point on +X at the TCP</source>
        <translation>ここを +X 上の点として記録</translation>
    </message>
    <message>
        <source>Record the point towards +Y at the TCP</source>
        <translation>ここを +Y 側の点として記録</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation>座標系を作成</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the point again.</source>
        <translation>ロボットが有効な位置を送りませんでした。点を記録し直してください。</translation>
    </message>
    <message>
        <source>The point on +X is only %1 from the origin. Record it again at least %2 away. A larger distance gives more accurate axes.</source>
        <translation>+X 上の点は原点から %1 しか離れていません。%2 以上離して記録し直してください：遠いほど軸が正確です。</translation>
    </message>
    <message>
        <source>The third point is only %1 from the origin. Record the point again at least %2 away.</source>
        <translation>3 点目は原点から %1 しか離れていません。%2 以上離して記録し直してください。</translation>
    </message>
    <message>
        <source>The three points are collinear: the third point is only %1 from the X axis. Record the point again at least %2 towards +Y.</source>
        <translation>3 点が一直線上にあります：3 点目は X 軸から %1 だけです。+Y 側に %2 以上離して記録し直してください。</translation>
    </message>
    <message>
        <source>Ready: the point on +X is %1 from the origin, and the third point is %2 from the X axis.</source>
        <translation>準備完了：+X 上の点は %1、3 点目は X 軸から %2。</translation>
    </message>
    <message>
        <source>Jog the tip to the origin of the frame and record the point (P).</source>
        <translation>先端を座標系の原点へジョグして記録してください (P)。</translation>
    </message>
    <message>
        <source>Now jog to a point on +X: %1 from the origin (minimum %2).</source>
        <translation>次は +X 上の点へ：原点から %1、最小 %2。</translation>
    </message>
    <message>
        <source>Now jog towards +Y: %1 from the X axis (minimum %2).</source>
        <translation>次は +Y 側へ：X 軸から %1、最小 %2。</translation>
    </message>
    <message>
        <source>Record  P</source>
        <translation>記録  P</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>再記録</translation>
    </message>
</context>
<context>
    <name>tiller::FramesTab</name>
    <message>
        <source>Frames</source>
        <translation>座標系</translation>
    </message>
    <message>
        <source>From TCP</source>
        <translation>TCP から</translation>
    </message>
    <message>
        <source>Teach a frame from the TCP</source>
        <translation>TCP から座標系を教示</translation>
    </message>
    <message>
        <source>3 points</source>
        <translation>3 点</translation>
    </message>
    <message>
        <source>Teach a frame from three points</source>
        <translation>3 点から座標系を教示</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>修正教示</translation>
    </message>
    <message>
        <source>Touch up the frame</source>
        <translation>座標系を修正教示</translation>
    </message>
    <message>
        <source>More frame commands</source>
        <translation>座標系のその他のコマンド</translation>
    </message>
    <message>
        <source>No frames yet.
Jog the tip to a corner of the tray or table. Press “From TCP”, or press “3 points” to record the origin, +X and +Y.</source>
        <translation>座標系はまだありません。
先端をトレーやテーブルの角へジョグし、「TCP から」、または「3 点」で原点、+X、+Y を記録してください。</translation>
    </message>
    <message>
        <source>new frame</source>
        <translation>新しい座標系</translation>
    </message>
    <message>
        <source>Create a frame at the TCP with the axes of the tool (Shift+T)</source>
        <translation>TCP の位置に、ツールの軸で座標系 (Shift+T)</translation>
    </message>
    <message>
        <source>Create a frame from its origin, a point on +X and a point towards +Y (Ctrl+Shift+T)</source>
        <translation>原点、+X 上の点、+Y 側の点から座標系を作成します (Ctrl+Shift+T)</translation>
    </message>
    <message>
        <source>Move the selected frame to the TCP (Shift+U)</source>
        <translation>選んだ座標系を TCP の位置へ (Shift+U)</translation>
    </message>
    <message>
        <source>Select a frame to touch up.</source>
        <translation>修正教示する座標系を選んでください。</translation>
    </message>
    <message>
        <source>Teach frame from the TCP</source>
        <translation>TCP から座標系を教示</translation>
    </message>
    <message>
        <source>Teach frame from three points</source>
        <translation>3 点から座標系を教示</translation>
    </message>
    <message>
        <source>Record the next point of the frame</source>
        <translation>座標系の次の点を記録</translation>
    </message>
    <message>
        <source>Create frame from points</source>
        <translation>点から座標系を作成</translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation>座標系の教示を取り消す</translation>
    </message>
    <message>
        <source>Touch up frame from the TCP</source>
        <translation>TCP から座標系を修正教示</translation>
    </message>
    <message>
        <source>Touch up frame from three points</source>
        <translation>3 点から座標系を修正教示</translation>
    </message>
    <message>
        <source>Jog in this frame</source>
        <translation>この座標系でジョグ</translation>
    </message>
    <message>
        <source>Rename frame</source>
        <translation>座標系の名前を変更</translation>
    </message>
    <message>
        <source>Duplicate frame</source>
        <translation>座標系を複製</translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation>座標系を削除</translation>
    </message>
    <message>
        <source>Touch up “%1” from three points</source>
        <translation>「%1」を 3 点から修正教示</translation>
    </message>
    <message>
        <source>New frame from three points</source>
        <translation>3 点から新しい座標系</translation>
    </message>
    <message>
        <source>Touch up…</source>
        <translation>修正教示…</translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation>座標系を作成</translation>
    </message>
    <message>
        <source>Edit frame values</source>
        <translation>座標系の数値を編集</translation>
    </message>
</context>
<context>
    <name>tiller::GoThroughBar</name>
    <message>
        <source>Loop</source>
        <translation>繰り返し</translation>
    </message>
    <message>
        <source>Run the route</source>
        <translation>ルートを実行</translation>
    </message>
    <message>
        <source>Run route (hold)</source>
        <translation>ルート（押す）</translation>
    </message>
    <message>
        <source>Run route, hold</source>
        <translation>ルート実行、押し続ける</translation>
    </message>
    <message>
        <source>Previous waypoint, hold</source>
        <translation>前のウェイポイント、押し続ける</translation>
    </message>
    <message>
        <source>Moves to the previous waypoint while the button is held</source>
        <translation>押している間、前のウェイポイントへ戻ります</translation>
    </message>
    <message>
        <source>Next waypoint, hold</source>
        <translation>次のウェイポイント、押し続ける</translation>
    </message>
    <message>
        <source>Moves to the next waypoint while the button is held, then stops</source>
        <translation>押している間、次のウェイポイントへ動き、そこで止まります</translation>
    </message>
    <message>
        <source>Route waypoints</source>
        <translation>ルートのウェイポイント</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>どのウェイポイント</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>ここから</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>After the last waypoint, continues with the first waypoint while the button is held</source>
        <translation>ボタンを押している間、最後のウェイポイントの後に最初から繰り返します</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller は制御中ではありません。先に制御を取得してください。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Next: %1 of %2, %3</source>
        <translation>次：%1 / %2、%3</translation>
    </message>
    <message>
        <source>done</source>
        <translation>済み</translation>
    </message>
    <message>
        <source>Done. The next press starts at the first waypoint.</source>
        <translation>完了。次に押すと最初から始めます。</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイント</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Moves from waypoint to waypoint while the button is held, no faster than the jog speed, and runs the actions of each waypoint. Release to pause; the next press continues to the next waypoint.</source>
        <translation>ボタンを押し続けている間、ジョグ速度以下でウェイポイントを順に移動し、それぞれで決められた動作を行います。放すと一時停止し、次に押すと次のウェイポイントへ続きます。</translation>
    </message>
    <message>
        <source>At %1: %2</source>
        <translation>%1で: %2</translation>
    </message>
    <message>
        <source>Selects the waypoints to run, in list order</source>
        <translation>ルートのウェイポイントを一覧の順に選択します</translation>
    </message>
</context>
<context>
    <name>tiller::GoToButton</name>
    <message>
        <source>Go to (hold)  G</source>
        <translation>移動（押す）  G</translation>
    </message>
    <message>
        <source>Go to, hold</source>
        <translation>移動、押し続ける</translation>
    </message>
    <message>
        <source>Moves the arm to the selected waypoint while the button or G is held, no faster than the jog speed</source>
        <translation>ボタンまたは G を押している間、選んだウェイポイントへアームを動かします。ジョグ速度を超えません</translation>
    </message>
</context>
<context>
    <name>tiller::GripperPanel</name>
    <message>
        <source>Gripper state</source>
        <translation>グリッパーの状態</translation>
    </message>
    <message>
        <source>Gripper opening</source>
        <translation>グリッパーの開き</translation>
    </message>
    <message>
        <source>Gripped object</source>
        <translation>把持している物体</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>有効化</translation>
    </message>
    <message>
        <source>Activate the gripper</source>
        <translation>グリッパーを有効化</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation>グリッパーを開く</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation>グリッパーを閉じる</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>動かす</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>グリッパー</translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation>グリッパー：開く</translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation>グリッパー：閉じる</translation>
    </message>
    <message>
        <source>Gripper: move to %1</source>
        <translation>グリッパー：%1 へ移動</translation>
    </message>
    <message>
        <source>Gripper type</source>
        <translation>グリッパーの種類</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Robotiq %1</source>
        <translation>Robotiq %1</translation>
    </message>
    <message>
        <source>One output: on = closed</source>
        <translation>1 出力：オン = 閉</translation>
    </message>
    <message>
        <source>Two outputs: open, close</source>
        <translation>二出力：開く、閉じる</translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation>閉じる出力</translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation>開く出力</translation>
    </message>
    <message>
        <source>Target opening</source>
        <translation>目標開度</translation>
    </message>
    <message>
        <source>Finger speed</source>
        <translation>指の速度</translation>
    </message>
    <message>
        <source>Finger force</source>
        <translation>指の力</translation>
    </message>
    <message>
        <source>Suggested action</source>
        <translation>推奨される対処</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>開き</translation>
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
        <translation>指の目標開度、0〜%1。「動かす」で動作を開始します。</translation>
    </message>
    <message>
        <source>Speed of the next motion. 0 % is about %1, 100 % about %2.</source>
        <translation>次の動作の速度。0 % は約 %1、100 % は約 %2。</translation>
    </message>
    <message>
        <source>Force of the next grip. 0 % is about %1, 100 % about %2.</source>
        <translation>次の把持の力。0 % は約 %1、100 % は約 %2。</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Gripper set to %1</source>
        <translation>グリッパーの設定：%1</translation>
    </message>
    <message>
        <source>%1 (speed %2, force %3)</source>
        <translation>%1（速度 %2、力 %3）</translation>
    </message>
    <message>
        <source>Please wait…</source>
        <translation>しばらくお待ちください…</translation>
    </message>
    <message>
        <source>Select the mounted gripper. The choice is stored for this robot.</source>
        <translation>取り付けたグリッパーを選んでください。選択はこのロボット用に保存されます。</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>activating…</source>
        <translation>有効化中…</translation>
    </message>
    <message>
        <source>not active</source>
        <translation>無効</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>保留中…</translation>
    </message>
    <message>
        <source>active</source>
        <translation>有効</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>動作中</translation>
    </message>
    <message>
        <source>active, at standstill</source>
        <translation>有効、静止</translation>
    </message>
    <message>
        <source>unknown while moving</source>
        <translation>動作中は不明</translation>
    </message>
    <message>
        <source>The gripper is not available with this port offset. Use a smaller port offset.</source>
        <translation>このポートオフセットではグリッパーを使えません。より小さいポートオフセットを使ってください。</translation>
    </message>
    <message>
        <source>Activating: the fingers open and close once.</source>
        <translation>有効化中：指が一度開閉します。</translation>
    </message>
    <message>
        <source>Activate the gripper first.</source>
        <translation>先にグリッパーを有効化してください。</translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation>グリッパーは有効です。</translation>
    </message>
    <message>
        <source>The fingers open and close once and drop any gripped object. Keep your fingers clear of the gripper.</source>
        <translation>グリッパーの指が一度開閉し、つかんだ物体は落ちます。手の指を近づけないでください。</translation>
    </message>
    <message>
        <source>Opens the gripper and releases the object.</source>
        <translation>グリッパーを開いて物体を放します。</translation>
    </message>
    <message>
        <source>Closes the gripper. Keep your fingers clear of the gripper.</source>
        <translation>グリッパーを閉じます。指を近づけないでください。</translation>
    </message>
    <message>
        <source>The gripper did not execute the command. Check that no other program controls the gripper, then try again.</source>
        <translation>グリッパーが指令を実行しませんでした。別のプログラムがグリッパーを制御していないことを確認し、もう一度試してください。</translation>
    </message>
    <message>
        <source>Gripper: stop</source>
        <translation>グリッパー：停止</translation>
    </message>
    <message>
        <source>Move the fingers to the target opening</source>
        <translation>指を目標開度へ動かす</translation>
    </message>
    <message>
        <source>Closed by</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Opened by</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Connect to a robot first. Tiller stores the gripper selection for each robot.</source>
        <translation>先にロボットに接続してください。Tiller はグリッパーの選択をロボットごとに保存します。</translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation>ロボットがデータを送信していません。データを待つか、再接続してください。</translation>
    </message>
    <message>
        <source>external grip</source>
        <translation>外側把持</translation>
    </message>
    <message>
        <source>internal grip</source>
        <translation>内側把持</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Stopping the arm does not open the gripper.</source>
        <translation>アームが停止してもグリッパーは開きません。</translation>
    </message>
    <message>
        <source>Moves the fingers to the target opening.</source>
        <translation>指を目標開度へ動かします。</translation>
    </message>
    <message>
        <source>Speed or force is out of range. Enter a value from 0 to 100 %.</source>
        <translation>速度または力が範囲外です。0～100 % を入力してください。</translation>
    </message>
</context>
<context>
    <name>tiller::HeaderBar</name>
    <message>
        <source>ROBOT</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>ROBOT MODE</source>
        <translation>ロボットモード</translation>
    </message>
    <message>
        <source>SAFETY</source>
        <translation>安全</translation>
    </message>
    <message>
        <source>CONTROL</source>
        <translation>制御</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>リンク</translation>
    </message>
    <message>
        <source>LAST STOP</source>
        <translation>最後の停止</translation>
    </message>
    <message>
        <source>Robot state</source>
        <translation>ロボットの状態</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>次の手順</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>データなし</translation>
    </message>
    <message>
        <source>LAST STOP · no key check</source>
        <translation>最後の停止 · キー確認なし</translation>
    </message>
    <message>
        <source>%1 ms · %2</source>
        <translation>%1 ms · %2</translation>
    </message>
    <message>
        <source>Measured from the stop command to standstill. Cause: %1</source>
        <translation>停止指令から静止までの実測値。原因：%1</translation>
    </message>
    <message>
        <source>No stop measured yet</source>
        <translation>停止はまだ計測されていません</translation>
    </message>
    <message>
        <source>▲ Speed cap raised to %1</source>
        <translation>▲ 速度上限を %1 に引き上げ</translation>
    </message>
    <message>
        <source>The arm may move faster than %1. Lower the speed cap in Settings. The cap is reset when Tiller is closed.</source>
        <translation>アームが %1 より速く動くことがあります。設定で速度上限を下げてください。Tiller を閉じると元に戻ります。</translation>
    </message>
    <message>
        <source>MONITOR ONLY</source>
        <translation>監視のみ</translation>
    </message>
    <message>
        <source>Cause: %1 (%2)</source>
        <translation>原因: %1 (%2)</translation>
    </message>
    <message>
        <source>The program was stopped on the robot, so the stop could not be measured.</source>
        <translation>プログラムはロボット側で停止されたため、停止を測定できませんでした。</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>未測定</translation>
    </message>
    <message>
        <source>The robot stopped sending data while the arm was moving, so the stop could not be measured.</source>
        <translation>アームの動作中にロボットからのデータが途切れたため、停止を測定できませんでした。</translation>
    </message>
    <message>
        <source>Not stopped</source>
        <translation>停止していません</translation>
    </message>
</context>
<context>
    <name>tiller::HoldRules</name>
    <message>
        <source>The window was not active. Press again.</source>
        <translation>ウィンドウがアクティブではありませんでした。もう一度押してください。</translation>
    </message>
    <message>
        <source>Click in the window first.</source>
        <translation>先にウィンドウ内をクリックしてください。</translation>
    </message>
    <message>
        <source>A dialog or a menu is open. Close it first.</source>
        <translation>ダイアログかメニューが開いています。先に閉じてください。</translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation>別のボタンまたはキーが押されています。先に離してください。</translation>
    </message>
    <message>
        <source>The display server does not respond, so Tiller cannot detect the release of a button or key. Release the button or key, then try again.</source>
        <translation>ディスプレイサーバーが応答しません：ボタンやキーを離したことを検出できません。離してから、もう一度試してください。</translation>
    </message>
</context>
<context>
    <name>tiller::HoldToRunButton</name>
    <message>
        <source>hold</source>
        <translation>押す</translation>
    </message>
    <message>
        <source>Hold this button. The arm moves only while the button is held.</source>
        <translation>このボタンを押し続けてください：押している間だけアームが動きます。</translation>
    </message>
</context>
<context>
    <name>tiller::ImportReport</name>
    <message>
        <source>Steps: %1. Kept as URScript text: %2. Not imported: %3. New waypoints: %4.</source>
        <translation>ステップ：%1。URScriptテキストとして保持：%2。インポートなし：%3。新しいウェイポイント：%4。</translation>
    </message>
    <message>
        <source>Imported program</source>
        <translation>インポートしたプログラム</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Node or statement</source>
        <translation>ノードまたは文</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Import report for “%1”</source>
        <translation>「%1」のインポート結果</translation>
    </message>
</context>
<context>
    <name>tiller::IncidentWatch</name>
    <message>
        <source>protective stop</source>
        <translation>保護停止</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>非常停止</translation>
    </message>
    <message>
        <source>safety violation</source>
        <translation>安全違反</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>The incident (%1) could not be recorded.</source>
        <translation>インシデント（%1）を記録できませんでした。</translation>
    </message>
    <message>
        <source>Incident recorded: %1</source>
        <translation>インシデントを記録：%1</translation>
    </message>
    <message>
        <source>The recording %2 starts %1 s before the stop. Double-click this entry to open the recording.</source>
        <translation>記録 %2 は停止の %1 s 前から始まります。この項目をダブルクリックすると開きます。</translation>
    </message>
</context>
<context>
    <name>tiller::IoChannel</name>
    <message>
        <source>no data</source>
        <translation>データなし</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>保留中…</translation>
    </message>
    <message>
        <source>%1, outdated</source>
        <translation>%1、更新なし</translation>
    </message>
    <message>
        <source>Pulse</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>名前を変更…</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>%1 の名前</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>
The output cannot be switched while the robot is not sending data.</source>
        <translation>
ロボットのデータが届かない間、出力は切り替えられません。</translation>
    </message>
    <message>
        <source>
Click to switch the output %1. Press P to pulse it. Right-click to pulse or rename it.</source>
        <translation>
クリックで切替：%1。P：パルス。右クリック：パルス、名前変更。</translation>
    </message>
    <message>
        <source>
Right-click or press F2 to rename the input.</source>
        <translation>
右クリックまたは F2 で名前を変更します。</translation>
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
        <translation>グリッパー</translation>
    </message>
    <message>
        <source>I/O page</source>
        <translation>I/O のページ</translation>
    </message>
</context>
<context>
    <name>tiller::IoTab</name>
    <message>
        <source>Inputs and outputs</source>
        <translation>入出力</translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation>入出力を検索</translation>
    </message>
    <message>
        <source>Search by terminal or name</source>
        <translation>端子か名前で検索</translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation>デジタル出力</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>デジタル入力</translation>
    </message>
    <message>
        <source>Configurable outputs</source>
        <translation>構成可能出力</translation>
    </message>
    <message>
        <source>Configurable inputs</source>
        <translation>構成可能入力</translation>
    </message>
    <message>
        <source>Tool outputs</source>
        <translation>ツール出力</translation>
    </message>
    <message>
        <source>Tool inputs</source>
        <translation>ツール入力</translation>
    </message>
    <message>
        <source>Press the Tab key to select a row on the I/O tab first.</source>
        <translation>先に Tab キーで I/O タブの行を選択してください。</translation>
    </message>
    <message>
        <source>The robot did not confirm %1</source>
        <translation>ロボットが %1 を確認しませんでした</translation>
    </message>
    <message>
        <source>Analog</source>
        <translation>アナログ</translation>
    </message>
    <message>
        <source>General purpose registers</source>
        <translation>汎用レジスター</translation>
    </message>
    <message>
        <source>Replay is active. Press “Back to live” first.</source>
        <translation>再生中です。先に「ライブに戻る」を押してください。</translation>
    </message>
    <message>
        <source>%1 cannot be pulsed now</source>
        <translation>今は%1をパルス出力できません</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>ロック中</translation>
    </message>
    <message>
        <source>controlled by another program</source>
        <translation>別のプログラムが制御中</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>Another program or the installation may control the output. Check both, then switch the output again.</source>
        <translation>別のプログラムかインストールが使っている可能性があります。両方を確認してから、もう一度出力を切り替えてください。</translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation>ロボットがデータを送信していません。データを待つか、再接続してください。</translation>
    </message>
</context>
<context>
    <name>tiller::JogColumn</name>
    <message>
        <source>Jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>Hold to move</source>
        <translation>押して動かす</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>姿勢</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>関節</translation>
    </message>
    <message>
        <source>Pose or joints</source>
        <translation>姿勢または関節</translation>
    </message>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation>たどれる軌跡がありません。まずアームをジョグしてください。</translation>
    </message>
    <message>
        <source>release and press again</source>
        <translation>離して押し直してください</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>フリードライブ</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>ホーム</translation>
    </message>
    <message>
        <source>Moves all joints to the home position while the button is held</source>
        <translation>押している間、全関節をホーム位置へ動かします</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>整列</translation>
    </message>
    <message>
        <source>Aligns the tool with the nearest axis of the selected frame while the button is held</source>
        <translation>押している間、選んだ座標系の最寄りの軸にツールを揃えます</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Retraces the last motion while the button is held</source>
        <translation>押している間、直前の動作を逆にたどります</translation>
    </message>
    <message>
        <source>home</source>
        <translation>ホーム</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>整列済み</translation>
    </message>
    <message>
        <source>Ends in %1 s</source>
        <translation>あと %1 s で終了</translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation>別のボタンまたはキーが押されています。先に離してください。</translation>
    </message>
    <message>
        <source>Last stop: %1, standstill after %2 ms, %3</source>
        <translation>最後の停止：%1、%2 ms 後に静止、%3</translation>
    </message>
    <message>
        <source>Move the arm by hand while this button is held: %1. Right-click to select axes.</source>
        <translation>このボタンを押している間、アームを手で動かせます：%1。右クリックで軸を選択します。</translation>
    </message>
    <message>
        <source>Freedrive, %1</source>
        <translation>フリードライブ、%1</translation>
    </message>
    <message>
        <source>Freedrive…</source>
        <translation>フリードライブ…</translation>
    </message>
    <message>
        <source>Check payload before Freedrive (resets on reconnect)</source>
        <translation>フリードライブ前にペイロードを確認（再接続でリセット）</translation>
    </message>
    <message>
        <source>Last stop: not measured (data lost)</source>
        <translation>最後の停止：未測定（データ喪失）</translation>
    </message>
    <message>
        <source>Press for one step</source>
        <translation>押すと 1 ステップ</translation>
    </message>
    <message>
        <source>Last stop: %1 (%2)</source>
        <translation>前回の停止: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>tiller::JogKey</name>
    <message>
        <source>%1 left in this direction</source>
        <translation>この向きに残り %1</translation>
    </message>
</context>
<context>
    <name>tiller::JogPad</name>
    <message>
        <source>Jog buttons</source>
        <translation>ジョグボタン</translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation>%1 へジョグ</translation>
    </message>
</context>
<context>
    <name>tiller::JogSelectors</name>
    <message>
        <source>Base</source>
        <translation>ベース</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>View</source>
        <translation>ビュー</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>座標系</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>押す</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Moves while the button is held</source>
        <translation>ボタンを押している間動きます</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Rotates while the button is held</source>
        <translation>ボタンを押している間回ります</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>View axes: X right, Y away from you, Z up</source>
        <translation>画面の軸：X 右、Y 奥、Z 上</translation>
    </message>
    <message>
        <source>Requires the 3D view</source>
        <translation>3D ビューが必要です</translation>
    </message>
    <message>
        <source>No frame taught yet. Teach a frame on the Frames tab.</source>
        <translation>座標系がまだありません。座標系タブで教示してください。</translation>
    </message>
    <message>
        <source>Moves by %1 per press.</source>
        <translation>押すたびに %1 動きます。</translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press.</source>
        <translation>押すたびにツールか関節を %1 回転します。</translation>
    </message>
    <message>
        <source>≤ %1</source>
        <translation>≤ %1</translation>
    </message>
    <message>
        <source>Moves slowly while the button is held, until the contact force reaches %1 N. Click again to select a different step.</source>
        <translation>押している間、接触力が %1 N に達するまでゆっくり動きます。もう一度クリックすると別のステップを選べます。</translation>
    </message>
    <message>
        <source>Moves by %1 per press. Click again to select a different step.</source>
        <translation>押すたびに %1 動きます。もう一度クリックすると別のステップを選べます。</translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press. Click again to select a different angle.</source>
        <translation>押すたびにツールか関節を %1 回転します。もう一度クリックすると別の角度を選べます。</translation>
    </message>
    <message>
        <source>%1 · rotation %2 · joints %3 · Ctrl × 0.1, Shift × 3</source>
        <translation>%1 · 回転 %2 · 関節 %3 · Ctrl × 0.1、Shift × 3</translation>
    </message>
    <message>
        <source>Other angle…</source>
        <translation>他の角度…</translation>
    </message>
    <message>
        <source>Other step…</source>
        <translation>他のステップ…</translation>
    </message>
    <message>
        <source>Until contact, %1 N</source>
        <translation>接触まで、%1 N</translation>
    </message>
    <message>
        <source>Other contact force…</source>
        <translation>他の接触力…</translation>
    </message>
    <message>
        <source>Other speed…</source>
        <translation>他の速度…</translation>
    </message>
    <message>
        <source>Step in %1</source>
        <translation>ステップ（%1）</translation>
    </message>
    <message>
        <source>Angle in degrees</source>
        <translation>角度（度）</translation>
    </message>
    <message>
        <source>TCP speed in %1</source>
        <translation>TCP の速度（%1）</translation>
    </message>
    <message>
        <source>Contact force that ends the motion, in N</source>
        <translation>動作を終える接触力（N）</translation>
    </message>
    <message>
        <source>The step continues after the button is released. Space, Esc and STOP end the step.</source>
        <translation>離してもステップは続きます。スペース、Esc、STOP で終了します。</translation>
    </message>
    <message>
        <source>Hold the button until the step is complete.</source>
        <translation>ステップが完了するまでボタンを押し続けてください。</translation>
    </message>
</context>
<context>
    <name>tiller::JointRow</name>
    <message>
        <source>%1 minus</source>
        <translation>%1 マイナス</translation>
    </message>
    <message>
        <source>%1 plus</source>
        <translation>%1 プラス</translation>
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
        <translation>関節</translation>
    </message>
</context>
<context>
    <name>tiller::KeyboardJog</name>
    <message>
        <source>Keyboard jogging is armed</source>
        <translation>キーボードジョグが有効</translation>
    </message>
</context>
<context>
    <name>tiller::LimiterLine</name>
    <message>
        <source>Limiter</source>
        <translation>リミッター</translation>
    </message>
</context>
<context>
    <name>tiller::LimitsDialog</name>
    <message>
        <source>Limits of the value axis</source>
        <translation>値軸の範囲</translation>
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
        <translation>%1、最小値</translation>
    </message>
    <message>
        <source>%1, maximum</source>
        <translation>%1、最大値</translation>
    </message>
    <message>
        <source>%1: enter two numbers. The minimum must be less than the maximum.</source>
        <translation>%1: 数値を 2 つ入力してください。最小値は最大値より小さくしてください。</translation>
    </message>
</context>
<context>
    <name>tiller::LogModel</name>
    <message>
        <source>Info</source>
        <translation>情報</translation>
    </message>
    <message>
        <source>▲ Warning</source>
        <translation>▲ 警告</translation>
    </message>
    <message>
        <source>⬣ Error</source>
        <translation>⬣ エラー</translation>
    </message>
    <message>
        <source>Tiller</source>
        <translation>Tiller</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>重大度</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Open the recording of this incident at the time of the stop</source>
        <translation>このインシデントの記録を停止の瞬間で開く</translation>
    </message>
    <message>
        <source>Open the recording at this time</source>
        <translation>この時点で記録を開きます</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>オペレーター</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>%1 · Origin: %2</source>
        <translation>%1 · 発生元: %2</translation>
    </message>
    <message>
        <source>%1 times between %2 and %3 · Origin: %4</source>
        <translation>%2 から %3 まで %1 回 · 発生元: %4</translation>
    </message>
    <message>
        <source>(×%1, last at %2) %3</source>
        <translation>（×%1、最後は %2）%3</translation>
    </message>
</context>
<context>
    <name>tiller::LogTab</name>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>ログ</translation>
    </message>
    <message>
        <source>Minimum severity</source>
        <translation>最低の重大度</translation>
    </message>
    <message>
        <source>Filter the log by text</source>
        <translation>ログを文字列で絞り込む</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>絞り込み</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy the selected entries, or all visible entries (Ctrl+C)</source>
        <translation>選択した行、または表示中の全行をコピー (Ctrl+C)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>エクスポート…</translation>
    </message>
    <message>
        <source>Write the visible entries to a file</source>
        <translation>表示中の項目をファイルに書き出す</translation>
    </message>
    <message>
        <source>Details of the selected entry</source>
        <translation>選択した項目の詳細</translation>
    </message>
    <message>
        <source>Export the log</source>
        <translation>ログをエクスポート</translation>
    </message>
    <message>
        <source>Text file (*.txt)</source>
        <translation>テキストファイル (*.txt)</translation>
    </message>
    <message>
        <source>Log written to %1</source>
        <translation>ログを %1 に書きました</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>記録を開く</translation>
    </message>
    <message>
        <source>Open the recording of the selected entry</source>
        <translation>選択した項目の記録を開く</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>メモ：%1</translation>
    </message>
</context>
<context>
    <name>tiller::MetadataDialog</name>
    <message>
        <source>Ask before each recording</source>
        <translation>記録のたびに確認</translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation>記録のメタデータ</translation>
    </message>
    <message>
        <source>Tiller stores the fields with a value in each recording. The names and values are kept for the next recording.</source>
        <translation>値のある項目は各記録に保存されます。名前と値は次の記録のために保持されます。</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>メタデータ</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Add field</source>
        <translation>項目を追加</translation>
    </message>
    <message>
        <source>Remove field</source>
        <translation>項目を削除</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>The value “%1” has no name. Enter a name.</source>
        <translation>値「%1」に名前がありません。名前を入力してください。</translation>
    </message>
    <message>
        <source>The name “%1” is not valid. Use letters, digits, spaces and _ - . (at most 60).</source>
        <translation>名前「%1」は使用できません。文字、数字、空白、_ - . を使用してください（60 文字以内）。</translation>
    </message>
    <message>
        <source>Tiller stores “%1” itself. Choose another name.</source>
        <translation>「%1」は Tiller が保存します。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>The name “%1” occurs twice. Choose another name.</source>
        <translation>名前「%1」が重複しています。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>The value of “%1” must be one line of at most %2 characters.</source>
        <translation>「%1」の値は %2 文字以内の 1 行にしてください。</translation>
    </message>
    <message>
        <source>Remove fields: at most %1 fields are possible.</source>
        <translation>項目を削除してください。最大 %1 個です。</translation>
    </message>
</context>
<context>
    <name>tiller::MoveWords</name>
    <message>
        <source>%1 collides with %2 after %3 of the path</source>
        <translation>%1 が経路の %3 で %2 に衝突します</translation>
    </message>
    <message>
        <source>The move enters the wrist singularity after %1 of the path</source>
        <translation>経路の %1 で手首の特異点に入ります</translation>
    </message>
    <message>
        <source>The move slows down near the wrist singularity at %1 of the path</source>
        <translation>経路の %1 で手首の特異点近くのため低速</translation>
    </message>
    <message>
        <source>The move enters the elbow singularity after %1 of the path</source>
        <translation>経路の %1 で肘の特異点に入ります</translation>
    </message>
    <message>
        <source>The move slows down near the elbow singularity at %1 of the path</source>
        <translation>経路の %1 で肘の特異点近くのため低速</translation>
    </message>
    <message>
        <source>The move enters the shoulder singularity after %1 of the path</source>
        <translation>経路の %1 で肩の特異点に入ります</translation>
    </message>
    <message>
        <source>The move slows down near the shoulder singularity at %1 of the path</source>
        <translation>経路の %1 で肩の特異点近くのため低速</translation>
    </message>
    <message>
        <source>A joint would have to jump after %1 of the path</source>
        <translation>経路の %1 で関節の急な変化が必要です</translation>
    </message>
    <message>
        <source>%1 exceeds its limit after %2 of the path</source>
        <translation>%1 が経路の %2 で可動範囲を超えます</translation>
    </message>
    <message>
        <source>The move leaves the reach of the arm after %1 of the path</source>
        <translation>直線は経路の %1 でアームの到達範囲を出ます</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>ベース</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>肩</translation>
    </message>
    <message>
        <source>Upper arm</source>
        <translation>上腕</translation>
    </message>
    <message>
        <source>Forearm</source>
        <translation>前腕</translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation>手首1</translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation>手首2</translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation>手首3</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>%1 is in contact with %2, and the move reduces the distance</source>
        <translation>%1は%2に接触しており、この動作でさらに近づきます</translation>
    </message>
    <message>
        <source>%1 is only %2 from %3, and the move reduces the distance</source>
        <translation>%1は%3まで%2しかなく、この動作でさらに近づきます</translation>
    </message>
    <message>
        <source>%1 comes within %2 of %3 after %4 of the path</source>
        <translation>%1が経路の%4で%3まで%2以内に近づきます</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>床</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>「%1」</translation>
    </message>
    <message>
        <source>The position of “%1” is unknown because its frame is not in the project. Enter its position, turn off its collision check, or delete it on the Cell page</source>
        <translation>「%1」の座標系がプロジェクトにないため、位置が不明です。セルページで位置を入力するか、衝突確認をオフにするか、削除してください</translation>
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
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Notice action</source>
        <translation>通知の操作</translation>
    </message>
    <message>
        <source>Second notice action</source>
        <translation>通知の 2 番目の操作</translation>
    </message>
</context>
<context>
    <name>tiller::OpenTableDialog</name>
    <message>
        <source>Open table</source>
        <translation>表を開く</translation>
    </message>
    <message>
        <source>Tiller cannot determine the times of the rows in %1. Select how to read the table.</source>
        <translation>%1 の各行の時刻を判別できません。表の読み取り方法を選択してください。</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>ファイルの先頭行</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>時刻の列</translation>
    </message>
    <message>
        <source>No time column</source>
        <translation>時刻の列なし</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>時刻の単位</translation>
    </message>
    <message>
        <source>Rows per second</source>
        <translation>毎秒の行数</translation>
    </message>
    <message>
        <source>Column separator</source>
        <translation>列の区切り</translation>
    </message>
    <message>
        <source>Comma</source>
        <translation>コンマ</translation>
    </message>
    <message>
        <source>Semicolon</source>
        <translation>セミコロン</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>タブ</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>スペース</translation>
    </message>
    <message>
        <source>Decimal separator</source>
        <translation>小数点</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>ピリオド</translation>
    </message>
    <message>
        <source>First row</source>
        <translation>最初の行</translation>
    </message>
    <message>
        <source>Column names</source>
        <translation>列名</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>Reason: %1</source>
        <translation>理由: %1</translation>
    </message>
    <message>
        <source>Detect automatically</source>
        <translation>自動検出</translation>
    </message>
</context>
<context>
    <name>tiller::PartModel</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
</context>
<context>
    <name>tiller::PartPage</name>
    <message>
        <source>More</source>
        <translation>その他</translation>
    </message>
</context>
<context>
    <name>tiller::PathControls</name>
    <message>
        <source>Path tolerance</source>
        <translation>経路の許容差</translation>
    </message>
    <message>
        <source>Record path</source>
        <translation>経路を記録</translation>
    </message>
    <message>
        <source>Export path as CSV…</source>
        <translation>経路を CSV でエクスポート…</translation>
    </message>
    <message>
        <source>Import path from CSV…</source>
        <translation>CSV から経路を取り込む…</translation>
    </message>
    <message>
        <source>The path recorded so far is kept.</source>
        <translation>それまでの記録は残ります。</translation>
    </message>
    <message>
        <source>Stop recording path</source>
        <translation>経路の記録を停止</translation>
    </message>
    <message>
        <source>Simplifying the path…</source>
        <translation>経路を簡略化しています…</translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation>ロボットからデータが来ないため、経路を記録できません。データを待つか、ロボットを接続してください。</translation>
    </message>
    <message>
        <source>Stops recording and stores the path as waypoints</source>
        <translation>記録を停止し、経路をウェイポイントとして保存します</translation>
    </message>
    <message>
        <source>Records the path of the arm during Freedrive or jogging and stores it as waypoints. Press again to stop. Recording does not move the robot.</source>
        <translation>フリードライブやジョグでのアームの経路を記録し、ウェイポイントとして保存します。もう一度押すと終了します。ロボットは動きません。</translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation>経路のウェイポイントを二つ以上選んでください。</translation>
    </message>
    <message>
        <source>Export path</source>
        <translation>経路をエクスポート</translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation>CSV ファイル (*.csv)</translation>
    </message>
    <message>
        <source>The path was not exported.</source>
        <translation>経路はエクスポートされませんでした。</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints exported as a path to %1</source>
        <translation>
            <numerusform>%n 個のウェイポイントを経路として %1 に書きました</numerusform>
        </translation>
    </message>
    <message>
        <source>Import path</source>
        <translation>経路を取り込む</translation>
    </message>
    <message>
        <source>○ Path</source>
        <translation>○ 経路</translation>
    </message>
    <message>
        <source>The path of the arm is being recorded. To stop recording, press “● REC” or select “Stop recording path” in the menu.</source>
        <translation>アームの経路を記録しています。終了するには「● REC」を押すか、メニューで経路記録の停止を選択してください。</translation>
    </message>
    <message>
        <source>Path recording stopped because the maximum duration of ten minutes was reached.</source>
        <translation>経路の記録が終了しました：最長時間の 10 分に達しました。</translation>
    </message>
    <message>
        <source>Path recording stopped because the robot stopped sending data or was restarted.</source>
        <translation>経路の記録が終了しました：ロボットのデータが途絶えたか、ロボットが再起動しました。</translation>
    </message>
</context>
<context>
    <name>tiller::PathRecorder</name>
    <message>
        <source>%1 has no column “%2”. The columns “timestamp” and “actual_q_0” to “actual_q_5” are required.</source>
        <translation>%1 に列「%2」がありません。timestamp と actual_q_0〜actual_q_5 が必要です。</translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation>ロボットからデータが来ないため、経路を記録できません。データを待つか、ロボットを接続してください。</translation>
    </message>
    <message>
        <source>Import refused because another path is being recorded or processed. Stop the recording, or wait, and try again.</source>
        <translation>別の経路を記録中または処理中のため、読み込みませんでした。記録を停止するか、完了を待ってから再試行してください。</translation>
    </message>
    <message>
        <source>The path could not be imported.</source>
        <translation>経路を取り込めませんでした。</translation>
    </message>
    <message>
        <source>path %1</source>
        <translation>経路 %1</translation>
    </message>
    <message>
        <source>The arm did not move. No path was stored.</source>
        <translation>アームが動きませんでした：経路は保存されていません。</translation>
    </message>
    <message>
        <source>Record “%1”</source>
        <translation>「%1」を記録</translation>
    </message>
    <message>
        <source>“%1”: %2 s, %3 waypoints. Maximum deviation from the recording: %4 and %5.</source>
        <translation>「%1」：%2 s、ウェイポイント %3 個。記録からの最大偏差：%4 と %5。</translation>
    </message>
    <message numerus="yes">
        <source>%n packets were lost.</source>
        <translation>
            <numerusform>%n パケットが失われました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation>経路のウェイポイントを二つ以上選んでください。</translation>
    </message>
    <message>
        <source>“%1” is out of reach. Touch up or delete the waypoint.</source>
        <translation>「%1」に到達できません。修正教示するか、除いてください。</translation>
    </message>
</context>
<context>
    <name>tiller::PatternDialog</name>
    <message>
        <source>pattern</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>Pattern from three corners</source>
        <translation>三隅からパターン</translation>
    </message>
    <message>
        <source>Pattern “%1”</source>
        <translation>パターン「%1」</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>First cell</source>
        <translation>最初のセル</translation>
    </message>
    <message>
        <source>End of the first row</source>
        <translation>最初の行の終わり</translation>
    </message>
    <message>
        <source>Start of the last row</source>
        <translation>最後の行の先頭</translation>
    </message>
    <message>
        <source>Select a waypoint</source>
        <translation>ウェイポイントを選択</translation>
    </message>
    <message>
        <source>As taught</source>
        <translation>教示どおり</translation>
    </message>
    <message>
        <source>Cells per row</source>
        <translation>1 行のセル数</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>層数</translation>
    </message>
    <message>
        <source>Layer height</source>
        <translation>層の高さ</translation>
    </message>
    <message>
        <source>Distance from one layer to the next, measured opposite to the tool direction.</source>
        <translation>層の間の距離。ツールの方向と逆向きです。</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>順序</translation>
    </message>
    <message>
        <source>Row by row</source>
        <translation>行ごと</translation>
    </message>
    <message>
        <source>Zigzag</source>
        <translation>蛇行</translation>
    </message>
    <message>
        <source>Create pattern</source>
        <translation>パターンを作成</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
    <message>
        <source>Enter a name for the pattern.</source>
        <translation>パターンの名前を入力してください。</translation>
    </message>
    <message>
        <source>Teach the corners first, then select a waypoint for each corner.</source>
        <translation>先にパターンの隅を教示し、次に各隅のウェイポイントを選んでください。</translation>
    </message>
    <message>
        <source>The layer height must not be 0. Enter a layer height.</source>
        <translation>層の高さは 0 にできません。層の高さを入力してください。</translation>
    </message>
    <message>
        <source>The pattern has %1 cells; the maximum is %2. Enter fewer cells per row, rows or layers.</source>
        <translation>パターンのセルは %1 個です。上限は %2 個です。1 行あたりのセル数、行数または層数を減らしてください。</translation>
    </message>
    <message>
        <source>All cells are excluded. Click a cell to include it.</source>
        <translation>すべてのセルが除外されています。セルをクリックして含めてください。</translation>
    </message>
    <message>
        <source>The three corners are on a straight line. Select a different waypoint for one of them.</source>
        <translation>3 つの角が一直線上にあります。いずれかに別のウェイポイントを選択してください。</translation>
    </message>
    <message>
        <source>Two corners are at the same position. Select a different waypoint for one of them.</source>
        <translation>二つの隅が同じ位置です。一方に別のウェイポイントを選んでください。</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイント</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, all within reach.</source>
        <translation>%1、すべて到達可能です。</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n out of reach and marked.</source>
        <translation>
            <numerusform>%1、うち %n 個は到達不可で、印を付けました。</numerusform>
        </translation>
    </message>
    <message>
        <source>A pattern with this name already exists. Choose a different name.</source>
        <translation>その名前のパターンがあります。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>The layer height is not a number or is out of range. Enter a different layer height.</source>
        <translation>層の高さが数値でないか、範囲外です。別の値を入力してください。</translation>
    </message>
</context>
<context>
    <name>tiller::PatternGrid</name>
    <message>
        <source>Pattern cells</source>
        <translation>パターンのセル</translation>
    </message>
    <message>
        <source>Click a cell to exclude or include it. The first cell is at the lower left.</source>
        <translation>セルをクリックすると除外または追加できます。最初のセルは左下です。</translation>
    </message>
    <message>
        <source>Row %1, column %2</source>
        <translation>行 %1、列 %2</translation>
    </message>
</context>
<context>
    <name>tiller::PayloadEstimator</name>
    <message>
        <source>Next pose (hold)</source>
        <translation>次の姿勢（押す）</translation>
    </message>
    <message>
        <source>Keep payload</source>
        <translation>ペイロードを採用</translation>
    </message>
    <message>
        <source>Measure payload</source>
        <translation>ペイロードを測定</translation>
    </message>
    <message>
        <source>Measure the payload in several poses</source>
        <translation>複数の姿勢でペイロードを測定</translation>
    </message>
    <message>
        <source>Next pose, hold</source>
        <translation>次の姿勢、押し続ける</translation>
    </message>
    <message>
        <source>Rotates the wrist to the next pose while the button is held, no faster than the jog speed. Make sure that the tool has space to rotate.</source>
        <translation>押している間、手首を次の姿勢へ回します。ジョグ速度を超えません。ツールが回れる余地を確かめてください。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancel payload measurement</source>
        <translation>ペイロードの測定を取り消す</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller は制御中ではありません。先に制御を取得してください。</translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and record the pose again.</source>
        <translation>アームが動きました。静止させ、何にも触れず、姿勢を記録し直してください。</translation>
    </message>
    <message>
        <source>The robot is not sending force data. Enter the mass and the centre of gravity instead.</source>
        <translation>ロボットが力のデータを送りません。質量と重心を数値で入力してください。</translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation>計量中… ツールに何も触れないでください。</translation>
    </message>
    <message>
        <source>%1 kg, centre of gravity at %2 from the flange. The poses agree within %3 and %4.</source>
        <translation>%1 kg、重心はフランジから %2。姿勢は %3 と %4 以内で一致。</translation>
    </message>
    <message>
        <source>%1 The accuracy is low: pose %2 deviates most. Remove this pose and record another pose.</source>
        <translation>%1 精度が低いです：姿勢 %2 が最も合いません。除いて別の姿勢を記録してください。</translation>
    </message>
    <message>
        <source>The load of %1 kg is too light to measure the centre of gravity. Enter the payload manually.</source>
        <translation>%1 kg の負荷は軽すぎて重心を測定できません。ペイロードを手動で入力してください。</translation>
    </message>
    <message>
        <source>Wait for standstill, keep the tool free of contact, and record the pose. Then rotate the wrist by jogging or with “Next pose (hold)”, and record three more poses.</source>
        <translation>アームを静止させ、何にも触れず、姿勢を記録します。次にジョグか「次の姿勢」で手首を回し、さらに三つ記録します。</translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation>姿勢 %1 を記録</translation>
    </message>
    <message>
        <source>Remove least accurate pose</source>
        <translation>最も不正確な姿勢を削除</translation>
    </message>
    <message>
        <source>Remove last pose</source>
        <translation>最後の姿勢を削除</translation>
    </message>
    <message>
        <source>Pose %1  %2</source>
        <translation>姿勢 %1  %2</translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation>  ◀ 最も不正確</translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool rotated in a different direction.</source>
        <translation>姿勢間のツールの回転が足りません。別の側に回してもう一つ記録してください。</translation>
    </message>
    <message numerus="yes">
        <source>Rotate the wrist in a different direction and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>手首を別の側に回して姿勢を記録してください。残り：%n。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::PayloadPage</name>
    <message>
        <source>Mass kg</source>
        <translation>質量 kg</translation>
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
        <translation>ペイロードの名前を入力してください。</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>「%1」を「%2」に名前変更</translation>
    </message>
    <message>
        <source>Nothing mounted</source>
        <translation>取り付けなし</translation>
    </message>
    <message>
        <source>Robotiq 2F-85, empty</source>
        <translation>Robotiq 2F-85、空</translation>
    </message>
    <message>
        <source>Robotiq 2F-140, empty</source>
        <translation>Robotiq 2F-140、空</translation>
    </message>
    <message>
        <source>Payloads</source>
        <translation>ペイロード</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>質量</translation>
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
        <translation>ペイロードの質量</translation>
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
        <translation>Return でプロジェクトに適用します。ロボットのペイロードは変わりません。</translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation>ロボットに設定</translation>
    </message>
    <message>
        <source>Use this payload and set it on the robot</source>
        <translation>このペイロードを使い、ロボットに設定する</translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation>測定…</translation>
    </message>
    <message>
        <source>Measure the payload with the arm</source>
        <translation>アームでペイロードを測定</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>検証</translation>
    </message>
    <message>
        <source>Verify the payload</source>
        <translation>ペイロードを検証</translation>
    </message>
    <message>
        <source>Store the active payload of the robot</source>
        <translation>ロボットの有効なペイロードを保存</translation>
    </message>
    <message>
        <source>Enter new payload</source>
        <translation>新しいペイロードを入力</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>ペイロード</translation>
    </message>
    <message>
        <source>Add preset: %1</source>
        <translation>既定値を追加：%1</translation>
    </message>
    <message>
        <source>Rename payload</source>
        <translation>ペイロードの名前を変更</translation>
    </message>
    <message>
        <source>Duplicate payload</source>
        <translation>ペイロードを複製</translation>
    </message>
    <message>
        <source>Delete payload</source>
        <translation>ペイロードを削除</translation>
    </message>
    <message>
        <source>Add the payload “%1”</source>
        <translation>ペイロード「%1」を追加</translation>
    </message>
    <message>
        <source>Change the payload “%1”</source>
        <translation>ペイロード「%1」を変更</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>ロボット未接続。接続するか、シミュレーターを試してください。</translation>
    </message>
    <message>
        <source>Select the payload to set.</source>
        <translation>設定するペイロードを選んでください。</translation>
    </message>
    <message>
        <source>Use the payload “%1”</source>
        <translation>ペイロード「%1」を使う</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller は制御中ではありません。先に制御を取得してください。</translation>
    </message>
    <message>
        <source>Delete the payload “%1”</source>
        <translation>ペイロード「%1」を削除</translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation>計量中… ツールに何も触れないでください。</translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and press “Verify” again.</source>
        <translation>アームが動きました。静止させ、何にも触れず、もう一度確認してください。</translation>
    </message>
    <message>
        <source>The payload cannot be verified because the robot is not sending force data. Wait for data, or reconnect.</source>
        <translation>ロボットが力のデータを送信していないため、ペイロードを確認できません。データを待つか、再接続してください。</translation>
    </message>
    <message>
        <source>With a payload of %1 kg, the arm measures a force of %2 and a torque of %3.</source>
        <translation>ペイロード %1 kg で、アームの測定値は力 %2、トルク %3 です。</translation>
    </message>
    <message>
        <source>The payload is correct. %1</source>
        <translation>ペイロードは正しいです。%1</translation>
    </message>
    <message>
        <source>The payload is correct</source>
        <translation>ペイロードは正しい</translation>
    </message>
    <message>
        <source>The load is about %1 kg heavier than the configured payload.</source>
        <translation>負荷は設定されたペイロードより約 %1 kg 重いです。</translation>
    </message>
    <message>
        <source>The load is about %1 kg lighter than the configured payload.</source>
        <translation>負荷は設定されたペイロードより約 %1 kg 軽いです。</translation>
    </message>
    <message>
        <source>The centre of gravity differs, or something is touching the tool.</source>
        <translation>重心が異なるか、何かがツールに触れています。</translation>
    </message>
    <message>
        <source>%1 %2 Measure the payload, or select a different payload. Zeroing the force sensor hides a wrong payload until the tool rotates.</source>
        <translation>%1 %2 計量するか、別のペイロードを選んでください。力センサーをゼロにしても、ツールが回るまで誤りが隠れるだけです。</translation>
    </message>
    <message>
        <source>The payload is wrong. %1 %2</source>
        <translation>ペイロードが正しくありません。%1 %2</translation>
    </message>
    <message>
        <source>The payload is wrong</source>
        <translation>ペイロードが正しくない</translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation>%1、ロボットで有効</translation>
    </message>
    <message>
        <source>%1; the robot uses %2 kg, centre of gravity %3</source>
        <translation>%1。ロボットの設定は %2 kg、重心 %3</translation>
    </message>
    <message>
        <source>The robot&apos;s payload differs from “%1”</source>
        <translation>ロボットのペイロードは「%1」と異なります</translation>
    </message>
    <message>
        <source>On the robot: %1 kg, centre of gravity %2. In the project: %3 kg, centre of gravity %4. Nothing was changed.</source>
        <translation>ロボット：%1 kg、重心 %2。プロジェクト：%3 kg、重心 %4。何も変わっていません。</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>「%1」をロボットに設定</translation>
    </message>
    <message>
        <source>No payloads yet.
Press “Measure…” to measure the payload with the arm.</source>
        <translation>ペイロードはまだありません。
「測定…」を押すと、アームでペイロードを測定します。</translation>
    </message>
    <message>
        <source>A payload named “%1” already exists. Choose a different name.</source>
        <translation>「%1」は別のペイロードの名前です。別の名前を選んでください。</translation>
    </message>
</context>
<context>
    <name>tiller::PlotAnalysis</name>
    <message>
        <source>Spectrum</source>
        <translation>スペクトル</translation>
    </message>
    <message>
        <source>XY</source>
        <translation>XY</translation>
    </message>
    <message>
        <source>vs.</source>
        <translation>対</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>スペクトルとXY</translation>
    </message>
    <message>
        <source>Analysis type</source>
        <translation>解析の種類</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>X-axis signal</source>
        <translation>X 軸の信号</translation>
    </message>
    <message>
        <source>Add a signal to the plots first.</source>
        <translation>先にグラフに信号を追加してください。</translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range.</source>
        <translation>この範囲にサンプルがありません。別の範囲を選んでください。</translation>
    </message>
    <message>
        <source>Samples are missing in this range. Place cursors A and B around a range without gaps.</source>
        <translation>この範囲ではサンプルが欠けています。間に欠けがないようにカーソルAとBを置いてください。</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>周波数 [Hz]</translation>
    </message>
    <message>
        <source>Amplitude of %1</source>
        <translation>%1の振幅</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%nサンプル</numerusform>
        </translation>
    </message>
    <message>
        <source>This range is too long to combine signals from different recordings. Place cursors A and B around a shorter range.</source>
        <translation>この範囲は、異なる記録の信号を組み合わせるには長すぎます。カーソル A と B をより短い範囲に置いてください。</translation>
    </message>
    <message>
        <source>Reading the recording: %1</source>
        <translation>記録を読み込み中: %1</translation>
    </message>
    <message numerus="yes">
        <source>Hann window of %1 samples · resolution %2 Hz · mean of %n segment(s) · %3 to %4 s</source>
        <translation>
            <numerusform>%1サンプルのハン窓 · 分解能 %2 Hz · %n区間の平均 · %3～%4 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) shown, 1 of every %1</source>
        <translation>
            <numerusform>%nサンプル表示、%1個に1個</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 to %3 s</source>
        <translation>%1 · %2～%3 s</translation>
    </message>
    <message>
        <source>This range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation>この範囲には異なるロボットのサンプルが含まれています。カーソル A と B で 1 台のロボットのデータを囲んでください。</translation>
    </message>
</context>
<context>
    <name>tiller::PlotComparison</name>
    <message>
        <source>Arm and model diverge: %1</source>
        <translation>アームとモデルの差が限界を超えました：%1</translation>
    </message>
    <message>
        <source>Comparing the arm with its model: %1</source>
        <translation>アームをモデルと比較中：%1</translation>
    </message>
    <message>
        <source>Not compared with the arm model: the recording does not specify the robot model. Press “Compare…” and select the model.</source>
        <translation>アームのモデルとは比較していません：記録にロボットの機種の情報がありません。「比較…」を押して機種を選択してください。</translation>
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
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Time range of the plots. The mouse wheel zooms the time axis; over the value axis, or with Ctrl, it zooms the values. Double-click the value axis to scale automatically.</source>
        <translation>グラフが表示する時間。グラフ上のホイールで拡大します。左の値の上、または Ctrl で値を拡大し、そこでダブルクリックすると自動スケールになります。</translation>
    </message>
    <message>
        <source>Pause the plots</source>
        <translation>グラフを一時停止</translation>
    </message>
    <message>
        <source>Zero the displayed force</source>
        <translation>表示の力をゼロに</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>ゼロ</translation>
    </message>
    <message>
        <source>Export the visible range</source>
        <translation>表示範囲をエクスポート</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>エクスポート…</translation>
    </message>
    <message>
        <source>Save the visible range as an image (e.g. PNG) or as values (e.g. CSV)</source>
        <translation>表示範囲を画像 (PNG など) または値 (CSV など) で保存</translation>
    </message>
    <message>
        <source>Cannot zero the force: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation>力をゼロにできませんでした：グラフにサンプルがありません。ロボットに接続するか、サンプルのある時刻に移ってください。</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>一時停止</translation>
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
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>Freeze the plots. Reception and recording of data continue.</source>
        <translation>グラフを止める。データと記録は続きます</translation>
    </message>
    <message>
        <source>Show the force as measured by the robot. %1</source>
        <translation>ロボットが測定した力を表示。%1</translation>
    </message>
    <message>
        <source>Subtract the current force in the plots. The robot, recordings and exported values are not changed.</source>
        <translation>グラフの力から現在の値を差し引きます。ロボット、記録、エクスポートの値は変わりません。</translation>
    </message>
    <message>
        <source>● REC %1</source>
        <translation>● REC %1</translation>
    </message>
    <message>
        <source>● Record</source>
        <translation>● 記録</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>記録を停止</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>Cannot export: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation>エクスポートしませんでした：グラフにサンプルがありません。ロボットに接続するか、サンプルのある時刻に移ってください。</translation>
    </message>
    <message>
        <source>Exported the visible range to %1</source>
        <translation>表示範囲を %1 にエクスポートしました</translation>
    </message>
    <message>
        <source>PNG image (*.png)</source>
        <translation>PNG 画像 (*.png)</translation>
    </message>
    <message>
        <source>SVG image (*.svg)</source>
        <translation>SVG 画像 (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 文書 (*.pdf)</translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation>CSV ファイル (*.csv)</translation>
    </message>
    <message>
        <source>Recording options</source>
        <translation>記録の設定</translation>
    </message>
    <message>
        <source>Rows, signals, folder and file name of the next recording</source>
        <translation>次の記録の行、信号、フォルダー、ファイル名</translation>
    </message>
    <message>
        <source>One row per packet</source>
        <translation>パケットごとに 1 行</translation>
    </message>
    <message numerus="yes">
        <source>One row every %n packet(s)</source>
        <translation>
            <numerusform>%n パケットごとに 1 行</numerusform>
        </translation>
    </message>
    <message>
        <source>All signals…</source>
        <translation>すべての信号…</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s)…</source>
        <translation>
            <numerusform>%n 個の信号…</numerusform>
        </translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>フォルダーを開く</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>記録用フォルダー</translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range, then export again.</source>
        <translation>この範囲にサンプルがありません。別の範囲を選んでから、もう一度エクスポートしてください。</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>What happened at this time?</source>
        <translation>この時何が起きましたか？</translation>
    </message>
    <message>
        <source>The plots were copied to the clipboard as an image.</source>
        <translation>グラフを画像としてクリップボードに入れました。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>History %1 · %2</source>
        <translation>履歴 %1 · %2</translation>
    </message>
    <message>
        <source>New page</source>
        <translation>新しいページ</translation>
    </message>
    <message>
        <source>Remove this page</source>
        <translation>このページを削除</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>記録を開く…</translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation>記録を閉じる</translation>
    </message>
    <message>
        <source>Copy plots as image</source>
        <translation>グラフを画像としてコピー</translation>
    </message>
    <message>
        <source>Save layout…</source>
        <translation>配置を保存…</translation>
    </message>
    <message>
        <source>Open layout…</source>
        <translation>配置を開く…</translation>
    </message>
    <message>
        <source>History memory</source>
        <translation>履歴用メモリー</translation>
    </message>
    <message>
        <source>Opened the recording %1</source>
        <translation>記録 %1 を開きました</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>記録を開く</translation>
    </message>
    <message>
        <source>Save plot layout</source>
        <translation>グラフの配置を保存</translation>
    </message>
    <message>
        <source>Plot layouts (*.json)</source>
        <translation>グラフの配置 (*.json)</translation>
    </message>
    <message>
        <source>Open plot layout</source>
        <translation>グラフの配置を開く</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 ほか</translation>
    </message>
    <message>
        <source>Signal list</source>
        <translation>信号の一覧</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Robot signals. Drag a signal to a plot, or to the edge of a plot to create a new plot. Double-click a signal to add it to a plot.</source>
        <translation>ロボットの信号。信号をグラフにドラッグするか、グラフの端にドラッグして新しいグラフを作成します。ダブルクリックするとグラフに追加されます。</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>カーソルの値</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Values at cursors A and B, and statistics of the range between the cursors: minimum, maximum, mean, RMS, standard deviation, slope</source>
        <translation>カーソル A と B での各信号の値と、その間の最小、最大、平均、RMS、偏差、傾き</translation>
    </message>
    <message>
        <source>Plot pages and layout</source>
        <translation>グラフのページと配置</translation>
    </message>
    <message>
        <source>Layout ▾</source>
        <translation>配置 ▾</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>スペクトルとXY</translation>
    </message>
    <message>
        <source>Export the visible range…</source>
        <translation>表示範囲をエクスポート…</translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation>時間軸</translation>
    </message>
    <message>
        <source>Relative to the newest sample</source>
        <translation>最新サンプル基準</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>コントローラー時刻</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>The maximum number of plot pages has been reached. Remove a page first.</source>
        <translation>グラフのページが上限に達しています。まず1つ取り除いてください。</translation>
    </message>
    <message>
        <source>CSV: text, for pandas and spreadsheets</source>
        <translation>CSV: テキスト、pandasや表計算用</translation>
    </message>
    <message>
        <source>MCAP: every field, the log and the project, for ROS tools</source>
        <translation>MCAP: すべてのフィールド、ログ、プロジェクト。ROSツール用</translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation>アームのモデルと比較…</translation>
    </message>
    <message>
        <source>Exported the range between cursors A and B to %1</source>
        <translation>カーソルAとBの間の範囲を%1へエクスポートしました</translation>
    </message>
    <message>
        <source>Cursor A to cursor B (*%1)</source>
        <translation>カーソル A から B まで (*%1)</translation>
    </message>
    <message>
        <source>The page shows several recordings, or a recording and live signals. Show only one of them on the page, then export again.</source>
        <translation>このページには複数の記録、または記録とライブ信号が表示されています。一つだけを表示してから、もう一度エクスポートしてください。</translation>
    </message>
    <message>
        <source>Live signals can be exported only as .csv. For other formats, record the signals first.</source>
        <translation>ライブ信号は.csvとしてのみエクスポートできます。他の形式の場合は、先に記録してください。</translation>
    </message>
    <message>
        <source>The range contains too many values to export from this window. Export a shorter range, or run “tiller-cli export”.</source>
        <translation>範囲の値が多すぎるため、このウィンドウからエクスポートできません。範囲を短くするか、「tiller-cli export」を実行してください。</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>ロボット: %1</translation>
    </message>
    <message>
        <source>Recordings (%1);;All files (*)</source>
        <translation>記録 (%1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Record to a file (%1)</source>
        <translation>ファイルに記録 (%1)</translation>
    </message>
    <message>
        <source>Record robot data to a file (%1). Use the arrow button to select the signals and the folder.</source>
        <translation>ロボットのデータをファイルに記録します (%1)。信号とフォルダーは隣の矢印ボタンで選びます。</translation>
    </message>
    <message>
        <source>All %1 pages show recordings. Remove a page or close the recordings first.</source>
        <translation>%1 ページすべてに記録が表示されています。先にページを削除するか、記録を閉じてください。</translation>
    </message>
    <message>
        <source>Cursor readout</source>
        <translation>カーソルの読み</translation>
    </message>
    <message>
        <source>Click in the plots to place cursors A and B; drag them, or use the A, B and arrow keys. Click a legend entry to hide its curve; Ctrl+click the entry to show its values at the cursors.</source>
        <translation>グラフをクリックしてカーソル A と B を置きます。ドラッグするか、A、B と矢印キーを使います。凡例の名前をクリックで曲線を隠し、Ctrl でその信号を読みます。</translation>
    </message>
    <message>
        <source>Time range</source>
        <translation>時間範囲</translation>
    </message>
    <message>
        <source>Paused · %1 s behind</source>
        <translation>一時停止 · %1 s 遅れ</translation>
    </message>
    <message>
        <source>Return to the newest samples</source>
        <translation>最新のサンプルに戻る</translation>
    </message>
    <message>
        <source>controller time %1 to %2 s</source>
        <translation>コントローラー時刻 %1～%2 s</translation>
    </message>
    <message>
        <source>%1 to %2 s</source>
        <translation>%1～%2 s</translation>
    </message>
    <message>
        <source>Folder: %1…</source>
        <translation>フォルダー：%1…</translation>
    </message>
    <message>
        <source>The file type is not supported. Use the suffix .png, .svg or .pdf for an image, or .csv for values.</source>
        <translation>このファイル形式には対応していません。画像は .png、.svg、.pdf、値は .csv の名前にしてください。</translation>
    </message>
    <message>
        <source>%1 at controller time %2 s.</source>
        <translation>%1（コントローラー時刻 %2 s）。</translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation>標準のグラフを表示</translation>
    </message>
    <message>
        <source>the file does not contain a plot layout</source>
        <translation>ファイルにグラフの配置が含まれていません</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %2/s · %3 free · %n packet(s) lost</source>
        <translation>
            <numerusform>%1 · %2/s · 空き%3 · 欠落%nパケット</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened the recording %1, but part of it could not be read. %2</source>
        <translation>記録 %1 を開きましたが、一部を読み取れません。%2</translation>
    </message>
    <message>
        <source>Part of the recording %1 could not be read. %2</source>
        <translation>記録 %1 の一部を読み取れませんでした。%2</translation>
    </message>
    <message>
        <source>The range contains samples from different robots. Use cursors A and B to select a range with data from one robot, then export again.</source>
        <translation>範囲に複数のロボットのデータが含まれています。カーソル A と B で 1 台のロボットの範囲を選択して、もう一度エクスポートしてください。</translation>
    </message>
    <message>
        <source>The image %1 could not be created. Choose a different image format.</source>
        <translation>画像 %1 を作成できませんでした。別の画像形式を選択してください。</translation>
    </message>
    <message>
        <source>Recordings…</source>
        <translation>記録の一覧…</translation>
    </message>
    <message>
        <source>The plots do not contain data from %1.</source>
        <translation>グラフに %1 のデータはありません。</translation>
    </message>
    <message>
        <source>● Waiting</source>
        <translation>● 待機中</translation>
    </message>
    <message>
        <source>Waiting for the trigger. Files so far: %1</source>
        <translation>トリガーを待機中。これまでのファイル: %1</translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation>メタデータ…</translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>メタデータ (%n 項目)…</numerusform>
        </translation>
    </message>
    <message>
        <source>Trigger…</source>
        <translation>トリガー…</translation>
    </message>
    <message>
        <source>Trigger %1…</source>
        <translation>トリガー %1…</translation>
    </message>
    <message>
        <source>File name: %1…</source>
        <translation>ファイル名：%1…</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation>実時間の %1 倍</translation>
    </message>
    <message>
        <source>Stop playback</source>
        <translation>再生を停止</translation>
    </message>
    <message>
        <source>Cannot play: the page has no samples. Connect to a robot or open a recording first.</source>
        <translation>再生できません：ページにサンプルがありません。先にロボットに接続するか、記録を開いてください。</translation>
    </message>
</context>
<context>
    <name>tiller::PlotMarks</name>
    <message>
        <source>%1 is above %2</source>
        <translation>%1 が %2 より上</translation>
    </message>
    <message>
        <source>%1 is below %2</source>
        <translation>%1 が %2 より下</translation>
    </message>
</context>
<context>
    <name>tiller::PlotPages</name>
    <message>
        <source>Plot pages</source>
        <translation>グラフページ</translation>
    </message>
    <message>
        <source>Page name</source>
        <translation>ページの名前</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>ページ %1</translation>
    </message>
    <message>
        <source>Double-click to rename</source>
        <translation>ダブルクリックで名前を変更</translation>
    </message>
</context>
<context>
    <name>tiller::PlotValues</name>
    <message>
        <source>Values at the cursors</source>
        <translation>カーソルの値</translation>
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
        <translation>標準偏差</translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation>ピークピーク</translation>
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
        <translation>グラフをクリックしてカーソル A、次にカーソル B を置きます。表にカーソル間の範囲の統計が表示されます。</translation>
    </message>
    <message>
        <source>%1 · calculating: %2</source>
        <translation>%1 · 計算中：%2</translation>
    </message>
    <message>
        <source>Statistics are incomplete: %1</source>
        <translation>統計が不完全です：%1</translation>
    </message>
    <message>
        <source>Slope per second</source>
        <translation>傾き /s</translation>
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
        <translation>%1（ゼロ）</translation>
    </message>
    <message>
        <source>%1 %2 s · %3 %4</source>
        <translation>%1 %2 s · %3 %4</translation>
    </message>
    <message>
        <source>Fixed scale · double-click the axis to scale automatically</source>
        <translation>目盛り固定 · 軸をダブルクリックで解除</translation>
    </message>
    <message>
        <source>Zeroed (offset %1 %2)</source>
        <translation>ゼロ設定済み（オフセット %1 %2）</translation>
    </message>
    <message>
        <source>Plots over time</source>
        <translation>時間に対するグラフ</translation>
    </message>
    <message>
        <source>A and B place the cursors. Left and Right move the active cursor. Up and Down select the signal at the cursors. H hides the curve of this signal; Ctrl+Delete removes it. Plus and Minus change the time range, or the value scale with Ctrl; Ctrl+0 scales automatically. N adds a note, F shows all data, and End returns to the newest samples.</source>
        <translation>A と B でカーソルを置きます。左右で有効なカーソルを動かし、上下でカーソルが読む信号を選びます。H でその信号の曲線を隠し、Ctrl+Delete で削除します。プラスとマイナスで時間範囲、Ctrl 併用で値の目盛りを変えます。Ctrl+0 で自動スケール。N でメモを追加、F で全データを表示、End で最新のサンプルに戻ります。</translation>
    </message>
    <message>
        <source>A–B Δt %1 s</source>
        <translation>A–B Δt %1 s</translation>
    </message>
    <message>
        <source>Drop signals here</source>
        <translation>ここに信号をドロップ</translation>
    </message>
    <message>
        <source>No samples yet. Connect to a robot.</source>
        <translation>サンプルがまだありません。ロボットに接続してください。</translation>
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
        <translation>X 周りの回転 (RX)</translation>
    </message>
    <message>
        <source>Rotation about Y (RY)</source>
        <translation>Y 周りの回転 (RY)</translation>
    </message>
    <message>
        <source>Rotation about Z (RZ)</source>
        <translation>Z 周りの回転 (RZ)</translation>
    </message>
</context>
<context>
    <name>tiller::PoseView</name>
    <message>
        <source>TCP at the flange</source>
        <translation>TCP はフランジ</translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation>TCP はフランジから %1</translation>
    </message>
    <message>
        <source>in %1 · %2</source>
        <translation>%1 で · %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>TCP pose in %1</source>
        <translation>%1 での TCP 姿勢</translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ₀: displacement from the zero position. Click to show the displacement since the start of the last motion.</source>
        <translation>姿勢の表記は設定どおり。Δ₀：ゼロからの移動。クリックすると最後の動作の開始からの移動を表示します。</translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ: displacement since the start of the last motion. Click to set the displacement to zero.</source>
        <translation>姿勢の表記は設定どおり。Δ：最後の動作の開始からの移動。クリックでここをゼロにします。</translation>
    </message>
    <message>
        <source>TCP in the flange frame: %1</source>
        <translation>フランジ座標系での TCP：%1</translation>
    </message>
</context>
<context>
    <name>tiller::PositionsPage</name>
    <message>
        <source>Joints °</source>
        <translation>関節 °</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>ホーム</translation>
    </message>
    <message>
        <source>Enter a name for the position.</source>
        <translation>位置の名前を入力してください。</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>「%1」を「%2」に名前変更</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>No positions yet.
Jog the arm to a position and press “Set home here” or “Add position”.</source>
        <translation>位置はまだありません。
アームをジョグし、「ここをホームに」か「位置を追加」を押してください。</translation>
    </message>
    <message>
        <source>Safe height</source>
        <translation>安全高さ</translation>
    </message>
    <message>
        <source>%1. Press Return to apply the values. Only the stored position changes; the robot does not move.</source>
        <translation>%1。Return で適用します。変わるのは保存された位置だけで、ロボットは動きません。</translation>
    </message>
    <message>
        <source>Height in the base frame. Above this height, the cell is free of obstacles, and the TCP may move sideways.</source>
        <translation>ベース座標系でこれより上には何もありません：TCP は横に動けます。</translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation>TCP位置</translation>
    </message>
    <message>
        <source>Set the safe height to the current TCP height</source>
        <translation>安全高さを今の TCP の高さにする</translation>
    </message>
    <message>
        <source>Set home here</source>
        <translation>ここをホームに</translation>
    </message>
    <message>
        <source>Add position</source>
        <translation>位置を追加</translation>
    </message>
    <message>
        <source>Store the current position of the arm</source>
        <translation>アームの現在位置を保存</translation>
    </message>
    <message>
        <source>Use as home</source>
        <translation>ホームに使う</translation>
    </message>
    <message>
        <source>Use the selected position as home</source>
        <translation>選んだ位置をホームに使う</translation>
    </message>
    <message>
        <source>Touch up position</source>
        <translation>位置を修正教示</translation>
    </message>
    <message>
        <source>Reset to default home</source>
        <translation>既定のホームに戻す</translation>
    </message>
    <message>
        <source>Rename position</source>
        <translation>位置の名前を変更</translation>
    </message>
    <message>
        <source>Delete position</source>
        <translation>位置を削除</translation>
    </message>
    <message>
        <source>Set “%1” to the current position of the arm?</source>
        <translation>「%1」をアームの位置に設定しますか？</translation>
    </message>
    <message>
        <source>The Home button will then move the arm to this position.</source>
        <translation>ホームボタンでアームがそこへ動きます。</translation>
    </message>
    <message>
        <source>Set home</source>
        <translation>ホームを設定</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Add the position “%1”</source>
        <translation>位置「%1」を追加</translation>
    </message>
    <message>
        <source>Select a position to touch up.</source>
        <translation>修正教示する位置を選んでください。</translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>「%1」を修正教示しますか？</translation>
    </message>
    <message>
        <source>Largest joint change: %1 %2.</source>
        <translation>最大の関節変化：%1 %2。</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>修正教示</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>「%1」を修正教示</translation>
    </message>
    <message>
        <source>Use “%1” as home</source>
        <translation>「%1」をホームに使う</translation>
    </message>
    <message>
        <source>Select a position to use as home.</source>
        <translation>ホームに使う位置を選んでください。</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>「%1」を削除</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>「%1」を変更</translation>
    </message>
    <message>
        <source>Set the safe height</source>
        <translation>安全高さを設定</translation>
    </message>
    <message>
        <source>Remove the safe height</source>
        <translation>安全高さを削除</translation>
    </message>
    <message>
        <source>The Home button moves the arm to the default home position: upright, without self-collision.</source>
        <translation>ホームボタンはアームを標準のホーム位置へ動かします：直立し、自己衝突しません。</translation>
    </message>
    <message>
        <source>%1: target of the Home button</source>
        <translation>%1：ホームボタンの目標</translation>
    </message>
    <message>
        <source>%1 · %2 %3 from the current position</source>
        <translation>%1 · ここから %2 %3</translation>
    </message>
    <message>
        <source>A position named “%1” already exists. Choose a different name.</source>
        <translation>「%1」は別の位置の名前です。別の名前を選んでください。</translation>
    </message>
</context>
<context>
    <name>tiller::Practice</name>
    <message>
        <source>Start the simulated robot in the Robot menu first.</source>
        <translation>先にシミュレートされたロボットを起動してください：ロボットメニューにあります。</translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes first.</source>
        <translation>先にアームの電源を入れ、ブレーキを解除してください。</translation>
    </message>
    <message>
        <source>The safety system has stopped the arm. Use “Recover…” first.</source>
        <translation>アームは安全システムにより停止しています。先に「復旧…」を使用してください。</translation>
    </message>
    <message>
        <source>Done. Press “Start” to repeat the task.</source>
        <translation>完了。「開始」を押すと課題を繰り返せます。</translation>
    </message>
    <message>
        <source>Press “Start”.</source>
        <translation>開始を押してください。</translation>
    </message>
</context>
<context>
    <name>tiller::PracticeCard</name>
    <message>
        <source>Practice</source>
        <translation>練習</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Force Fz in newtons</source>
        <translation>力 Fz（ニュートン）</translation>
    </message>
    <message>
        <source>Enter a value and press Return</source>
        <translation>値を入力して Return</translation>
    </message>
    <message>
        <source>Fz [N]</source>
        <translation>Fz [N]</translation>
    </message>
    <message>
        <source>Previous task</source>
        <translation>前の課題</translation>
    </message>
    <message>
        <source>Next task</source>
        <translation>次の課題</translation>
    </message>
    <message>
        <source>Practice · %1 of %2</source>
        <translation>練習 · %1 / %2</translation>
    </message>
    <message>
        <source>Starts or restarts the task</source>
        <translation>課題を開始または再開始します</translation>
    </message>
    <message>
        <source>Continues with the next task</source>
        <translation>次の課題へ進む</translation>
    </message>
    <message>
        <source>Available after the check above has passed</source>
        <translation>上の確認に合格すると使えます</translation>
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
        <translation>注意</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>未確認</translation>
    </message>
    <message>
        <source>Before you connect to %1</source>
        <translation>%1 に接続する前に</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>チェック項目</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>もう一度確認</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>Keep everyone out of reach of the arm.
Keep the emergency stop within reach: STOP in this window is a software stop.
Start slowly: the initial speed is %1.
Watch the arm, not the screen, while you hold a button.
Release the button to stop the arm.</source>
        <translation>アームの届く範囲に人を入れないでください。
非常停止を手の届く所に置いてください：このウィンドウの STOP はソフトウェア停止です。
ゆっくり始めてください：最初の速度は %1 です。
ボタンを押している間は画面ではなくアームを見てください。
ボタンを離すとアームは止まります。</translation>
    </message>
    <message>
        <source>Checking %1…</source>
        <translation>%1 を確認中…</translation>
    </message>
    <message>
        <source>Problems found</source>
        <translation>問題が見つかりました</translation>
    </message>
    <message>
        <source>Ready, with warnings</source>
        <translation>警告付きで準備完了</translation>
    </message>
    <message>
        <source>Everything is ready</source>
        <translation>すべて準備完了</translation>
    </message>
    <message>
        <source>Connect anyway</source>
        <translation>それでも接続</translation>
    </message>
    <message>
        <source>If you connect anyway, the window shows the available data. The red items above may prevent Tiller from taking control or may stop a running motion.</source>
        <translation>それでも接続すると、利用できるデータを表示します。上の赤い項目により、制御を取得できないことや、動作が停止することがあります。</translation>
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
        <translation>%1、無効</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>%1, running</source>
        <translation>%1、実行中</translation>
    </message>
    <message>
        <source>%1, breakpoint</source>
        <translation>%1、ブレークポイント</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1、変更あり</translation>
    </message>
</context>
<context>
    <name>tiller::ProgramTab</name>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>Show step</source>
        <translation>ステップを表示</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>Move steps</source>
        <translation>ステップを移動</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>「%1」を変更</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>More</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>Add steps, or edit the selected step</source>
        <translation>ステップの追加、または選択したステップの編集</translation>
    </message>
    <message>
        <source>Step fields</source>
        <translation>ステップの項目</translation>
    </message>
    <message>
        <source>New program</source>
        <translation>新しいプログラム</translation>
    </message>
    <message>
        <source>Rename program…</source>
        <translation>プログラムの名前を変更…</translation>
    </message>
    <message>
        <source>Delete program</source>
        <translation>プログラムを削除</translation>
    </message>
    <message>
        <source>Export script…</source>
        <translation>スクリプトを書き出す…</translation>
    </message>
    <message>
        <source>Paste steps</source>
        <translation>ステップを貼り付け</translation>
    </message>
    <message>
        <source>Cut steps</source>
        <translation>ステップを切り取り</translation>
    </message>
    <message>
        <source>Copy steps</source>
        <translation>ステップをコピー</translation>
    </message>
    <message>
        <source>Duplicate steps</source>
        <translation>ステップを複製</translation>
    </message>
    <message>
        <source>Delete steps</source>
        <translation>ステップを削除</translation>
    </message>
    <message>
        <source>Disable or enable steps</source>
        <translation>ステップを無効または有効にする</translation>
    </message>
    <message>
        <source>Move steps up</source>
        <translation>ステップを上へ移動</translation>
    </message>
    <message>
        <source>Move steps down</source>
        <translation>ステップを下へ移動</translation>
    </message>
    <message>
        <source>Move steps into the section above</source>
        <translation>ステップを上のセクションに入れる</translation>
    </message>
    <message>
        <source>Move steps out of the section</source>
        <translation>ステップをセクションから出す</translation>
    </message>
    <message>
        <source>Drag steps into the program, or double-click them.</source>
        <translation>ステップをプログラムにドラッグするか、ダブルクリックしてください。</translation>
    </message>
    <message>
        <source>⚠ Step %1: %2</source>
        <translation>⚠ ステップ %1: %2</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>The program can run. Press “Preview” to simulate it.</source>
        <translation>プログラムは実行できます。「プレビュー」を押すとシミュレーションします。</translation>
    </message>
    <message>
        <source>Add steps</source>
        <translation>ステップを追加</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>「%1」を追加</translation>
    </message>
    <message>
        <source>Rename program</source>
        <translation>プログラムの名前を変更</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>「%1」の名前を「%2」に変更</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>「%1」を削除</translation>
    </message>
    <message>
        <source>Disable steps</source>
        <translation>ステップを無効にする</translation>
    </message>
    <message>
        <source>Enable steps</source>
        <translation>ステップを有効にする</translation>
    </message>
    <message>
        <source>Simulating…</source>
        <translation>シミュレーション中…</translation>
    </message>
    <message>
        <source>Simulated: the program takes %1 s. No problems found.</source>
        <translation>シミュレーション結果: プログラムの所要時間は %1 s です。問題は見つかりませんでした。</translation>
    </message>
    <message numerus="yes">
        <source>⚠ Simulated: %n problem(s) found. %1</source>
        <translation>
            <numerusform>⚠ シミュレーション結果: %n 件の問題が見つかりました。%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Export script</source>
        <translation>スクリプトを書き出す</translation>
    </message>
    <message>
        <source>URScript (*.script)</source>
        <translation>URScript (*.script)</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>%1 に書き出しました</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>開始中…</translation>
    </message>
    <message>
        <source>Running step %1 (%2)</source>
        <translation>ステップ %1 (%2) を実行中</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>実行中</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>停止中…</translation>
    </message>
    <message>
        <source>Paused before step %1 (%2)</source>
        <translation>ステップ %1 (%2) の前で一時停止中</translation>
    </message>
    <message>
        <source>Pausing after step %1 (%2)</source>
        <translation>ステップ %1 (%2) の後で一時停止します</translation>
    </message>
    <message>
        <source>Simulated: two cycles of the endless program take %1 s. No problems found.</source>
        <translation>シミュレーション：エンドレスプログラムの2サイクルは%1秒です。問題はありません。</translation>
    </message>
    <message>
        <source>Check recoverability</source>
        <translation>続行可能性をチェック</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>チェックはキャンセルされました。</translation>
    </message>
    <message>
        <source>Cancel check</source>
        <translation>チェックをキャンセル</translation>
    </message>
    <message>
        <source>In simulation, the program can continue after a stop in %1 of %2 steps.</source>
        <translation>シミュレーションでは、%2ステップ中%1ステップで停止後にプログラムを続行できます。</translation>
    </message>
    <message>
        <source>Add or remove breakpoints</source>
        <translation>ブレークポイントの追加・削除</translation>
    </message>
    <message>
        <source>⚠ The program cannot pause before this step.</source>
        <translation>⚠ このステップの前では一時停止できません。</translation>
    </message>
    <message>
        <source>New breakpoints take effect at the next start.</source>
        <translation>新しいブレークポイントは次回の開始から有効です。</translation>
    </message>
    <message>
        <source>The program is running, so it cannot be deleted. Stop the program first.</source>
        <translation>プログラムが実行中のため削除できません。先にプログラムを停止してください。</translation>
    </message>
    <message>
        <source>Paused on the robot in step %1 (%2)</source>
        <translation>ステップ %1 (%2) でロボット側により一時停止中</translation>
    </message>
    <message>
        <source>Program “%1” deleted. Ctrl+Z restores it.</source>
        <translation>プログラム「%1」を削除しました。Ctrl+Z で元に戻せます。</translation>
    </message>
    <message>
        <source>Import program…</source>
        <translation>プログラムをインポート…</translation>
    </message>
    <message>
        <source>Import program</source>
        <translation>プログラムのインポート</translation>
    </message>
    <message>
        <source>Robot programs (*.script *.urp *.urpx);;All files (*)</source>
        <translation>ロボットプログラム (*.script *.urp *.urpx);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <translation>%1 をインポートしています…</translation>
    </message>
    <message>
        <source>Import “%1”</source>
        <translation>「%1」をインポート</translation>
    </message>
    <message>
        <source>Imported “%1”.</source>
        <translation>「%1」をインポートしました。</translation>
    </message>
    <message>
        <source>⚠ The import failed. The project is unchanged.</source>
        <translation>⚠ インポートに失敗しました。プロジェクトは変更されていません。</translation>
    </message>
    <message>
        <source>Step %1 (%2)</source>
        <translation>ステップ%1（%2）</translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation>未チェック: %1。</translation>
    </message>
    <message>
        <source>Checking recoverability…</source>
        <translation>続行可能性をチェック中…</translation>
    </message>
    <message>
        <source>⚠ Correct the problems in the program first.</source>
        <translation>⚠ 先にプログラムを修正してください。</translation>
    </message>
    <message>
        <source>Outputs were changed after the stop, so the program cannot continue. Run the program from the beginning.</source>
        <translation>停止後に出力が変更されたため、プログラムを再開できません。最初から実行してください。</translation>
    </message>
    <message>
        <source>The program was changed after the stop, so it cannot continue. Run the program from the beginning.</source>
        <translation>停止後にプログラムが変更されたため、再開できません。最初から実行してください。</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) changed because the project changed. Press “Preview” to simulate the program.</source>
        <translation>
            <numerusform>プロジェクトの変更により %n ステップが変わりました。「プレビュー」を押してプログラムをシミュレートしてください。</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused before step %1 (%2) because of the maximum hold time. Hold “Continue (hold)” to continue.</source>
        <translation>最大保持時間のため、ステップ %1 (%2) の前で一時停止中。続けるには「再開 (長押し)」を押し続けてください。</translation>
    </message>
    <message>
        <source>Running step %1 (%2). Joint moves are slow because the preview did not run the whole program from this position.</source>
        <translation>ステップ %1 (%2) を実行中。プレビューがこの位置からプログラム全体を実行していないため、関節動作は低速です。</translation>
    </message>
    <message>
        <source>Not run: %1.</source>
        <translation>未実行：%1。</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectDocument</name>
    <message>
        <source>Delete “%1”</source>
        <translation>「%1」を削除</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイントを削除</numerusform>
        </translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>順序を変更</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFiles</name>
    <message>
        <source>The damaged project file was kept as %1.</source>
        <translation>壊れたプロジェクトファイルを %1 として残しました</translation>
    </message>
    <message>
        <source>The project could not be saved</source>
        <translation>プロジェクトを保存できませんでした</translation>
    </message>
    <message>
        <source>%1. Update Tiller to open the file. The file was not changed.</source>
        <translation>%1。開くには Tiller を更新してください。ファイルはそのままです。</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>プロジェクトを開く</translation>
    </message>
    <message>
        <source>Tiller projects (*.tiller)</source>
        <translation>Tiller プロジェクト (*.tiller)</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>プロジェクトを保存</translation>
    </message>
    <message>
        <source>The project could not be opened</source>
        <translation>プロジェクトを開けませんでした</translation>
    </message>
    <message>
        <source>Opened a copy of “%1”. Save the copy to a file to keep changes.</source>
        <translation>「%1」のコピーを開きました。変更を残すにはファイルに保存してください。</translation>
    </message>
    <message>
        <source>“%1” is a copy with unsaved changes.</source>
        <translation>「%1」は未保存の変更があるコピーです。</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>名前を付けて保存…</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>変更を破棄</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation>%1 は壊れています</translation>
    </message>
    <message>
        <source>%1. Readable waypoints: %2, unreadable: %3. The damaged file is kept.</source>
        <translation>%1。読めるウェイポイント：%2、読めないもの：%3。壊れたファイルは残します。</translation>
    </message>
    <message numerus="yes">
        <source>Open %n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイントを開く</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes are saved to %1 again.</source>
        <translation>%1の保存を再開しました</translation>
    </message>
    <message>
        <source>The other window closed %1. This window saves changes again.</source>
        <translation>もう一方のウィンドウが%1を閉じました。このウィンドウは再び変更を保存します。</translation>
    </message>
    <message>
        <source>%1 is open in another window</source>
        <translation>%1は別のウィンドウで開かれています</translation>
    </message>
    <message>
        <source>Opened by %1. Changes in this window are not saved to the file until you take over the project.</source>
        <translation>%1が開いています。プロジェクトを引き継ぐまで、このウィンドウの変更はファイルに保存されません。</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>引き継ぐ</translation>
    </message>
    <message>
        <source>Save as a copy</source>
        <translation>コピーとして保存</translation>
    </message>
    <message>
        <source>View only</source>
        <translation>表示のみ</translation>
    </message>
    <message>
        <source>Another window or program has changed %1</source>
        <translation>別のウィンドウまたはプログラムが%1を変更しました</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>再読み込み</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>両方を残す</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>後で決める</translation>
    </message>
    <message>
        <source>Reloaded %1</source>
        <translation>%1を再読み込みしました</translation>
    </message>
    <message>
        <source>The project in this window is now %1.</source>
        <translation>このウィンドウのプロジェクトは%1になりました</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>無題のプロジェクト</translation>
    </message>
    <message>
        <source>Unsaved work can be recovered</source>
        <translation>未保存の作業を復元できます</translation>
    </message>
    <message>
        <source>“%1” was changed on %2 and not saved to a file.</source>
        <translation>「%1」は%2に変更されましたが、ファイルに保存されていません。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Ask again next time</source>
        <translation>次回また確認する</translation>
    </message>
    <message>
        <source>%1 has unsaved changes. %2</source>
        <translation>%1には未保存の変更があります。%2</translation>
    </message>
    <message>
        <source>The project has unsaved changes.</source>
        <translation>プロジェクトに未保存の変更があります。</translation>
    </message>
    <message>
        <source>“Keep both” saves the project of this window to a second file. “Reload” shows the new content. Tiller then offers to restore the unsaved changes at the next start.</source>
        <translation>「両方を残す」はこのウィンドウのプロジェクトを別のファイルに保存します。「再読み込み」は新しい内容を表示し、このウィンドウの未保存の変更は次回の起動時に提示されます。</translation>
    </message>
    <message>
        <source>Unreadable boxes and planes of the cell: %1. Collisions with these objects are not prevented.</source>
        <translation>読み取れないセルのボックスと平面: %1。それらとの衝突は防止されません。</translation>
    </message>
    <message>
        <source>The unsaved work in “%1” will be deleted. This cannot be undone.</source>
        <translation>「%1」の未保存の作業は削除されます。元に戻せません。</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>新しいプロジェクト</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 を保存しました</translation>
    </message>
    <message>
        <source>The project could not be taken over</source>
        <translation>プロジェクトを引き継げませんでした</translation>
    </message>
    <message>
        <source>%1 already exists. Choose a different name for the new project.</source>
        <translation>%1 は既に存在します。新しいプロジェクトに別の名前を選択してください。</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFit</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1ほか%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>TCP of %1</source>
        <translation>%1のTCP</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but a %2 is connected. The same joint positions lead to different poses.</source>
        <translation>プロジェクトは%1で教示されましたが、%2が接続されています。同じ関節位置でも姿勢が異なります。</translation>
    </message>
    <message>
        <source>The project uses the TCP “%1”. The active TCP of the robot differs by %2.</source>
        <translation>プロジェクトはTCP「%1」を使います。ロボットの有効なTCPは%2ずれています。</translation>
    </message>
    <message>
        <source>The project matches the connected robot.</source>
        <translation>プロジェクトは接続中のロボットに適合しています。</translation>
    </message>
    <message>
        <source>No robot is connected. Connect the robot that belongs to this project.</source>
        <translation>ロボットが接続されていません。このプロジェクト用のロボットを接続してください。</translation>
    </message>
    <message>
        <source>Keep poses</source>
        <translation>姿勢を維持</translation>
    </message>
    <message>
        <source>Keep joints</source>
        <translation>関節を維持</translation>
    </message>
    <message>
        <source>TCP differs from the project</source>
        <translation>TCPがプロジェクトと異なります</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>「%1」をロボットに設定</translation>
    </message>
    <message>
        <source>Keep the robot&apos;s TCP</source>
        <translation>ロボットのTCPを維持</translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same poses</source>
        <translation>%1から%2へ変換（姿勢を維持）</translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same joint positions</source>
        <translation>%1から%2へ変換（関節を維持）</translation>
    </message>
    <message>
        <source>Out of reach: %1.</source>
        <translation>到達不可：%1。</translation>
    </message>
    <message>
        <source>Removed because they are out of reach: %1. Press Ctrl+Z to restore them.</source>
        <translation>到達できないため削除しました：%1。元に戻すで復元できます。</translation>
    </message>
    <message>
        <source>Some positions are out of reach</source>
        <translation>到達できない位置があります</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>The robot model is not known yet. Wait until the robot reports the model.</source>
        <translation>ロボットの機種がまだ不明です。ロボットが報告するまで待ってください。</translation>
    </message>
    <message>
        <source>Project for a different robot model</source>
        <translation>別のロボットモデル用のプロジェクト</translation>
    </message>
    <message>
        <source>“Keep poses” recalculates the joint positions; the tool reaches the same poses. “Keep joints” keeps the arm configuration; the tool reaches different poses. Until you decide, moves to positions in the project are blocked.</source>
        <translation>「姿勢を維持」は関節位置を再計算し、ツールは同じ姿勢に到達します。「関節を維持」はアームの構成を保ち、ツールは別の姿勢に到達します。決定するまで、プロジェクトの位置への動作はできません。</translation>
    </message>
    <message>
        <source>With the robot&apos;s TCP, the flange moves to the same poses as taught, but the TCP does not. Until you decide, moves to positions in the project are blocked.</source>
        <translation>ロボットのTCPでは、フランジは教示された姿勢に到達しますが、TCPは到達しません。決定するまで、プロジェクトの位置への動作はできません。</translation>
    </message>
    <message>
        <source>Moves to positions in this project are blocked</source>
        <translation>このプロジェクトの位置への動作はできません</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectStore</name>
    <message>
        <source>%1 — a copy, not saved to a file</source>
        <translation>%1 — 写し、ファイル未保存</translation>
    </message>
    <message>
        <source>Project not saved to a file</source>
        <translation>プロジェクトはファイル未保存</translation>
    </message>
    <message>
        <source>disk full</source>
        <translation>ディスクが一杯</translation>
    </message>
    <message>
        <source>%1 — not saved: %2</source>
        <translation>%1 — 未保存：%2</translation>
    </message>
    <message>
        <source>%1 — saving…</source>
        <translation>%1 — 保存中…</translation>
    </message>
    <message>
        <source>%1 — saved</source>
        <translation>%1 — 保存済み</translation>
    </message>
    <message>
        <source>No file is selected for the project. Save the project to a file first.</source>
        <translation>プロジェクトのファイルが選択されていません。先にプロジェクトをファイルに保存してください。</translation>
    </message>
    <message>
        <source>%1 — open in another window; changes here are not saved</source>
        <translation>%1 — 別のウィンドウで開かれているため、ここでの変更は保存されません</translation>
    </message>
    <message>
        <source>%1 — changed by another program; changes here are not saved</source>
        <translation>%1 — 別のプログラムが変更したため、ここでの変更は保存されません</translation>
    </message>
    <message>
        <source>Unsaved project</source>
        <translation>未保存のプロジェクト</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>別のプログラム</translation>
    </message>
    <message>
        <source>%1 — new</source>
        <translation>%1 — 新規</translation>
    </message>
    <message>
        <source>%1 is open in another window (%2). Close the project in that window, or save under a different name.</source>
        <translation>%1 は別のウィンドウで開かれています（%2）。そこで閉じるか、別の名前で保存してください。</translation>
    </message>
    <message>
        <source>%1 was changed by another program. Reload the project, or save it under a different name.</source>
        <translation>%1 は別のプログラムによって変更されました。再読み込みするか、別の名前で保存してください。</translation>
    </message>
</context>
<context>
    <name>tiller::RangeStatisticsCache</name>
    <message>
        <source>The range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation>この範囲には異なるロボットのサンプルが含まれています。カーソル A と B を 1 台のロボットのデータに置いてください。</translation>
    </message>
</context>
<context>
    <name>tiller::RecordingsDialog</name>
    <message>
        <source>Recordings</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>フォルダーを選択</translation>
    </message>
    <message>
        <source>Search recordings</source>
        <translation>記録を検索</translation>
    </message>
    <message>
        <source>Search name, date, metadata and notes</source>
        <translation>名前、日付、メタデータ、メモを検索</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>メタデータ</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>This folder contains no recordings.</source>
        <translation>このフォルダーに記録はありません。</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n recording(s)</source>
        <translation>
            <numerusform>%n 件中 %1 件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reading %n file(s)…</source>
        <translation>
            <numerusform>%n 個のファイルを読み込み中…</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder with recordings</source>
        <translation>記録のフォルダー</translation>
    </message>
</context>
<context>
    <name>tiller::RecoveryPage</name>
    <message>
        <source>Recovery</source>
        <translation>復旧</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>TCP の力</translation>
    </message>
    <message>
        <source>Joint current</source>
        <translation>関節電流</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>TCP の速度</translation>
    </message>
    <message>
        <source>Waiting for data from the robot…</source>
        <translation>ロボットのデータを待っています…</translation>
    </message>
    <message>
        <source>Stopped at X %1, Y %2, Z %3.</source>
        <translation>停止位置 X %1、Y %2、Z %3。</translation>
    </message>
    <message>
        <source>Suspected joint: %1 (largest deviation from its target current).</source>
        <translation>疑わしい関節：%1（電流が目標から最も外れた）。</translation>
    </message>
    <message>
        <source> (%1 s)</source>
        <translation> (%1 s)</translation>
    </message>
    <message>
        <source>Tick the items that you have checked.</source>
        <translation>確認した項目に印を付けてください。</translation>
    </message>
    <message>
        <source>Command sent; waiting for the robot…</source>
        <translation>コマンドを送信しました。ロボットを待っています…</translation>
    </message>
</context>
<context>
    <name>tiller::RegisterPanel</name>
    <message>
        <source>General purpose registers</source>
        <translation>汎用レジスター</translation>
    </message>
    <message>
        <source>Int %1</source>
        <translation>整数 %1</translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation>実数 %1</translation>
    </message>
    <message>
        <source>Int</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>実数</translation>
    </message>
    <message>
        <source>Bit</source>
        <translation>ビット</translation>
    </message>
    <message>
        <source>Input register type</source>
        <translation>入力レジスターの種類</translation>
    </message>
    <message>
        <source>Input register number</source>
        <translation>入力レジスターの番号</translation>
    </message>
    <message>
        <source>Input register value</source>
        <translation>入力レジスターの値</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>書き込む</translation>
    </message>
</context>
<context>
    <name>tiller::ReplayBand</name>
    <message>
        <source>Replay</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>ライブに戻る</translation>
    </message>
    <message>
        <source>Show the current state of the robot. The recording stays open in the plots.</source>
        <translation>ロボットの現在の動きを表示します。記録はグラフに開いたまま残ります。</translation>
    </message>
</context>
<context>
    <name>tiller::RobotPopup</name>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Popup on the robot</source>
        <translation>ロボットのポップアップ</translation>
    </message>
    <message>
        <source>Tiller could not close the popup. Close the popup on the teach pendant.</source>
        <translation>Tiller はポップアップを閉じられませんでした。ティーチペンダントで閉じてください。</translation>
    </message>
    <message>
        <source>No data from the robot. Close the popup on the teach pendant.</source>
        <translation>ロボットからのデータがありません。ティーチペンダントでポップアップを閉じてください。</translation>
    </message>
    <message numerus="yes">
        <source>%n more popup(s) on the robot.</source>
        <translation>
            <numerusform>ロボットに他 %n 件。</numerusform>
        </translation>
    </message>
    <message>
        <source>A waiting program continues when the popup is closed: keep clear of the arm.</source>
        <translation>待っているプログラムは閉じると続きます：アームから離れてください。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隠す</translation>
    </message>
    <message>
        <source>Close the popup on the robot</source>
        <translation>ロボットのポップアップを閉じる</translation>
    </message>
    <message>
        <source>Hide the popup</source>
        <translation>ポップアップを隠す</translation>
    </message>
    <message>
        <source>Read the popup first.</source>
        <translation>先にポップアップを読んでください。</translation>
    </message>
    <message>
        <source>The popup is being closed.</source>
        <translation>ポップアップを閉じています。</translation>
    </message>
</context>
<context>
    <name>tiller::RobotSession</name>
    <message>
        <source>Stopped: %1 (%2 ms, %3)</source>
        <translation>停止：%1（%2 ms、%3）</translation>
    </message>
    <message>
        <source>Connecting to %1 (%2)</source>
        <translation>%1（%2）に接続中</translation>
    </message>
    <message>
        <source>Disconnected from %1</source>
        <translation>%1 から切断</translation>
    </message>
    <message>
        <source>In control</source>
        <translation>制御中</translation>
    </message>
    <message>
        <source>Taking control was cancelled by a stop.</source>
        <translation>停止により制御の取得が中止されました。</translation>
    </message>
    <message>
        <source>Connected to %1</source>
        <translation>%1 に接続</translation>
    </message>
    <message>
        <source>Safety mode is Normal again</source>
        <translation>安全モードが「通常」に戻りました</translation>
    </message>
    <message>
        <source>Program: %1</source>
        <translation>プログラム：%1</translation>
    </message>
    <message>
        <source>Program error on line %1, column %2: %3</source>
        <translation>プログラムエラー 行 %1、列 %2：%3</translation>
    </message>
    <message>
        <source>Popup on the robot: %1 %2</source>
        <translation>ロボットのポップアップ：%1 %2</translation>
    </message>
    <message>
        <source>The program on the robot is waiting for a response on the teach pendant: %1</source>
        <translation>ロボットのプログラムがティーチペンダントでの応答を待っています：%1</translation>
    </message>
    <message>
        <source>Not connected to a robot.</source>
        <translation>ロボットに接続していません。</translation>
    </message>
    <message>
        <source>Waiting for data from %1.</source>
        <translation>%1 のデータを待っています。</translation>
    </message>
    <message>
        <source>Connecting to %1…</source>
        <translation>%1 に接続中…</translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically; motion does not resume.</source>
        <translation>ロボットからのデータなし。自動で再接続します。動作は再開しません。</translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation>ロボットのデータが遅れています。新しいデータを待っています。</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>制御を取得中…</translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. STOP still works.</source>
        <translation>監視のみ：このウィンドウはロボットを変更しません。STOPは使えます。</translation>
    </message>
    <message>
        <source>“Monitor only” is off. Commands to the robot are enabled.</source>
        <translation>「監視のみ」はオフです。ロボットへの指令が可能です。</translation>
    </message>
    <message>
        <source>%1: refused. %2</source>
        <translation>%1：拒否されました。%2</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>制御を取得</translation>
    </message>
    <message>
        <source>Control was lost: the control connection did not respond for 0.5 s or was closed. STOP, Space and Esc still stop the robot. Take control again.</source>
        <translation>制御が失われました：制御用の接続が0.5秒間応答しなかったか、閉じられました。STOP、Space、Escでロボットを停止できます。もう一度制御を取得してください。</translation>
    </message>
    <message numerus="yes">
        <source>The robot is sending too many messages. %n messages were not shown.</source>
        <translation>
            <numerusform>ロボットからのメッセージが多すぎます。%n 件は表示されませんでした。</numerusform>
        </translation>
    </message>
    <message>
        <source>Move refused: %1.</source>
        <translation>移動を拒否しました：%1。</translation>
    </message>
    <message>
        <source>Moves are refused. %1.</source>
        <translation>移動は拒否されます。%1。</translation>
    </message>
    <message>
        <source>No data from the robot: the arm may be moving. Reconnecting automatically.</source>
        <translation>ロボットからのデータがありません。アームが動いている可能性があります。自動的に再接続します。</translation>
    </message>
    <message>
        <source>A program is running. Wait until the program ends, or stop the program.</source>
        <translation>プログラムを実行中です。終了するまで待つか、停止してください。</translation>
    </message>
    <message>
        <source>Stopping the other client&apos;s program to take control.</source>
        <translation>制御を取得するため、別のクライアントのプログラムを停止します。</translation>
    </message>
    <message>
        <source>The program on the robot is paused.</source>
        <translation>ロボットのプログラムは一時停止中です。</translation>
    </message>
    <message>
        <source>Robot mode: %1</source>
        <translation>ロボットモード: %1</translation>
    </message>
    <message>
        <source>Stopped: %1 (%2)</source>
        <translation>停止: %1 (%2)</translation>
    </message>
    <message>
        <source>Not stopped: a program is still running (%1). Press STOP again.</source>
        <translation>停止していません: プログラムがまだ実行中です (%1)。もう一度 STOP を押してください。</translation>
    </message>
    <message>
        <source>Not stopped: the arm is still moving (%1). Press STOP again.</source>
        <translation>停止していません：アームが動いています (%1)。もう一度 STOP を押してください。</translation>
    </message>
    <message>
        <source>The robot at %1 is a %2 now. It was a %3 before.</source>
        <translation>%1 のロボットは %2 に変わりました。以前は %3 でした。</translation>
    </message>
    <message>
        <source>A program from another client has replaced the running program.</source>
        <translation>他のクライアントのプログラムが、実行中のプログラムを置き換えました。</translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot. Taking control ends that program.</source>
        <translation>別のクライアントのプログラムがロボットを制御しています。制御を取得すると、そのプログラムは終了します。</translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot, and control was lost. Taking control again ends that program.</source>
        <translation>別のクライアントのプログラムがロボットを制御したため、制御を失いました。もう一度制御を取得すると、そのプログラムは終了します。</translation>
    </message>
    <message>
        <source>A program from another client is running on the robot.</source>
        <translation>ロボットで別のクライアントのプログラムが実行中です。</translation>
    </message>
    <message>
        <source>while moving to point %1 of %2: %3</source>
        <translation>%2 点中 %1 点目への移動中: %3</translation>
    </message>
    <message>
        <source>The program from the other client has ended.</source>
        <translation>他のクライアントのプログラムが終了しました。</translation>
    </message>
    <message>
        <source>The program started while Tiller was not connected, at most %1 s before this entry.</source>
        <translation>プログラムは Tiller との接続がない間に開始されました。この記録の最大 %1 秒前です。</translation>
    </message>
</context>
<context>
    <name>tiller::RobotiqLink</name>
    <message>
        <source>Connecting to the gripper…</source>
        <translation>グリッパーに接続中…</translation>
    </message>
    <message>
        <source>The gripper does not send any values. Power on the arm. If the problem persists, check the gripper cable at the wrist.</source>
        <translation>グリッパーの値がありません。アームの電源を入れてください。直らなければ手首のグリッパーのケーブルを確認してください。</translation>
    </message>
    <message>
        <source>The gripper responds again.</source>
        <translation>グリッパーが再び応答しました。</translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation>グリッパーは有効です。</translation>
    </message>
    <message>
        <source>The gripper was not activated. Check that nothing blocks its fingers, then press “Activate” again.</source>
        <translation>グリッパーが有効になりませんでした。指を妨げるものがないか見て、もう一度「有効化」を押してください。</translation>
    </message>
    <message>
        <source>The gripper holds an object (%1 open).</source>
        <translation>グリッパーが物体をつかんでいます（開き %1）。</translation>
    </message>
    <message>
        <source>The gripper lost the object.</source>
        <translation>グリッパーがつかんだ物体を失いました。</translation>
    </message>
    <message>
        <source>Gripper: activate</source>
        <translation>グリッパー：有効化</translation>
    </message>
    <message>
        <source>%1 failed. %2</source>
        <translation>%1 に失敗しました。%2</translation>
    </message>
    <message>
        <source>No gripper service responds at %1:%2. Install Robotiq&apos;s URCap on the robot and select the gripper in the robot&apos;s installation.</source>
        <translation>%1:%2 でグリッパーの応答がありません。ロボットに Robotiq の URCap を入れ、インストールでグリッパーを選んでください。</translation>
    </message>
    <message>
        <source>The gripper is not responding. Check the cable at the wrist and the gripper settings on the Installation tab of the teach pendant. If the problem persists, restart the robot.</source>
        <translation>グリッパーが応答しません。手首のケーブルと、ティーチペンダントの「インストール」タブのグリッパー設定を確認してください。直らなければロボットを再起動してください。</translation>
    </message>
    <message>
        <source>The gripper did not accept the command. Activate the gripper. If it is already active, check its settings on the Installation tab of the teach pendant.</source>
        <translation>グリッパーがコマンドを受け付けませんでした。有効化してください。すでに有効なら、ティーチペンダントの「インストール」タブで設定を確認してください。</translation>
    </message>
    <message>
        <source>The gripper is activating; the command runs afterwards.</source>
        <translation>グリッパーを有効化中です。指令はその後に実行されます。</translation>
    </message>
    <message>
        <source>The gripper received a motion command before it was active. Press “Activate”.</source>
        <translation>グリッパーは有効になる前に動作指令を受けました。「有効化」を押してください。</translation>
    </message>
    <message>
        <source>The gripper is too hot. Let it cool down, then press “Activate”.</source>
        <translation>グリッパーが熱すぎます。冷ましてから「有効化」を押してください。</translation>
    </message>
    <message>
        <source>The gripper received no command for one second. Check its cable at the wrist, then press “Activate”.</source>
        <translation>グリッパーに 1 秒間指令が届きませんでした。手首のケーブルを確認し、「有効化」を押してください。</translation>
    </message>
    <message>
        <source>The supply voltage of the gripper is too low. Set the tool voltage to 24 V, then press “Activate”.</source>
        <translation>グリッパーの電圧が低すぎます。ツール電圧を 24 V にして「有効化」を押してください。</translation>
    </message>
    <message>
        <source>The automatic release of the gripper is in progress. Wait until it is complete, then press “Activate”.</source>
        <translation>グリッパーの自動解放中です。終わるのを待って「有効化」を押してください。</translation>
    </message>
    <message>
        <source>The automatic release of the gripper is complete. Press “Activate”.</source>
        <translation>グリッパーの自動解放が終わりました。「有効化」を押してください。</translation>
    </message>
    <message>
        <source>The gripper has an internal fault. Press “Activate”. If the fault returns, contact Robotiq.</source>
        <translation>グリッパーの内部故障です。「有効化」を押してください。再発したら Robotiq に問い合わせてください。</translation>
    </message>
    <message>
        <source>Activation failed. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation>有効化に失敗しました。指を妨げるものがないか見て「有効化」を押してください。</translation>
    </message>
    <message>
        <source>The gripper draws too much current. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation>グリッパーの電流が大きすぎます。指を妨げるものがないか見て「有効化」を押してください。</translation>
    </message>
    <message>
        <source>The gripper reports fault %1. Press “Activate”. If the fault returns, see the gripper manual.</source>
        <translation>グリッパーが故障 %1 を報告しています。「有効化」を押してください。再発したら説明書を見てください。</translation>
    </message>
    <message>
        <source>The robot closed the connection to the gripper and may be restarting. Tiller reconnects automatically; the gripper continues to hold its object.</source>
        <translation>ロボットがグリッパーとの接続を終えました。再起動中かもしれません。自動で戻ります。グリッパーはつかみ続けます。</translation>
    </message>
</context>
<context>
    <name>tiller::RouteRunner</name>
    <message>
        <source>The route has no waypoints. Teach or select waypoints first.</source>
        <translation>ルートにウェイポイントがありません。先に教示するか選択してください。</translation>
    </message>
    <message>
        <source>A waypoint of the route was deleted from the project. Select the waypoints of the route again.</source>
        <translation>ルートのウェイポイントがプロジェクトから削除されました。ルートのウェイポイントを選び直してください。</translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation>「%1」：%2</translation>
    </message>
    <message>
        <source>A loop requires at least two waypoints. Select more waypoints, or clear “Loop”.</source>
        <translation>繰り返しには 2 つ以上のウェイポイントが必要です。ウェイポイントを追加で選択するか、繰り返しをオフにしてください。</translation>
    </message>
    <message>
        <source>There is no waypoint before the first waypoint of the route.</source>
        <translation>ルートの最初のウェイポイントには、前のウェイポイントがありません。</translation>
    </message>
</context>
<context>
    <name>tiller::RunBar</name>
    <message>
        <source>Run (hold)</source>
        <translation>実行 (長押し)</translation>
    </message>
    <message>
        <source>Run the program (hold)</source>
        <translation>プログラムを実行、長押し</translation>
    </message>
    <message>
        <source>Move to start (hold)</source>
        <translation>開始位置へ (長押し)</translation>
    </message>
    <message>
        <source>Move to the start position (hold)</source>
        <translation>開始位置へ移動、長押し</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>No program is selected. Create or select a program first.</source>
        <translation>プログラムが選択されていません。先に作成するか選択してください。</translation>
    </message>
    <message>
        <source>Stops the program</source>
        <translation>プログラムを停止します</translation>
    </message>
    <message>
        <source>Runs the program at the programmed speed until it ends or is stopped. The arm also stops when Tiller closes or the connection is lost.</source>
        <translation>プログラムを設定された速度で、終了または停止まで実行します。Tiller を閉じるか接続が切れた場合もアームは停止します。</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Finish cycle</source>
        <translation>サイクル終了</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation>実行中のプログラムはありません。</translation>
    </message>
    <message>
        <source>Continues the program</source>
        <translation>プログラムを続行します</translation>
    </message>
    <message>
        <source>Pauses the program before its next step</source>
        <translation>次のステップの前でプログラムを一時停止します</translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation>先にプログラムを一時停止してください。</translation>
    </message>
    <message>
        <source>Runs one step and then pauses the program</source>
        <translation>1 ステップ実行してからプログラムを一時停止します</translation>
    </message>
    <message>
        <source>The program has no endless loop.</source>
        <translation>プログラムに無限ループがありません。</translation>
    </message>
    <message>
        <source>Ends the program before the next cycle of its endless loop</source>
        <translation>無限ループの次のサイクルの前にプログラムを終了します</translation>
    </message>
    <message>
        <source>Start from here</source>
        <translation>ここから</translation>
    </message>
    <message>
        <source>Select one step.</source>
        <translation>ステップを 1 つ選択してください。</translation>
    </message>
    <message>
        <source>Moves all joints to the start position while the button is held</source>
        <translation>ボタンを押している間、全関節を開始位置へ動かします</translation>
    </message>
    <message>
        <source>Continue at %1</source>
        <translation>%1から続行</translation>
    </message>
    <message>
        <source>Continue (hold)</source>
        <translation>再開 (長押し)</translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation>プログラムはロボット側で一時停止中です。ティーチペンダントで再開してください。</translation>
    </message>
    <message>
        <source>Run program</source>
        <translation>プログラムの実行</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>The value of “%1” is being changed.</source>
        <translation>「%1」の値を変更しています。</translation>
    </message>
    <message>
        <source>Continue program</source>
        <translation>プログラムの続行</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>続行</translation>
    </message>
    <message>
        <source>From step %1 ✕</source>
        <translation>%1 から ✕</translation>
    </message>
    <message>
        <source>Starts the program at the selected step. Move the arm to the start position first.</source>
        <translation>選択したステップからプログラムを開始します。先にアームを開始位置へ移動してください。</translation>
    </message>
    <message>
        <source>Hold “Continue (hold)” to continue.</source>
        <translation>続けるには「再開 (長押し)」を押し続けてください。</translation>
    </message>
    <message>
        <source>The preview did not run %1, so these steps were not checked for collisions and other problems. Test them with “Run (hold)”, or set the inputs and preview the program again.</source>
        <translation>プレビューで実行されていないステップがあります（%1）。これらのステップの衝突などの問題は確認されていません。「実行 (長押し)」で試すか、入力を設定してもう一度プレビューしてください。</translation>
    </message>
    <message>
        <source>A variable was changed. The moves after this change were not previewed, so they were not checked for collisions and other problems.</source>
        <translation>変数が変更されました。変更後の動作はプレビューされていないため、衝突などの問題は確認されていません。</translation>
    </message>
    <message>
        <source>Runs the program while the button is held, no faster than the jog speed. The program ends when you release the button. If the arm is not at the start position of a complete preview, joint moves are slower so that no possible path exceeds the speed limit.</source>
        <translation>ボタンを押している間、ジョグ速度以下でプログラムを実行します。ボタンを離すとプログラムは終了します。アームが完全なプレビューの開始位置にない場合、考えられるすべての経路で速度制限を守るため、関節移動は遅くなります。</translation>
    </message>
    <message>
        <source>The program starts at step %1. Press to start from the beginning instead.</source>
        <translation>プログラムはステップ %1 から開始します。押すと、再び最初から開始します。</translation>
    </message>
    <message>
        <source>The program started with a jog speed of %1 and cannot continue at a lower speed. Select this speed again, or stop the program.</source>
        <translation>プログラムはジョグ速度 %1 で開始されたため、より低い速度では再開できません。この速度をもう一度選択するか、プログラムを停止してください。</translation>
    </message>
    <message>
        <source>%1 Preview the program with the current inputs, or select a higher jog speed, so that the program can run to the end.</source>
        <translation>%1 最後まで実行できるように、現在の入力でプログラムをプレビューするか、より高いジョグ速度を選択してください。</translation>
    </message>
</context>
<context>
    <name>tiller::SceneDock</name>
    <message>
        <source>View</source>
        <translation>ビュー</translation>
    </message>
    <message>
        <source>No joint positions to replay</source>
        <translation>再生する関節位置がありません</translation>
    </message>
    <message>
        <source>Robot model unknown</source>
        <translation>ロボットの機種が不明</translation>
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
        <translation>標準の視点（透視）</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Look from the front: base X to the right, Z up</source>
        <translation>正面から見る：ベースの X が右、Z が上</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側面</translation>
    </message>
    <message>
        <source>Look from the side: base Y to the right, Z up</source>
        <translation>側面から見る：ベースの Y が右、Z が上</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Look from above: base X to the right, Y up</source>
        <translation>上から見る：ベースの X が右、Y が上</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>全体</translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view</source>
        <translation>アーム、目標、ウェイポイントを収める</translation>
    </message>
</context>
<context>
    <name>tiller::SceneView</name>
    <message>
        <source>Arm view</source>
        <translation>アームのビュー</translation>
    </message>
    <message>
        <source>Drag or use the arrow keys to rotate the view; hold Shift or the right button to pan. Zoom with the wheel or with plus and minus. Double-click or press Home for the default view. The robot does not move.</source>
        <translation>ドラッグか矢印キーで別の向きから見ます。Shift か右ボタンで画面を動かし、ホイールかプラスとマイナスで近づき、ダブルクリックか Home で最初の向きに戻ります。ここでロボットは動きません。</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>データなし</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>未接続</translation>
    </message>
    <message>
        <source>ghost “%1” · out of reach</source>
        <translation>ゴースト「%1」 · 到達不可</translation>
    </message>
    <message>
        <source>ghost “%1” · reachable · largest rotation %2 %3 · %4 s at %5</source>
        <translation>ゴースト「%1」 · 到達可能 · 最大回転 %2 %3 · %5 で %4 s</translation>
    </message>
    <message>
        <source>1 name hidden: zoom in</source>
        <translation>名前 1 件を隠しています：拡大してください</translation>
    </message>
    <message numerus="yes">
        <source>%n names hidden: zoom in</source>
        <translation>
            <numerusform>名前 %n 件を隠しています：拡大してください</numerusform>
        </translation>
    </message>
    <message>
        <source>ghost “%1” · reachable</source>
        <translation>ゴースト「%1」 · 到達可能</translation>
    </message>
    <message>
        <source>ghost “%1” · %2 · largest rotation %3 %4 · %5 s at %6</source>
        <translation>ゴースト「%1」 · %2 · 最大回転 %3 %4 · %6 で %5 s</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>変更後: %1</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>変更前: %1</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>再生中</translation>
    </message>
    <message>
        <source>LIVE ARM</source>
        <translation>現在のアーム</translation>
    </message>
    <message>
        <source>ghost “%1” · taught with a different robot model</source>
        <translation>ゴースト「%1」· 別の機種で教示</translation>
    </message>
</context>
<context>
    <name>tiller::SignalStore</name>
    <message>
        <source>compute a signal</source>
        <translation>信号を計算する</translation>
    </message>
    <message>
        <source>%1 is not part of the same RTDE packets as the other signals.</source>
        <translation>%1 は他の信号と同じ RTDE パケットに含まれません。</translation>
    </message>
    <message>
        <source>Derived</source>
        <translation>派生</translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. Remove other signals first.</source>
        <translation>ロボットが一度に送れる信号を超えます：先に他を外してください。</translation>
    </message>
    <message>
        <source>The recording %1 contains no samples. Open a different recording.</source>
        <translation>記録 %1 にサンプルがありません。別の記録を開いてください。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2 の %1</translation>
    </message>
    <message>
        <source>The history memory is too small to show %1. Increase the memory in the “Layout” menu.</source>
        <translation>%1 を表示する履歴メモリーが足りません：メニュー「配置」で増やしてください。</translation>
    </message>
    <message>
        <source>%1 could not be computed completely: %2</source>
        <translation>%1 を完全には計算できませんでした: %2</translation>
    </message>
</context>
<context>
    <name>tiller::SignalTree</name>
    <message>
        <source>Search signals</source>
        <translation>信号を検索</translation>
    </message>
    <message>
        <source>Robot signals</source>
        <translation>ロボットの信号</translation>
    </message>
    <message>
        <source>New: |F| [N] = norm(…)</source>
        <translation>新規：|F| [N] = norm(…)</translation>
    </message>
    <message>
        <source>Derived signal</source>
        <translation>派生信号</translation>
    </message>
    <message>
        <source>%1: not sent by this robot.</source>
        <translation>%1：このロボットは送りません。</translation>
    </message>
    <message>
        <source>Enter a name, an optional unit in brackets, and an expression that uses signals. Drag signals here to insert their names. Functions: norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ and standard functions. Press Return to create the signal.</source>
        <translation>名前、必要なら角括弧の単位、信号の式を入力します。信号をここへドラッグすると名前が入ります。関数：norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ と標準関数。Return で作成します。</translation>
    </message>
</context>
<context>
    <name>tiller::SimulationChip</name>
    <message>
        <source>Simulation</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>This robot is simulated. No real robot moves.</source>
        <translation>このロボットはシミュレーションです。実際のロボットは動きません。</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>シミュレーション</translation>
    </message>
</context>
<context>
    <name>tiller::SpeedChip</name>
    <message>
        <source>Speed slider</source>
        <translation>速度スライダー</translation>
    </message>
    <message>
        <source>Robot speed slider, 2 to 100 %</source>
        <translation>ロボットの速度スライダー、2〜100 %</translation>
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
        <translation>記録、プロジェクト、最後のメッセージ</translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation>REC %1</translation>
    </message>
    <message>
        <source>%1 samples · %2 · %3 free</source>
        <translation>%1 サンプル · %2 · 空き %3</translation>
    </message>
    <message>
        <source>Recording stopped</source>
        <translation>記録が終わりました</translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation>記録していません</translation>
    </message>
</context>
<context>
    <name>tiller::StepForm</name>
    <message>
        <source>Select one step to edit it.</source>
        <translation>編集するステップを 1 つ選択してください。</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(なし)</translation>
    </message>
</context>
<context>
    <name>tiller::StepPalette</name>
    <message>
        <source>Steps to add</source>
        <translation>追加できるステップ</translation>
    </message>
</context>
<context>
    <name>tiller::StepTree</name>
    <message>
        <source>Program steps</source>
        <translation>プログラムのステップ</translation>
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
        <translation>ソフトウェア停止。非常停止ではありません。電源は入ったままです。</translation>
    </message>
    <message>
        <source>Space and Esc also stop the arm.</source>
        <translation>SpaceとEscでもアームが停止します。</translation>
    </message>
    <message>
        <source>Click to stop the arm. Space and Esc stop the arm only while this window is in control.</source>
        <translation>クリックで停止します。SpaceとEscは、このウィンドウが制御中のときだけ停止します。</translation>
    </message>
    <message>
        <source>Space / Esc</source>
        <translation>Space / Esc</translation>
    </message>
    <message>
        <source>click</source>
        <translation>クリック</translation>
    </message>
    <message>
        <source>not an e-stop</source>
        <translation>非常停止ではない</translation>
    </message>
</context>
<context>
    <name>tiller::StopPlot</name>
    <message>
        <source>Maximum in the last five seconds: %1</source>
        <translation>直近 5 秒の最大値：%1</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>no data before the stop</source>
        <translation>停止前のデータなし</translation>
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
        <translation>TCP の名前を入力してください。</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>「%1」を「%2」に名前変更</translation>
    </message>
    <message>
        <source>TCPs</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>No TCPs yet.
Press “From robot” to store the active TCP, or “Teach…” to teach a TCP with the arm.</source>
        <translation>TCP はまだありません。
「ロボットから」で現在のものを採用するか、「教示…」でアームで求めてください。</translation>
    </message>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>Relative to the flange. Press Return to apply the value to the project. The robot&apos;s TCP does not change.</source>
        <translation>フランジに対する値。Return でプロジェクトに適用します。ロボットの TCP は変わりません。</translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation>ロボットに設定</translation>
    </message>
    <message>
        <source>Use this TCP and set it on the robot</source>
        <translation>この TCP を使い、ロボットに設定する</translation>
    </message>
    <message>
        <source>Teach…</source>
        <translation>教示…</translation>
    </message>
    <message>
        <source>Teach a TCP with the arm</source>
        <translation>アームで TCP を教示</translation>
    </message>
    <message>
        <source>From robot</source>
        <translation>ロボットから</translation>
    </message>
    <message>
        <source>Store the active TCP of the robot</source>
        <translation>ロボットの有効な TCP を保存</translation>
    </message>
    <message>
        <source>Teach the selected TCP again…</source>
        <translation>選んだ TCP を教示し直す…</translation>
    </message>
    <message>
        <source>Enter new TCP</source>
        <translation>新しい TCP を入力</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Rename TCP</source>
        <translation>TCP の名前を変更</translation>
    </message>
    <message>
        <source>Duplicate TCP</source>
        <translation>TCP を複製</translation>
    </message>
    <message>
        <source>Delete TCP</source>
        <translation>TCP を削除</translation>
    </message>
    <message>
        <source>Change the TCP “%1”</source>
        <translation>TCP「%1」を変更</translation>
    </message>
    <message>
        <source>Teach the TCP “%1” again</source>
        <translation>TCP「%1」を教示し直す</translation>
    </message>
    <message>
        <source>Add the TCP “%1”</source>
        <translation>TCP「%1」を追加</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>ロボット未接続。接続するか、シミュレーターを試してください。</translation>
    </message>
    <message>
        <source>The active TCP of the robot is already stored as “%1”.</source>
        <translation>ロボットで有効な TCP は「%1」として既に保存されています。</translation>
    </message>
    <message>
        <source>Teach “%1” again</source>
        <translation>「%1」を教示し直す</translation>
    </message>
    <message>
        <source>Teach a new TCP</source>
        <translation>新しい TCP を教示</translation>
    </message>
    <message>
        <source>Select the TCP to set.</source>
        <translation>設定する TCP を選んでください。</translation>
    </message>
    <message>
        <source>Use the TCP “%1”</source>
        <translation>TCP「%1」を使う</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller は制御中ではありません。先に制御を取得してください。</translation>
    </message>
    <message>
        <source>Delete the TCP “%1”</source>
        <translation>TCP「%1」を削除</translation>
    </message>
    <message>
        <source>%1, relative to the flange</source>
        <translation>%1、フランジから</translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation>%1、ロボットで有効</translation>
    </message>
    <message>
        <source>%1, %2 from the robot&apos;s TCP</source>
        <translation>%1、ロボットのものから %2</translation>
    </message>
    <message>
        <source>The robot&apos;s TCP differs from “%1”</source>
        <translation>ロボットの TCP は「%1」と異なります</translation>
    </message>
    <message>
        <source>On the robot: %1. In the project: %2. Difference: %3. Nothing was changed.</source>
        <translation>ロボット：%1。プロジェクト：%2。差は %3。何も変わっていません。</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>「%1」をロボットに設定</translation>
    </message>
    <message>
        <source>Set TCP on robot</source>
        <translation>ロボットに TCP を設定</translation>
    </message>
    <message>
        <source>A TCP named “%1” already exists. Choose a different name.</source>
        <translation>「%1」は別の TCP の名前です。別の名前を選んでください。</translation>
    </message>
</context>
<context>
    <name>tiller::TcpTeacher</name>
    <message>
        <source>Record pose</source>
        <translation>姿勢を記録</translation>
    </message>
    <message>
        <source>Redo least accurate pose</source>
        <translation>最も不正確な姿勢を再記録</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Keep TCP</source>
        <translation>TCP を採用</translation>
    </message>
    <message>
        <source>Teach the TCP</source>
        <translation>TCP を教示</translation>
    </message>
    <message>
        <source>Record pose for the tool orientation</source>
        <translation>ツール方向用の姿勢を記録</translation>
    </message>
    <message>
        <source>Tool orientation</source>
        <translation>ツールの方向</translation>
    </message>
    <message>
        <source>Keep current orientation</source>
        <translation>現在の方向を保持</translation>
    </message>
    <message>
        <source>Orientation from one pose: tool straight down</source>
        <translation>一姿勢から方向：ツール真下</translation>
    </message>
    <message>
        <source>Orientation from three poses: along +Z, towards +X</source>
        <translation>三姿勢から方向：+Z に沿い、+X 側へ</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Tip at %1. The poses agree within %2 (RMS); pose %3 deviates most, by %4.</source>
        <translation>先端は %1。姿勢は %2 (rms) で一致。姿勢 %3 が最も合わず、%4。</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the poses again.</source>
        <translation>ロボットが有効な位置を送りませんでした。姿勢を記録し直してください。</translation>
    </message>
    <message>
        <source>The tool keeps the current orientation.</source>
        <translation>ツールは現在の方向を保ちます。</translation>
    </message>
    <message>
        <source>Rotate the tool until it points straight down and its X axis is parallel to the base X axis, then record the pose.</source>
        <translation>ツールを真下に向け、その X がベースの X に沿うまで回し、記録してください。</translation>
    </message>
    <message>
        <source>Orientation recorded. Record another pose to replace the orientation.</source>
        <translation>方向を記録しました。記録し直すと置き換わります。</translation>
    </message>
    <message>
        <source>Record the pose at the current position. After that, do not rotate the tool: jog along X, Y and Z only.</source>
        <translation>現在の位置で姿勢を記録します。以後ツールを回さず、X、Y、Z だけジョグしてください。</translation>
    </message>
    <message>
        <source>Move the tool along its +Z direction, away from the flange, by at least %1, and record the pose.</source>
        <translation>ツールを自身の +Z に沿ってフランジから %1 以上離し、記録してください。</translation>
    </message>
    <message>
        <source>Now move the tool along its +X direction by at least %1, and record the pose.</source>
        <translation>次に +X 側へ %1 以上動かし、記録してください。</translation>
    </message>
    <message>
        <source>Orientation recorded: %1 along +Z, %2 along +X; maximum flange rotation %3 at pose %4.</source>
        <translation>方向を記録しました：+Z に %1、+X に %2。フランジの最大回転は姿勢 %4 で %3。</translation>
    </message>
    <message>
        <source>The flange rotated by up to %1 (pose %2). Record the three poses again without rotating the tool.</source>
        <translation>フランジが最大 %1 回転しました（姿勢 %2）。ツールを回さずに三つの姿勢を記録し直してください。</translation>
    </message>
    <message>
        <source>The distance along +Z is only %1. Record the three poses again, at least %2 apart.</source>
        <translation>+Z に沿った距離が %1 だけです。%2 以上離して三つを記録し直してください。</translation>
    </message>
    <message>
        <source>The distance along +X is only %1. Record the three poses again, at least %2 apart.</source>
        <translation>+X 側への距離が %1 だけです。%2 以上離して三つを記録し直してください。</translation>
    </message>
    <message>
        <source>The three poses are collinear: the third pose is only %1 from the line. Record the three poses again.</source>
        <translation>三つの姿勢が一直線上にあります：三つ目は %1 だけです。三つを記録し直してください。</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the three poses again.</source>
        <translation>ロボットが有効な位置を送りませんでした。三つを記録し直してください。</translation>
    </message>
    <message>
        <source>Redo last pose</source>
        <translation>最後の姿勢を再記録</translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation>姿勢 %1 を記録</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>姿勢 %1</translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation>  ◀ 最も不正確</translation>
    </message>
    <message>
        <source>Poses can be recorded only while the robot sends data. Connect to a robot, or wait for new data.</source>
        <translation>姿勢を記録できるのは、ロボットがデータを送っている間だけです。ロボットに接続するか、新しいデータを待ってください。</translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool tilted by at least 30° in a different direction.</source>
        <translation>姿勢間のツールの回転が足りません。別の側に 30° 以上傾けてもう一つ記録してください。</translation>
    </message>
    <message>
        <source>Jog the tip to a fixed, sharp point and record the pose. Record four poses in total, each with the tip on the same point and the tool tilted in a different direction.</source>
        <translation>先端を固定された尖った点へジョグし、姿勢を記録します。全部で四回：先端は同じ点、ツールは毎回別の側に傾けます。</translation>
    </message>
    <message numerus="yes">
        <source>Tilt the tool in a different direction, move the tip to the same point again, and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>ツールを別の側に傾け、先端を同じ点に合わせて姿勢を記録してください。残り：%n。</numerusform>
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
        <translation>ペイロード</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>セル</translation>
    </message>
    <message>
        <source>TCP, payload, positions or cell</source>
        <translation>TCP、ペイロード、位置、セル</translation>
    </message>
</context>
<context>
    <name>tiller::TravelWatch</name>
    <message>
        <source>%1: %2 left until %3 is %4 from %5</source>
        <translation>%1：残り%2で%3は%5まで%4</translation>
    </message>
    <message>
        <source>%1: %2 left until the %3 joint limit</source>
        <translation>%1：%3 の限界まで残り %2</translation>
    </message>
    <message>
        <source>%1: %2 left until the reach limit or a singularity</source>
        <translation>%1：残り %2、その先は到達限界か特異点</translation>
    </message>
</context>
<context>
    <name>tiller::VariableList</name>
    <message>
        <source>Program variables</source>
        <translation>プログラムの変数</translation>
    </message>
    <message>
        <source>The variable list changed during editing, so the value was not applied. Enter the value again.</source>
        <translation>編集中に変数リストが変わったため、値は適用されませんでした。もう一度入力してください。</translation>
    </message>
</context>
<context>
    <name>tiller::VariableModel</name>
    <message>
        <source>%1 (changing…)</source>
        <translation>%1(変更中…)</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>型</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
</context>
<context>
    <name>tiller::VectorEditor</name>
    <message>
        <source>%1. Press Return to apply the value. The robot does not move.</source>
        <translation>%1。Enterで適用します。ロボットは動きません。</translation>
    </message>
</context>
<context>
    <name>tiller::ViewCard</name>
    <message>
        <source>Collapse</source>
        <translation>たたむ</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>The view is too small to expand this card</source>
        <translation>ビューが小さすぎてこのカードを広げられません</translation>
    </message>
    <message>
        <source>Expand</source>
        <translation>広げる</translation>
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
        <translation>ウェイポイントの座標系での値。Return で適用します。変わるのはウェイポイントだけで、ロボットは動きません。</translation>
    </message>
    <message>
        <source>Selected waypoint</source>
        <translation>選んだウェイポイント</translation>
    </message>
    <message>
        <source>Waypoint frame</source>
        <translation>ウェイポイントの座標系</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>座標系</translation>
    </message>
    <message numerus="yes">
        <source>used in %n steps</source>
        <translation>
            <numerusform>%n ステップで使用</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the current pose</source>
        <translation>現在の姿勢から %1</translation>
    </message>
    <message>
        <source>joints have priority</source>
        <translation>関節が優先</translation>
    </message>
    <message>
        <source>pose has priority</source>
        <translation>姿勢が優先</translation>
    </message>
    <message>
        <source>cell of “%1”</source>
        <translation>「%1」のセル</translation>
    </message>
    <message>
        <source>corner of “%1”</source>
        <translation>「%1」の隅</translation>
    </message>
    <message>
        <source>home position “%1”</source>
        <translation>ホーム、「%1」</translation>
    </message>
    <message>
        <source>position “%1”</source>
        <translation>位置「%1」</translation>
    </message>
    <message>
        <source>Run route</source>
        <translation>ルート</translation>
    </message>
    <message>
        <source>Shows the route controls instead of the values.</source>
        <translation>数値の代わりにルートの操作を表示します。</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Shows the values instead of the route controls.</source>
        <translation>ルートの操作の代わりに数値を表示します。</translation>
    </message>
    <message>
        <source>TCP “%1”</source>
        <translation>TCP「%1」</translation>
    </message>
    <message>
        <source>TCP at the flange</source>
        <translation>TCP はフランジ</translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation>TCP はフランジから %1</translation>
    </message>
    <message>
        <source>Reference frame of the waypoint. Changing the frame does not move the waypoint. “—” means no frame: the joint positions have priority.</source>
        <translation>ウェイポイントの基準座標系。空間での位置は変わりません。「—」：座標系なし、関節位置が優先</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointDialogs</name>
    <message>
        <source>Select waypoints to change.</source>
        <translation>変更するウェイポイントを選んでください。</translation>
    </message>
    <message numerus="yes">
        <source>Change the properties of %n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイントの属性を変更</numerusform>
        </translation>
    </message>
    <message>
        <source>Select waypoints to move.</source>
        <translation>動かすウェイポイントを選んでください。</translation>
    </message>
    <message>
        <source>Change the pattern “%1”</source>
        <translation>パターン「%1」を変更</translation>
    </message>
    <message>
        <source>Create the pattern “%1”</source>
        <translation>パターン「%1」を作成</translation>
    </message>
    <message>
        <source>Convert the pattern “%1” to waypoints</source>
        <translation>パターン「%1」をウェイポイントに変換</translation>
    </message>
    <message>
        <source>Select a waypoint that belongs to a pattern.</source>
        <translation>パターンのセルを選んでください。</translation>
    </message>
    <message>
        <source>Delete the pattern “%1”</source>
        <translation>パターン「%1」を削除</translation>
    </message>
    <message>
        <source>Select a waypoint to see its history.</source>
        <translation>履歴を見るウェイポイントを選んでください。</translation>
    </message>
    <message>
        <source>Restore an earlier version of “%1”</source>
        <translation>以前の「%1」に戻す</translation>
    </message>
    <message>
        <source>Import waypoints</source>
        <translation>ウェイポイントを取り込む</translation>
    </message>
    <message>
        <source>Waypoint files (*.csv *.txt *.json *.tiller);;All files (*)</source>
        <translation>ウェイポイント (*.csv *.txt *.json *.tiller);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Export waypoints</source>
        <translation>ウェイポイントをエクスポート</translation>
    </message>
    <message>
        <source>CSV file (*.csv);;JSON file (*.json)</source>
        <translation>CSV ファイル (*.csv);;JSON ファイル (*.json)</translation>
    </message>
    <message>
        <source>Import failed</source>
        <translation>インポートに失敗しました</translation>
    </message>
    <message>
        <source>%1 is too large. The maximum size of a waypoint file is 64 MB.</source>
        <translation>%1 は大きすぎます。ウェイポイントファイルの上限は 64 MB です。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>ウェイポイント</translation>
    </message>
    <message numerus="yes">
        <source>Import %n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイントを取り込む</numerusform>
        </translation>
    </message>
    <message>
        <source>The project contains no waypoints to export. Teach a waypoint first.</source>
        <translation>エクスポートするウェイポイントがプロジェクトにありません。先にウェイポイントを教示してください。</translation>
    </message>
    <message>
        <source>Export failed</source>
        <translation>エクスポートに失敗しました</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints exported to %1</source>
        <translation>
            <numerusform>%n 個のウェイポイントを %1 に書きました</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the waypoints to add actions to.</source>
        <translation>動作を行うウェイポイントを選んでください。</translation>
    </message>
    <message numerus="yes">
        <source>Change the actions at %n waypoints</source>
        <translation>
            <numerusform>%n個のウェイポイントの動作を変更</numerusform>
        </translation>
    </message>
    <message>
        <source>Teach three waypoints at the corners of the pattern first.</source>
        <translation>先にパターンの隅に三つのウェイポイントを教示してください。</translation>
    </message>
    <message>
        <source>The earlier version cannot be restored because its frame was deleted from the project. Select a different version.</source>
        <translation>以前の版の座標系がプロジェクトから削除されているため、復元できません。別の版を選択してください。</translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイントをオフセット・回転・鏡像</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 contains no waypoints. Choose a different file.</source>
        <translation>%1 にウェイポイントがありません。別のファイルを選んでください。</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointEditing</name>
    <message>
        <source>Duplicate “%1”</source>
        <translation>「%1」を複製</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイントを複製</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste failed</source>
        <translation>貼り付けに失敗しました</translation>
    </message>
    <message>
        <source>The clipboard contains no waypoints. Copy waypoints first.</source>
        <translation>クリップボードにウェイポイントがありません。先にウェイポイントをコピーしてください。</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>ウェイポイント</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイントを貼り付け</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::WaypointHistoryDialog</name>
    <message>
        <source>History of “%1”</source>
        <translation>「%1」の履歴</translation>
    </message>
    <message>
        <source>Changes, newest first</source>
        <translation>変更、新しい順</translation>
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
        <translation>この変更前の版に戻す</translation>
    </message>
    <message>
        <source>Name: “%1” → “%2”</source>
        <translation>名前：「%1」 → 「%2」</translation>
    </message>
    <message>
        <source>Position: moved by %1 (%2, base frame)</source>
        <translation>位置：%1 移動（%2、ベース座標系）</translation>
    </message>
    <message>
        <source>Joints: largest change %2 (%1)</source>
        <translation>関節：最大変化 %2（%1）</translation>
    </message>
    <message>
        <source>none (joints have priority)</source>
        <translation>なし（関節が優先）</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>ベース</translation>
    </message>
    <message>
        <source>a deleted frame</source>
        <translation>もうない座標系</translation>
    </message>
    <message>
        <source>Frame: %1 → %2</source>
        <translation>座標系：%1 → %2</translation>
    </message>
    <message>
        <source>Move: MoveL → MoveJ</source>
        <translation>動作：MoveL → MoveJ</translation>
    </message>
    <message>
        <source>Move: MoveJ → MoveL</source>
        <translation>動作：MoveJ → MoveL</translation>
    </message>
    <message>
        <source>MoveJ speed: %1 → %2</source>
        <translation>MoveJ の速度：%1 → %2</translation>
    </message>
    <message>
        <source>MoveL speed: %1 → %2</source>
        <translation>MoveL の速度：%1 → %2</translation>
    </message>
    <message>
        <source>Blend: %1 → %2</source>
        <translation>ブレンド：%1 → %2</translation>
    </message>
    <message>
        <source>TCP: taught with a different TCP</source>
        <translation>TCP：別の TCP で教示</translation>
    </message>
    <message>
        <source>Group: “%1” → “%2”</source>
        <translation>グループ：「%1」 → 「%2」</translation>
    </message>
    <message>
        <source>Colour: %1 → %2</source>
        <translation>色：%1 → %2</translation>
    </message>
    <message>
        <source>Note: “%1” → “%2”</source>
        <translation>メモ：「%1」 → 「%2」</translation>
    </message>
    <message>
        <source>Actions: changed</source>
        <translation>アクション：変更</translation>
    </message>
    <message>
        <source>No changes have been recorded for this waypoint.</source>
        <translation>このウェイポイントの変更履歴はありません。</translation>
    </message>
    <message>
        <source>The version before this change is identical to the current version.</source>
        <translation>この変更前の版は現在の版と同じです。</translation>
    </message>
    <message>
        <source>Changes from the version before this change to the current version:</source>
        <translation>この変更前の版から現在の版への変更：</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointModel</name>
    <message>
        <source>✕ joint</source>
        <translation>✕ 関節</translation>
    </message>
    <message>
        <source>✕ frame</source>
        <translation>✕ 座標系</translation>
    </message>
    <message>
        <source>✕ line</source>
        <translation>✕ 直線</translation>
    </message>
    <message>
        <source>✕ reach</source>
        <translation>✕ 到達</translation>
    </message>
    <message>
        <source>Out of reach. Touch up the waypoint closer to the base.</source>
        <translation>到達不可。ベースの近くで修正教示してください。</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>ベース</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>MoveJ: all joints start and stop together</source>
        <translation>MoveJ：全関節が同時に始まり同時に止まる</translation>
    </message>
    <message>
        <source>MoveL: the TCP moves along a straight line</source>
        <translation>MoveL：TCP が直線に沿って動く</translation>
    </message>
    <message>
        <source>Joints have priority: the arm returns to the same configuration</source>
        <translation>関節が優先：アームは同じ姿勢で戻る</translation>
    </message>
    <message>
        <source>The pose has priority: the waypoint moves with its frame</source>
        <translation>姿勢が優先：座標系とともに動く</translation>
    </message>
    <message>
        <source>Within reach</source>
        <translation>到達可能</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>動作</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>座標系</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Blend %1</source>
        <translation>ブレンド %1</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>到達</translation>
    </message>
    <message>
        <source>Enter a name for the waypoint.</source>
        <translation>ウェイポイントの名前を入力してください。</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>「%1」を「%2」に名前変更</translation>
    </message>
    <message>
        <source>Change “%1” to MoveJ</source>
        <translation>「%1」を MoveJ にする</translation>
    </message>
    <message>
        <source>Change “%1” to MoveL</source>
        <translation>「%1」を MoveL にする</translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation>「%1」の姿勢を変更</translation>
    </message>
    <message>
        <source>Use joint positions for “%1”</source>
        <translation>「%1」に関節位置を使う</translation>
    </message>
    <message>
        <source>Change the frame of “%1” to %2</source>
        <translation>「%1」の座標系を %2 に変更</translation>
    </message>
    <message>
        <source>Set the blend of “%1”</source>
        <translation>「%1」のブレンドを設定</translation>
    </message>
    <message>
        <source>Set the speed of “%1”</source>
        <translation>「%1」の速度を設定</translation>
    </message>
    <message>
        <source>Group: %1</source>
        <translation>グループ：%1</translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation>色：%1</translation>
    </message>
    <message>
        <source>Name %1, next waypoint</source>
        <translation>名前 %1、次</translation>
    </message>
    <message>
        <source>Actions: %1</source>
        <translation>そこで行う動作: %1</translation>
    </message>
    <message>
        <source>Name %1</source>
        <translation>名前 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n actions</source>
        <translation>
            <numerusform>動作%n個</numerusform>
        </translation>
    </message>
    <message>
        <source>✕ model</source>
        <translation>✕ モデル</translation>
    </message>
    <message>
        <source>✕ path</source>
        <translation>✕ 経路</translation>
    </message>
    <message>
        <source>The arm cannot reach this pose, so “%1” was not changed. Enter a different pose.</source>
        <translation>アームはこの姿勢に到達できません。「%1」は変更されていません。別の姿勢を入力してください。</translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation>「%1」は数ではありません。数を入力してください。</translation>
    </message>
    <message>
        <source>%1 is out of range. Enter a value from %2 to %3.</source>
        <translation>%1 は範囲外です。%2〜%3 の値を入力してください。</translation>
    </message>
    <message>
        <source>A joint would exceed its limit. Touch up the waypoint with a different arm configuration.</source>
        <translation>関節が可動範囲を出ます。別のアーム姿勢からウェイポイントを修正教示してください。</translation>
    </message>
    <message>
        <source>The frame of the waypoint is not in this project. Choose a different frame.</source>
        <translation>ウェイポイントの座標系がこのプロジェクトにありません。別の座標系を選んでください。</translation>
    </message>
    <message>
        <source>The straight line from the current position leaves the reach of the arm. Use MoveJ, or start from a different position.</source>
        <translation>現在位置からの直線がアームの到達範囲を出ます。MoveJ を使うか、別の位置から始めてください。</translation>
    </message>
    <message>
        <source>Waypoint %2 is already named “%1”. Choose a different name.</source>
        <translation>「%1」はウェイポイント %2 の名前です。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>The project has no frame named “%1”. Choose a different frame.</source>
        <translation>プロジェクトに座標系「%1」がありません。別の座標系を選んでください。</translation>
    </message>
    <message>
        <source>The project was taught with a different robot model. Use “Adapt project to this robot…” first.</source>
        <translation>プロジェクトは別のロボットモデルで教示されました。先に「プロジェクトをこのロボットに合わせる…」を使ってください。</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointProperties</name>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>青</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>橙</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>緑</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>桃</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>空色</translation>
    </message>
    <message>
        <source>Only the selected properties are changed.</source>
        <translation>選択した属性だけを変更します。</translation>
    </message>
    <message>
        <source>Properties of “%1”</source>
        <translation>「%1」の属性</translation>
    </message>
    <message numerus="yes">
        <source>Properties of %n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイントの属性</numerusform>
        </translation>
    </message>
    <message>
        <source>Group</source>
        <translation>グループ</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>MoveJ speed</source>
        <translation>MoveJ の速度</translation>
    </message>
    <message>
        <source>MoveL speed</source>
        <translation>MoveL の速度</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>ブレンド</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointSearch</name>
    <message>
        <source>Find waypoints</source>
        <translation>ウェイポイントを検索</translation>
    </message>
    <message>
        <source>Find waypoints by name, group or note</source>
        <translation>名前、グループ、メモでウェイポイントを検索</translation>
    </message>
    <message>
        <source>Name, group or note</source>
        <translation>名前、グループ、メモ</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>すべて表示</translation>
    </message>
    <message>
        <source>Show all waypoints</source>
        <translation>全ウェイポイントを表示</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n 件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::WaypointShift</name>
    <message>
        <source>Transformation type</source>
        <translation>変換の種類</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>オフセット</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>鏡像</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>ベース</translation>
    </message>
    <message>
        <source>Tool of each waypoint</source>
        <translation>ツール、それぞれ</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Offset X, Y, Z</source>
        <translation>オフセット X、Y、Z</translation>
    </message>
    <message>
        <source>Offset %1</source>
        <translation>オフセット %1</translation>
    </message>
    <message>
        <source>Rotation axis or mirror normal</source>
        <translation>回転軸またはミラー面の法線</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>The arm cannot reach these waypoints after the move: %1. Choose a different offset, rotation or mirror plane. No waypoint will be moved.</source>
        <translation>移動後、アームは次のウェイポイントに到達できません：%1。別のオフセット、回転または鏡映面を選んでください。ウェイポイントは移動しません。</translation>
    </message>
    <message numerus="yes">
        <source>%n of the moved waypoints will be out of reach. They will be kept and marked.</source>
        <translation>
            <numerusform>うち %n 個は到達不可になります。残して印を付けます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirrors across the plane through the origin that is perpendicular to the axis. The tool approaches from the mirrored side.</source>
        <translation>原点を通り軸に垂直な平面で鏡像にします。ツールは鏡像側から近づきます。</translation>
    </message>
    <message>
        <source>All waypoints remain within reach.</source>
        <translation>すべて到達可能です。</translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>%n 個のウェイポイントをオフセット・回転・鏡像</numerusform>
        </translation>
    </message>
    <message>
        <source>The frame of a selected waypoint is not in the project. Choose a different frame for the waypoint first.</source>
        <translation>選択したウェイポイントの座標系がプロジェクトにありません。先にウェイポイントの座標系を変更してください。</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointTable</name>
    <message>
        <source>Waypoints</source>
        <translation>ウェイポイント</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointsTab</name>
    <message>
        <source>Waypoints</source>
        <translation>ウェイポイント</translation>
    </message>
    <message>
        <source>Teach here  T</source>
        <translation>ここを教示  T</translation>
    </message>
    <message>
        <source>Teach here</source>
        <translation>ここを教示</translation>
    </message>
    <message>
        <source>Touch up  U</source>
        <translation>修正教示  U</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>修正教示</translation>
    </message>
    <message>
        <source>More</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>No waypoints yet.
Jog the arm to a position and press “Teach here” (T).</source>
        <translation>ウェイポイントはまだありません。
アームをジョグし、「ここを教示」(T) を押してください。</translation>
    </message>
    <message>
        <source>Select a waypoint to go to.</source>
        <translation>移動先のウェイポイントを選んでください。</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller は制御中ではありません。先に制御を取得してください。</translation>
    </message>
    <message>
        <source>Add the current position after the selection (T)</source>
        <translation>アームの現在位置を選択の後に追加 (T)</translation>
    </message>
    <message>
        <source>Replace the selected waypoint with the current position (U)</source>
        <translation>選択したウェイポイントを現在位置で置き換え (U)</translation>
    </message>
    <message>
        <source>Select a waypoint to touch up.</source>
        <translation>修正教示するウェイポイントを選んでください。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下へ</translation>
    </message>
    <message>
        <source>Copy as table</source>
        <translation>表としてコピー</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>貼り付け</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>ウェイポイント</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>「%1」を教示</translation>
    </message>
    <message>
        <source>The current position is %1 away (%2, base frame). Largest joint change: %3 %4.</source>
        <translation>現在の位置は %1 離れています（%2、ベース座標系）。最大の関節変化：%3 %4。</translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>「%1」を修正教示しますか？</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>「%1」を修正教示</translation>
    </message>
    <message>
        <source>Path recorded</source>
        <translation>経路を記録しました</translation>
    </message>
    <message>
        <source>Import waypoints…</source>
        <translation>ウェイポイントを取り込む…</translation>
    </message>
    <message>
        <source>Export waypoints…</source>
        <translation>ウェイポイントをエクスポート…</translation>
    </message>
    <message>
        <source>Find waypoints</source>
        <translation>ウェイポイントを検索</translation>
    </message>
    <message>
        <source>Group, colour, note, speeds…</source>
        <translation>グループ、色、メモ、速度…</translation>
    </message>
    <message>
        <source>Offset, rotate or mirror…</source>
        <translation>オフセット、回転、鏡像…</translation>
    </message>
    <message>
        <source>History…</source>
        <translation>履歴…</translation>
    </message>
    <message>
        <source>Convert pattern to waypoints</source>
        <translation>パターンをウェイポイントに変換</translation>
    </message>
    <message>
        <source>Delete pattern and its waypoints</source>
        <translation>パターンとそのウェイポイントを削除</translation>
    </message>
    <message>
        <source>Actions…</source>
        <translation>動作…</translation>
    </message>
    <message>
        <source>Import and export</source>
        <translation>インポートとエクスポート</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>経路</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>Taught “%1”</source>
        <translation>「%1」をティーチングしました</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Create or edit pattern…</source>
        <translation>パターンを作成または編集…</translation>
    </message>
    <message>
        <source>The frame of “%1” is not in this project. Choose a different frame first.</source>
        <translation>「%1」の座標系がこのプロジェクトにありません。先に別の座標系を選んでください。</translation>
    </message>
</context>
<context>
    <name>tiller::app::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>コマンドを検索</translation>
    </message>
    <message>
        <source>Type a command or keyword</source>
        <translation>コマンドまたはキーワードを入力</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>見つかったコマンド</translation>
    </message>
    <message>
        <source>not available now</source>
        <translation>今は不可</translation>
    </message>
</context>
<context>
    <name>tiller::app::ConnectDialog</name>
    <message>
        <source>Enter the robot&apos;s address, as shown on the teach pendant under About.</source>
        <translation>ティーチペンダントの「情報」に表示されるロボットのアドレスを入力してください。</translation>
    </message>
    <message>
        <source>An IP address consists of four numbers from 0 to 255, e.g. 192.168.0.10.</source>
        <translation>IP アドレスは 192.168.0.10 のような 0〜255 の四つの数です。</translation>
    </message>
    <message>
        <source>A host name contains only letters, digits, dots and hyphens.</source>
        <translation>ホスト名は英字、数字、点、ハイフンだけです。</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>忘れる</translation>
    </message>
    <message>
        <source>Start the simulated robot</source>
        <translation>シミュレートされたロボットを起動</translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation>見本プロジェクトを開く…</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>Before you move a real arm: keep everyone out of its reach, keep the emergency stop within reach, check the payload and the TCP, and start slowly. STOP in this window is not an emergency stop.</source>
        <translation>実機を動かす前に：届く範囲に人を入れず、非常停止を手元に置き、ペイロードと TCP を確認し、ゆっくり始めてください。このウィンドウの STOP は非常停止ではありません。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>プロジェクトを開く…</translation>
    </message>
    <message>
        <source>Opens a project without a robot, to view and edit waypoints and programs.</source>
        <translation>ロボットなしでプロジェクトを開き、ウェイポイントとプログラムを表示、編集します。</translation>
    </message>
    <message>
        <source>Try the simulator</source>
        <translation>シミュレーターを試す</translation>
    </message>
    <message>
        <source>A simulated UR5e that runs in Tiller. All functions are available without risk.</source>
        <translation>Tiller 内で動くシミュレートされた UR5e。すべての機能を危険なく使えます。</translation>
    </message>
    <message>
        <source>Starts the simulated robot and opens a project with taught waypoints.</source>
        <translation>シミュレートされたロボットを起動し、教示済みのプロジェクトを開きます。</translation>
    </message>
    <message>
        <source>Connect to a robot</source>
        <translation>ロボットに接続</translation>
    </message>
    <message>
        <source>Address or host name of the robot</source>
        <translation>ロボットのアドレスかホスト名</translation>
    </message>
    <message>
        <source>Display name of the robot</source>
        <translation>表示するロボット名</translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation>実験室の UR5e</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Recently connected robots</source>
        <translation>最近接続したロボット</translation>
    </message>
    <message>
        <source>Removes the selected robot from this list (Delete). The robot itself is not affected.</source>
        <translation>選択したロボットをこの一覧から削除します (Delete)。ロボット自体には影響しません。</translation>
    </message>
</context>
<context>
    <name>tiller::app::Demonstration</name>
    <message>
        <source>Cannot create the folder %1. Choose a folder that you have permission to write to.</source>
        <translation>フォルダー %1 を作成できません。書き込み権限のあるフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>connect</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>power on</source>
        <translation>電源オン</translation>
    </message>
    <message>
        <source>release the brakes</source>
        <translation>ブレーキ解除</translation>
    </message>
    <message>
        <source>take control</source>
        <translation>制御を取得</translation>
    </message>
    <message>
        <source>start recording</source>
        <translation>記録を開始</translation>
    </message>
    <message>
        <source>teach the first waypoint</source>
        <translation>最初のウェイポイントを教示</translation>
    </message>
    <message>
        <source>jog X+ in Base for 50 mm</source>
        <translation>ベースで X+ に 50 mm ジョグ</translation>
    </message>
    <message>
        <source>teach the second waypoint</source>
        <translation>二番目のウェイポイントを教示</translation>
    </message>
    <message>
        <source>move to the first waypoint (button held)</source>
        <translation>最初のウェイポイントへ移動（押し続け）</translation>
    </message>
    <message>
        <source>digital output 0 on</source>
        <translation>デジタル出力 0 オン</translation>
    </message>
    <message>
        <source>digital output 0 off</source>
        <translation>デジタル出力 0 オフ</translation>
    </message>
    <message>
        <source>take the screenshots</source>
        <translation>画面写真を撮る</translation>
    </message>
    <message>
        <source>Cannot write the screenshots to %1. Check the permissions of the folder and the free disk space.</source>
        <translation>スクリーンショットを %1 に書き込めません。フォルダーの権限とディスクの空き容量を確認してください。</translation>
    </message>
    <message>
        <source>stop recording</source>
        <translation>記録を停止</translation>
    </message>
    <message>
        <source>%1: not completed within %2 s (%3)</source>
        <translation>%1：%2 s 以内に完了しませんでした（%3）</translation>
    </message>
    <message>
        <source>the robot reported no reason</source>
        <translation>ロボットは理由を報告していません</translation>
    </message>
    <message>
        <source>pressed again        %1 times: the motion had stopped before the button was released</source>
        <translation>押し直し             %1 回：ボタンを離す前に動作が止まっていました</translation>
    </message>
    <message>
        <source>jogged               </source>
        <translation>ジョグ               </translation>
    </message>
    <message>
        <source>release to standstill </source>
        <translation>離してから静止まで </translation>
    </message>
    <message>
        <source>packets              </source>
        <translation>パケット              </translation>
    </message>
    <message>
        <source> received, </source>
        <translation> 受信、 </translation>
    </message>
    <message>
        <source> late, </source>
        <translation> 遅れ、 </translation>
    </message>
    <message>
        <source> lost
</source>
        <translation> 欠落
</translation>
    </message>
    <message>
        <source>recorded             </source>
        <translation>記録             </translation>
    </message>
    <message>
        <source> rows, </source>
        <translation> 行、 </translation>
    </message>
    <message>
        <source>files                </source>
        <translation>ファイル                </translation>
    </message>
    <message>
        <source>the window has no button “%1”</source>
        <translation>ウィンドウに「%1」というボタンがありません</translation>
    </message>
    <message>
        <source>release the jog button</source>
        <translation>ジョグボタンを離す</translation>
    </message>
    <message>
        <source>release the “Go to” button</source>
        <translation>「移動」ボタンを離す</translation>
    </message>
</context>
<context>
    <name>tiller::app::DeviceSettings</name>
    <message>
        <source>Jog device</source>
        <translation>ジョグ装置</translation>
    </message>
    <message>
        <source>Test device…</source>
        <translation>デバイスをテスト…</translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation>各デバイスの現在の値と、アームが動く方向を表示します。</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>ゲームパッド</translation>
    </message>
    <message>
        <source>SpaceMouse</source>
        <translation>SpaceMouse</translation>
    </message>
    <message>
        <source>%1 dead zone</source>
        <translation>%1 の不感帯</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Deflection below which the device does not move the arm.</source>
        <translation>これ以下の傾きではアームは動きません。</translation>
    </message>
    <message>
        <source>%1 curve</source>
        <translation>%1 の曲線</translation>
    </message>
    <message>
        <source>exponent </source>
        <translation>指数 </translation>
    </message>
    <message>
        <source>1: linear. Higher values: finer near the centre, faster at full deflection.</source>
        <translation>1：均一。大きいほど中央付近は緩やか、端で速くなります。</translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation>主軸のみ</translation>
    </message>
    <message>
        <source>%1: dominant axis only</source>
        <translation>%1：最も大きく倒した軸だけ</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>不感帯</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation>ゲームパッドも SpaceMouse も見つかりません。接続すると自動で検出されます。</translation>
    </message>
    <message>
        <source>The device moves the arm only while the hold-to-run button is held. The selection is not stored: after a restart, no device moves the arm.</source>
        <translation>イネーブルボタンを押している間だけアームを動かします。保存されません：再起動後はどのデバイスもアームを動かしません。</translation>
    </message>
</context>
<context>
    <name>tiller::app::DockStage</name>
    <message>
        <source>No panels are shown. Select a perspective at the lower right, or show a panel from the View menu.</source>
        <translation>パネルがありません。右下でパースペクティブを選ぶか、メニュー「ビュー」でパネルを表示してください。</translation>
    </message>
</context>
<context>
    <name>tiller::app::HelpPage</name>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>練習課題</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>マニュアル(英語)</translation>
    </message>
    <message>
        <source>Jogging and keys</source>
        <translation>ジョグとキー</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目次</translation>
    </message>
    <message>
        <source>&lt;h2&gt;The manual is not installed on this PC&lt;/h2&gt;&lt;p&gt;The Debian package of Tiller contains the manual. To add the manual to your own build, install the package python3-sphinx:&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;Then build again. You can also read the pages as text in the folder packaging/manual of the source code. The page “Jogging and keys” of this window contains the jogging rules and all shortcuts.&lt;/p&gt;</source>
        <translation>&lt;h2&gt;このコンピューターにはマニュアルがインストールされていません&lt;/h2&gt;&lt;p&gt;マニュアルは Tiller の Debian パッケージに含まれています。自分でビルドする場合は、パッケージ python3-sphinx をインストールしてください。&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;その後もう一度ビルドしてください。ソースコードのフォルダー packaging/manual でテキストとして読むこともできます。ジョグの規則とすべてのキーは、このウィンドウのもう一方のページにあります。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;h2&gt;Moving the arm&lt;/h2&gt;&lt;p&gt;The arm moves while you hold a jog button, and stops when you release it. It also stops when&lt;/p&gt;&lt;ul&gt;&lt;li&gt;the pointer leaves the button, a different mouse button is pressed, or a second input device is used;&lt;/li&gt;&lt;li&gt;a modifier or an opposite key is pressed while a keyboard key is held;&lt;/li&gt;&lt;li&gt;the window loses focus, a dialog or menu opens, or the frame, speed, step or tab changes;&lt;/li&gt;&lt;li&gt;data from the robot are late, Tiller hangs, or the robot mode, the safety mode or Remote control changes;&lt;/li&gt;&lt;li&gt;the screen is locked, the PC goes to sleep, or the input device is unplugged or stops sending data;&lt;/li&gt;&lt;li&gt;the key-state check fails: on X11, Tiller checks every 10 ms with the display server that the button or key is still pressed. If the button or key is not pressed, or if the server does not respond for 100 ms, the motion ends. If the check is not available, the header and Settings show a note;&lt;/li&gt;&lt;li&gt;the maximum hold time is reached: %1 s for a jog (Settings), five minutes for Freedrive, the duration of the move plus 5 s for a move to a position. The last 3 s are counted down.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;After a stop, press the button or key again to move the arm. While Tiller is in control, &lt;b&gt;Space&lt;/b&gt; and &lt;b&gt;Esc&lt;/b&gt; stop the arm from every window, dialog and text field. When Tiller is not in control, they act on the focused element; click &lt;b&gt;STOP&lt;/b&gt; to stop a program from another client. This is a software stop, not an emergency stop: keep the emergency stop within reach.&lt;/p&gt;&lt;p&gt;Hold &lt;b&gt;Ctrl&lt;/b&gt; for one-tenth of the speed, or &lt;b&gt;Shift&lt;/b&gt; for three times the speed, up to the speed cap. On a keyboard without Latin letters, the letters below refer to key positions on a US keyboard.&lt;/p&gt;&lt;h2&gt;Commands&lt;/h2&gt;</source>
        <translation>&lt;h2&gt;アームを動かす&lt;/h2&gt;&lt;p&gt;ジョグボタンを押している間アームが動き、離すと止まります。次の場合にも止まります：&lt;/p&gt;&lt;ul&gt;&lt;li&gt;ポインターがボタンから外れる、マウスの別のボタンが押される、または別の入力デバイスが使われる；&lt;/li&gt;&lt;li&gt;キーボードのキーを押している間に、修飾キーや反対方向のキーが押される；&lt;/li&gt;&lt;li&gt;ウィンドウがフォーカスを失う、ダイアログやメニューが開く、または座標系、速度、ステップ、タブが変わる；&lt;/li&gt;&lt;li&gt;ロボットのデータが遅れる、このプログラムが応答しない、またはロボットが「稼働中」、現在の安全モード、リモート制御から外れる；&lt;/li&gt;&lt;li&gt;画面がロックされる、PC がスリープする、または入力デバイスが取り外されるかデータを送らなくなる；&lt;/li&gt;&lt;li&gt;キー状態の確認に失敗する：X11 では、ボタンやキーが押されているかを 10 ms ごとにディスプレイサーバーで確認します。押されていない場合、またはサーバーが 100 ms 応答しない場合、動作は終わります。この確認が使えない場合は、ヘッダーと設定に表示されます；&lt;/li&gt;&lt;li&gt;最大保持時間に達する：ジョグは %1 s（設定）、フリードライブは 5 分、ある位置への移動は所要時間と 5 s。最後の 3 s はカウントダウンされます。&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;停止後は、もう一度押す必要があります。Tiller が制御している間は、&lt;b&gt;Space&lt;/b&gt; と &lt;b&gt;Esc&lt;/b&gt; でどのウィンドウ、ダイアログ、入力欄からでもアームが停止します。制御していないときは、フォーカスのある要素に働きます。他のクライアントのプログラムを停止するには &lt;b&gt;STOP&lt;/b&gt; をクリックしてください。これはソフトウェア停止で、非常停止ではありません：非常停止を手の届く所に置いてください。&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; を押すと動作は 10 倍細かく、&lt;b&gt;Shift&lt;/b&gt; を押すと 3 倍速くなりますが、上限は超えません。ラテン文字のないキーボードでは、下の文字は US 配列での位置を指します。&lt;/p&gt;&lt;h2&gt;コマンド&lt;/h2&gt;</translation>
    </message>
</context>
<context>
    <name>tiller::app::ImportDialog</name>
    <message>
        <source>Colours, sizes and units</source>
        <translation>色、大きさ、単位</translation>
    </message>
    <message>
        <source>Speed cap and maximum hold time</source>
        <translation>速度上限と最長の押下</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation>ゲームパッドと SpaceMouse</translation>
    </message>
    <message>
        <source>Robots and their grippers</source>
        <translation>ロボットとそのグリッパー</translation>
    </message>
    <message>
        <source>I/O names and scales</source>
        <translation>入出力の名前とスケール</translation>
    </message>
    <message>
        <source>Window layout</source>
        <translation>ウィンドウの配置</translation>
    </message>
    <message>
        <source>Other settings</source>
        <translation>その他の設定</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換える</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>設定を取り込む</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed.</source>
        <translation>%1 は取り込まれませんでした。何も変わっていません。</translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1:</source>
        <translation>選択した設定は %1 の内容で置き換えられます：</translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1 (written by Tiller %2):</source>
        <translation>選択した設定は %1（Tiller %2 で作成）の内容で置き換えられます：</translation>
    </message>
    <message>
        <source>%1: identical</source>
        <translation>%1：すでに同じ</translation>
    </message>
    <message>
        <source>%1: not in the file</source>
        <translation>%1：ファイルにありません</translation>
    </message>
    <message>
        <source>%1: %2 in Tiller, %3 in the file</source>
        <translation>%1：Tiller %2、ファイル %3</translation>
    </message>
    <message>
        <source>The replaced settings are saved to a separate file, which can be imported again.</source>
        <translation>置き換えられる設定は別のファイルに保存され、再び取り込めます。</translation>
    </message>
    <message>
        <source>All settings in the file match the current settings.</source>
        <translation>ファイルの設定はすべて現在の設定と同じです。</translation>
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
        <translation>キーボードジョグ無効</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>View</source>
        <translation>ビュー</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>ウェイポイント</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>座標系</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>I/O</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>ログ</translation>
    </message>
    <message>
        <source>%1 disconnected. The arm was stopped.</source>
        <translation>%1 が切断されました。アームを止めました。</translation>
    </message>
    <message>
        <source>%1 stopped sending data while it was moving the arm. The arm was stopped. Release the device; if the problem persists, reconnect it.</source>
        <translation>%1 はアームを動かしている間にデータを送らなくなりました。アームを停止しました。デバイスから手を離してください。繰り返す場合は接続し直してください。</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Open recent project</source>
        <translation>最近のプロジェクトを開く</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>プロジェクトを開く…</translation>
    </message>
    <message>
        <source>Opens a project file.</source>
        <translation>プロジェクトファイルを開きます。</translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation>見本プロジェクトを開く…</translation>
    </message>
    <message>
        <source>Opens a copy of a sample project to try on the simulated robot.</source>
        <translation>シミュレートされたロボットで試せる見本プロジェクトのコピーを開きます。</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>プロジェクトに名前を付けて保存…</translation>
    </message>
    <message>
        <source>Saves the project to a different file, and saves all further changes to that file automatically.</source>
        <translation>今このファイルに保存し、以後の変更も保存します。</translation>
    </message>
    <message>
        <source>Show waypoints</source>
        <translation>ウェイポイントを表示</translation>
    </message>
    <message>
        <source>Show frames</source>
        <translation>座標系を表示</translation>
    </message>
    <message>
        <source>Show I/O</source>
        <translation>I/O を表示</translation>
    </message>
    <message>
        <source>Show log</source>
        <translation>ログを表示</translation>
    </message>
    <message>
        <source>Shows this tab.</source>
        <translation>このタブを表示します。</translation>
    </message>
    <message>
        <source>Show gripper</source>
        <translation>グリッパーを表示</translation>
    </message>
    <message>
        <source>Shows the Gripper page of the I/O tab.</source>
        <translation>I/O タブのグリッパーのページを表示します。</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>配置を初期化</translation>
    </message>
    <message>
        <source>Restores the panel layout of the current perspective.</source>
        <translation>全パネルを現在のパースペクティブの配置に戻します。</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>明るい色</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>暗い色</translation>
    </message>
    <message>
        <source>Changes the colour theme. The setting is stored.</source>
        <translation>配色テーマを変更します。設定は保存されます。</translation>
    </message>
    <message>
        <source>Zero the force in the plots, or show the measured force</source>
        <translation>グラフの力をゼロにする、または測定どおりに表示</translation>
    </message>
    <message>
        <source>Subtracts the current TCP force in the plots. Press again to show the measured force.</source>
        <translation>グラフの TCP の力から現在の値を差し引きます。もう一度押すと測定値を表示します。</translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation>コマンド…</translation>
    </message>
    <message>
        <source>Finds a command by name.</source>
        <translation>コマンドを名前で探します。</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>設定…</translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation>設定をエクスポート…</translation>
    </message>
    <message>
        <source>Saves all settings to one file, for another computer or as a backup.</source>
        <translation>すべての設定を一つのファイルに保存します。別のコンピューター用、またはバックアップ用です。</translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation>設定を取り込む…</translation>
    </message>
    <message>
        <source>Shows which settings a file will replace, then imports them.</source>
        <translation>置き換えられる内容を表示してから、ファイルの設定を取り込みます。</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Stops the arm, ends the connection and closes the window.</source>
        <translation>アームを止め、接続を終え、ウィンドウを閉じます。</translation>
    </message>
    <message>
        <source>Load program</source>
        <translation>プログラムを読み込む</translation>
    </message>
    <message>
        <source>Name of the program on the robot, as shown on the teach pendant</source>
        <translation>ティーチペンダントに表示されるロボットのプログラム名</translation>
    </message>
    <message>
        <source>Name of the program on the robot, e.g. pick.urp</source>
        <translation>ロボットのプログラム名（例：pick.urp）</translation>
    </message>
    <message>
        <source>Speed cap set to %1</source>
        <translation>速度上限を %1 に設定しました</translation>
    </message>
    <message>
        <source>A recording is running. Stop the recording first.</source>
        <translation>記録中です。先に停止してください。</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message numerus="yes">
        <source>The cell has more boxes or planes than the simulated robot supports: %n are ignored.</source>
        <translation>
            <numerusform>セルの%n個の箱または平面は、シミュレートされたロボットの上限を超えるため無視されます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>問題を報告…</translation>
    </message>
    <message>
        <source>Shows versions, log and settings, then saves them to one file for support.</source>
        <translation>バージョン、ログ、設定を1つのファイルにまとめます。先に内容を表示します。</translation>
    </message>
    <message>
        <source>Report saved: %1</source>
        <translation>レポートを保存しました: %1</translation>
    </message>
    <message>
        <source>Tiller closed unexpectedly</source>
        <translation>Tiller が予期せず終了しました</translation>
    </message>
    <message>
        <source>Tiller saved a crash log. You can attach it to a problem report.</source>
        <translation>Tiller はクラッシュログを保存しました。問題の報告に添付できます。</translation>
    </message>
    <message>
        <source>Opens the manual page for the focused control, the list of commands and shortcuts, and the jogging rules.</source>
        <translation>フォーカスのある部分のマニュアルのページ、コマンドとショートカットの一覧、ジョグの規則を開きます。</translation>
    </message>
    <message>
        <source>The settings could not be saved. %1</source>
        <translation>設定を保存できませんでした。%1</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>元に戻しました：%1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>やり直しました：%1</translation>
    </message>
    <message>
        <source>Adapt project to this robot…</source>
        <translation>プロジェクトをこのロボットに合わせる…</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>制御を取得</translation>
    </message>
    <message>
        <source>A program is paused on the robot.</source>
        <translation>ロボットでプログラムが一時停止中です。</translation>
    </message>
    <message>
        <source>A program is running on the robot.</source>
        <translation>ロボットでプログラムが実行中です。</translation>
    </message>
    <message>
        <source>The program “%1” is paused on the robot.</source>
        <translation>プログラム「%1」がロボットで一時停止中です。</translation>
    </message>
    <message>
        <source>The program “%1” is running on the robot.</source>
        <translation>プログラム「%1」がロボットで実行中です。</translation>
    </message>
    <message>
        <source>Taking control stops the program. The program cannot be resumed, only restarted.</source>
        <translation>制御を取得するとプログラムは停止します。再開はできず、最初から開始するだけになります。</translation>
    </message>
    <message>
        <source>Stop program and take control</source>
        <translation>プログラムを停止して制御を取得</translation>
    </message>
    <message>
        <source>Keep program</source>
        <translation>プログラムを維持</translation>
    </message>
    <message>
        <source>Waypoints, Program, Frames, Tools, I/O, Log</source>
        <translation>ウェイポイント、プログラム、座標系、ツール、I/O、ログ</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>Powering off stops the program. The program cannot be resumed, only restarted.</source>
        <translation>電源を切るとプログラムが停止します。再開はできず、最初からの実行のみ可能です。</translation>
    </message>
    <message>
        <source>Stop program and power off</source>
        <translation>プログラムを停止して電源を切る</translation>
    </message>
    <message>
        <source>A path is being recorded. Stop the path recording first.</source>
        <translation>経路を記録中です。先に停止してください。</translation>
    </message>
    <message>
        <source>Close window</source>
        <translation>ウィンドウを閉じる</translation>
    </message>
    <message>
        <source>A recording is running.</source>
        <translation>記録中です。</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>新しいプロジェクト…</translation>
    </message>
    <message>
        <source>Starts an empty project in a new file.</source>
        <translation>新しいファイルで空のプロジェクトを開始します。</translation>
    </message>
    <message>
        <source>The change takes effect immediately and may disturb the program.</source>
        <translation>変更はすぐに有効になり、プログラムに影響することがあります。</translation>
    </message>
    <message>
        <source>Change anyway</source>
        <translation>それでも変更</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Change while a program is active</source>
        <translation>プログラム有効中の変更</translation>
    </message>
    <message>
        <source>Change connection</source>
        <translation>接続の変更</translation>
    </message>
    <message>
        <source>Do not ask again during this program</source>
        <translation>このプログラムの実行中は再度確認しない</translation>
    </message>
    <message>
        <source>A program is loaded on the robot.</source>
        <translation>ロボットにプログラムが読み込まれています。</translation>
    </message>
    <message>
        <source>The program “%1” is loaded on the robot.</source>
        <translation>ロボットにプログラム「%1」が読み込まれています。</translation>
    </message>
    <message>
        <source>Pausing stops the arm until the program is resumed.</source>
        <translation>プログラムを再開するまでアームは停止します。</translation>
    </message>
    <message>
        <source>The program cannot be resumed, only restarted.</source>
        <translation>プログラムは再開できません。最初からのやり直しになります。</translation>
    </message>
    <message>
        <source>The arm may move immediately. Make sure that no one is within reach of the arm.</source>
        <translation>アームがすぐに動く可能性があります。アームの届く範囲に人がいないことを確認してください。</translation>
    </message>
    <message>
        <source>Resume program</source>
        <translation>プログラムを再開</translation>
    </message>
    <message>
        <source>Start program</source>
        <translation>プログラムを開始</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>停止して閉じる</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>実行を続ける</translation>
    </message>
    <message>
        <source>Stop and continue</source>
        <translation>停止して続行</translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation>プログラムが実行中です。先にプログラムを停止してください。</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>プロジェクトを保存</translation>
    </message>
    <message>
        <source>Keyboard jogging was disarmed, because an input field has the focus: the keys now edit the field. Arm the keyboard again to jog.</source>
        <translation>入力欄にフォーカスが移ったため、キーボードジョグを無効にしました。キーは入力欄を編集します。ジョグするには、キーボードをもう一度有効にしてください。</translation>
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
        <translation>キーボードジョグ有効：矢印キーは X と Y、PgUp と PgDn は Z 方向に動かし、Alt を押すとツールを回転します。1〜6 を押しながら + または − で関節を動かします。Space と Esc でアームを停止します。</translation>
    </message>
    <message>
        <source>Changes the theme, sizes, units, speed cap, devices and keyboard shortcuts.</source>
        <translation>色、大きさ、単位、速度上限、デバイス、各コマンドのキー。</translation>
    </message>
    <message>
        <source>This activity stops when you close the window.</source>
        <translation>ウィンドウを閉じると停止します。</translation>
    </message>
    <message>
        <source>This activity stops when you change the connection.</source>
        <translation>接続を変更すると停止します。</translation>
    </message>
    <message>
        <source>Saves the project now. Tiller also saves all changes automatically. If another window or program has changed the file, Tiller asks whether to reload the file or keep both versions.</source>
        <translation>プロジェクトを今すぐ保存します。変更は自動的にも保存されます。別のウィンドウまたはプログラムがファイルを変更した場合は、再読み込みするか両方を残すかを確認します。</translation>
    </message>
    <message>
        <source>Converts a project for a different robot model, keeping either the poses or the joint positions.</source>
        <translation>別のロボットモデル用のプロジェクトを変換します：姿勢または関節を維持します。</translation>
    </message>
    <message>
        <source>A program is running. Stop the program before you open a different project.</source>
        <translation>プログラムが実行中です。別のプロジェクトを開く前にプログラムを停止してください。</translation>
    </message>
</context>
<context>
    <name>tiller::app::PanelDock</name>
    <message>
        <source>Dock</source>
        <translation>ドッキング</translation>
    </message>
    <message>
        <source>Moves this panel back to the main window.</source>
        <translation>このパネルをメインウィンドウに戻します。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Closes this panel. Use the View menu to show it again.</source>
        <translation>このパネルを閉じます。メニュー「ビュー」で戻せます。</translation>
    </message>
    <message>
        <source>Move, float or close %1</source>
        <translation>%1 を移動、切り離し、閉じる</translation>
    </message>
    <message>
        <source>Click to move, float or close this panel. Drag to move it.</source>
        <translation>クリック：このパネルを移動、切り離し、閉じる。ドラッグ：別の場所へ。</translation>
    </message>
</context>
<context>
    <name>tiller::app::PerspectiveActions</name>
    <message>
        <source>Save perspective</source>
        <translation>パースペクティブを保存</translation>
    </message>
    <message>
        <source>Saves the current panel layout to the current perspective.</source>
        <translation>現在のパネル配置を現在のパースペクティブに保存します。</translation>
    </message>
    <message>
        <source>Save perspective as…</source>
        <translation>パースペクティブに名前を付けて保存…</translation>
    </message>
    <message>
        <source>Saves the current panel layout under a new name.</source>
        <translation>現在のパネル配置を新しい名前で保存します。</translation>
    </message>
    <message>
        <source>Save perspective as</source>
        <translation>パースペクティブに名前を付けて保存</translation>
    </message>
    <message>
        <source>Rename perspective…</source>
        <translation>パースペクティブの名前を変更…</translation>
    </message>
    <message>
        <source>Renames the current perspective.</source>
        <translation>現在のパースペクティブに別の名前を付けます。</translation>
    </message>
    <message>
        <source>Rename perspective</source>
        <translation>パースペクティブの名前を変更</translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be renamed.</source>
        <translation>このパースペクティブは組み込みのため、名前を変更できません。</translation>
    </message>
    <message>
        <source>Delete perspective…</source>
        <translation>パースペクティブを削除…</translation>
    </message>
    <message>
        <source>Deletes the current perspective. The panel layout does not change.</source>
        <translation>現在のパースペクティブを削除します。パネル配置は変わりません。</translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be deleted.</source>
        <translation>このパースペクティブは組み込みのため、削除できません。</translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation>パースペクティブ %1</translation>
    </message>
    <message>
        <source>Perspective %1. Select a panel layout, or save the current layout.</source>
        <translation>パースペクティブ %1。パネルの配置を選ぶか、今の配置を保存します。</translation>
    </message>
    <message>
        <source>Perspective name</source>
        <translation>パースペクティブの名前</translation>
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
        <translation>名前</translation>
    </message>
    <message>
        <source>Delete perspective</source>
        <translation>パースペクティブを削除</translation>
    </message>
    <message>
        <source>Delete the perspective “%1”? This cannot be undone.</source>
        <translation>パースペクティブ「%1」を削除しますか？元に戻せません。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>残す</translation>
    </message>
    <message>
        <source>This perspective is built in. Save it under a different name.</source>
        <translation>このパースペクティブは組み込みです。別の名前で保存してください。</translation>
    </message>
</context>
<context>
    <name>tiller::app::Perspectives</name>
    <message>
        <source>Teach</source>
        <translation>教示</translation>
    </message>
    <message>
        <source>Shows the view, the waypoints next to it and the plots below.</source>
        <translation>ビュー、隣にウェイポイント、下にグラフを表示します。</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>監視</translation>
    </message>
    <message>
        <source>Shows inputs and outputs, a smaller view next to them and taller plots below.</source>
        <translation>入出力、隣に小さなビュー、下に高いグラフを表示します。</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Shows only the plots, as large as possible.</source>
        <translation>グラフだけをウィンドウ一杯に表示します。</translation>
    </message>
    <message>
        <source>Shows the panels as you saved them.</source>
        <translation>保存したときのパネル配置を表示します。</translation>
    </message>
    <message>
        <source>The perspective “%1” cannot be shown because the stored layout is damaged. Arrange the panels and save the perspective again.</source>
        <translation>パースペクティブ「%1」を表示できません：設定の配置が壊れています。パネルを並べて保存し直してください。</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>名前を入力してください。</translation>
    </message>
    <message>
        <source>The maximum number of perspectives has been reached. Delete a perspective first.</source>
        <translation>これ以上のパースペクティブは保存できません。先に一つ削除してください。</translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the layout of the earlier version is not compatible. Arrange the panels again. The new layout is saved automatically.</source>
        <translation>パネルはパースペクティブ「%1」の配置です：前のバージョンの配置はこのバージョンに合いません。並べ直してください。新しい配置は自動的に保存されます。</translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the stored layout is damaged or from another version. Arrange the panels again. The new layout is saved automatically.</source>
        <translation>パネルはパースペクティブ「%1」の配置です：設定の配置が壊れているか別のバージョンのものです。並べ直してください。新しい配置は自動的に保存されます。</translation>
    </message>
    <message>
        <source>The name is too long. Enter a shorter name.</source>
        <translation>名前が長すぎます。短い名前を入力してください。</translation>
    </message>
    <message>
        <source>A perspective with this name already exists. Choose a different name.</source>
        <translation>この名前のパースペクティブがあります。別の名前を選んでください。</translation>
    </message>
</context>
<context>
    <name>tiller::app::RecordingSettings</name>
    <message>
        <source>Folder for recordings</source>
        <translation>記録用フォルダー</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>Choose the folder for recordings</source>
        <translation>記録用フォルダーを選ぶ</translation>
    </message>
    <message>
        <source>File name pattern</source>
        <translation>ファイル名の型</translation>
    </message>
    <message>
        <source>{date}, {time}, {robot} and {number} are replaced when a recording starts.</source>
        <translation>{date}、{time}、{robot}、{number} は記録開始時に埋められます。</translation>
    </message>
    <message>
        <source>Packets/row</source>
        <translation>パケット/行</translation>
    </message>
    <message>
        <source>Search signals</source>
        <translation>信号を検索</translation>
    </message>
    <message>
        <source>Signals in a recording</source>
        <translation>記録の信号</translation>
    </message>
    <message>
        <source>All signals</source>
        <translation>すべての信号</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>File name</source>
        <translation>ファイル名</translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation>実験室の UR5e</translation>
    </message>
    <message>
        <source>Example: %1. {date}, {time}, {robot}, {number} are placeholders. Existing files are never overwritten.</source>
        <translation>例：%1。{date}、{time}、{robot}、{number} は自動で置き換わります。既存のファイルは上書きされません。</translation>
    </message>
    <message numerus="yes">
        <source>%n packet(s) per row: %1 rows per second from a robot that sends 500 packets per second.</source>
        <translation>
            <numerusform>一行 %n パケット：毎秒 500 パケットを送るロボットで毎秒 %1 行。</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording format</source>
        <translation>記録の形式</translation>
    </message>
    <message>
        <source>Free disk space to keep, in megabytes</source>
        <translation>ディスクに残しておくメガバイト数</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Recording stops, and the file is saved, before the free disk space falls below this value.</source>
        <translation>空き容量がこの値を下回る前に、記録を停止してファイルを完成させます。</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Keep free</source>
        <translation>空けておく</translation>
    </message>
    <message>
        <source>Maximum duration of a file, in minutes</source>
        <translation>1 ファイルの最大時間（分）</translation>
    </message>
    <message>
        <source>Maximum size of a file, in megabytes</source>
        <translation>1 ファイルの最大サイズ（メガバイト）</translation>
    </message>
    <message>
        <source>Recorded time before the trigger, in seconds</source>
        <translation>トリガー前の記録時間（秒）</translation>
    </message>
    <message>
        <source>Recorded time after the trigger, in seconds</source>
        <translation>トリガー後の記録時間（秒）</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>制限なし</translation>
    </message>
    <message>
        <source>A longer recording continues in a new file without losing packets.</source>
        <translation>長い記録は、パケットを失わずに新しいファイルに続きます。</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分</translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation>記録のメタデータ</translation>
    </message>
    <message>
        <source>When to enter metadata</source>
        <translation>メタデータの入力時期</translation>
    </message>
    <message>
        <source>Use for each recording</source>
        <translation>すべての記録に使用</translation>
    </message>
    <message>
        <source>Ask before each recording</source>
        <translation>記録のたびに確認</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>トリガー</translation>
    </message>
    <message>
        <source>None: recording starts at once</source>
        <translation>なし: すぐに記録を開始</translation>
    </message>
    <message>
        <source>Combine conditions with “and” and “or”, for example:
norm(actual_TCP_force_0, actual_TCP_force_1) &gt; 20 and robot_mode = 7
actual_digital_input_bits:3 = 1
runtime_state changes
program starts</source>
        <translation>条件は「and」と「or」で組み合わせます。例:
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
        <translation>新しいファイル</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>メタデータ</translation>
    </message>
    <message>
        <source>Before trigger</source>
        <translation>トリガー前</translation>
    </message>
    <message>
        <source>after</source>
        <translation>トリガー後</translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation>メタデータ…</translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>メタデータ (%n 項目)…</numerusform>
        </translation>
    </message>
    <message>
        <source>With a trigger, Tiller records only while the condition is true, in numbered files.</source>
        <translation>トリガーを設定すると、条件が成り立つ間だけ番号付きのファイルに記録します。</translation>
    </message>
</context>
<context>
    <name>tiller::app::ReportDialog</name>
    <message>
        <source>Include names and addresses of robots, inputs, outputs and files</source>
        <translation>ロボット、入力、出力、ファイルの名前とアドレスを含める</translation>
    </message>
    <message>
        <source>Report a problem</source>
        <translation>問題を報告</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>できごと</translation>
    </message>
    <message>
        <source>What did you do? What did you expect? What happened?</source>
        <translation>何をしましたか？何を期待しましたか？何が起きましたか？</translation>
    </message>
    <message>
        <source>Report files</source>
        <translation>レポートのファイル</translation>
    </message>
    <message>
        <source>File content</source>
        <translation>このファイルの内容</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>レポートを保存…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>The report is one file with the information that support needs. The complete content is listed below. You choose where to save the file. Tiller does not send it.</source>
        <translation>サポートに必要な情報をまとめた一つのファイルです。内容はすべて下に表示されます。選んだ場所に保存され、Tiller が送信することはありません。</translation>
    </message>
    <message>
        <source>Tiller report %1.zip</source>
        <translation>Tillerレポート %1.zip</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>レポートを保存</translation>
    </message>
    <message>
        <source>Zip archives (*.zip)</source>
        <translation>Zipアーカイブ (*.zip)</translation>
    </message>
</context>
<context>
    <name>tiller::app::SampleDialog</name>
    <message>
        <source>Open sample project</source>
        <translation>見本プロジェクトを開く</translation>
    </message>
    <message>
        <source>Each project was taught with a UR5e and runs on the simulated robot. You work on a copy. To keep your changes, save the project to a new file.</source>
        <translation>いずれも UR5e 用に教示され、シミュレートされたロボットで実行できます。コピーで作業します：保存するには新しいファイルを指定してください。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Open “%1”</source>
        <translation>「%1」を開く</translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Appearance and motion</source>
        <translation>外観と動作</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>デバイス</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation>設定をエクスポート…</translation>
    </message>
    <message>
        <source>Save all settings to one file, for another computer or as a backup</source>
        <translation>すべての設定を一つのファイルに保存（別のコンピューター用、またはバックアップ用）</translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation>設定を取り込む…</translation>
    </message>
    <message>
        <source>Show which settings a file will replace, then import them</source>
        <translation>置き換えられる内容を表示してから、ファイルの設定を取り込む</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>明</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>暗</translation>
    </message>
    <message>
        <source>Control size</source>
        <translation>キーと行の大きさ</translation>
    </message>
    <message>
        <source>Compact</source>
        <translation>コンパクト</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>マウス</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>タッチ</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Interface size</source>
        <translation>画面要素のサイズ</translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation>長さの単位</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>Orientation format</source>
        <translation>姿勢の表記</translation>
    </message>
    <message>
        <source>Roll, pitch, yaw in degrees</source>
        <translation>ロール、ピッチ、ヨー（度）</translation>
    </message>
    <message>
        <source>Rotation vector in radians, as in scripts</source>
        <translation>回転ベクトル（ラジアン）、スクリプトと同じ</translation>
    </message>
    <message>
        <source>Tiller speed cap</source>
        <translation>Tiller の速度上限</translation>
    </message>
    <message>
        <source>Maximum hold time</source>
        <translation>最大保持時間</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>After this time, a jog stops and its button must be pressed again. Freedrive has a limit of five minutes. A move to a position has a limit of its duration plus 5 s.</source>
        <translation>この時間でジョグは止まり、ボタンを押し直す必要があります。フリードライブは 5 分、ある位置への移動は所要時間と 5 s です。</translation>
    </message>
    <message>
        <source>Touch: large enough for fingers. In windows less than %1 px high, joint buttons, tabs and title bars remain smaller.</source>
        <translation>タッチ：指で押せる大きさ。高さ %1 px 未満のウィンドウでは、関節ボタン、タブ、タイトルバーは小さいままです。</translation>
    </message>
    <message>
        <source>Units for displaying and entering lengths, TCP speeds and orientations. The units in plots and files do not change.</source>
        <translation>長さ、TCP の速度、姿勢の表示と入力の単位です。グラフとファイルの単位は変わりません。</translation>
    </message>
    <message>
        <source>Speed cap</source>
        <translation>速度上限</translation>
    </message>
    <message>
        <source>Scales text, controls, plots and the view.</source>
        <translation>文字、操作部品、グラフ、ビューを拡大縮小します。</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted, limited to %1 % on this screen.</source>
        <translation>Tiller の次回起動時に有効になります。この画面では %1 % までです。</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted.</source>
        <translation>Tiller の次の起動から有効です。</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Restore default shortcuts</source>
        <translation>既定のキーに戻す</translation>
    </message>
    <message>
        <source>Shortcut for %1</source>
        <translation>%1 のキー</translation>
    </message>
    <message>
        <source>%1 is reserved for stopping the arm.</source>
        <translation>%1 はアームの停止用に予約されています。</translation>
    </message>
    <message>
        <source>%1 is assigned to “%2”. Remove that shortcut first.</source>
        <translation>%1 は「%2」に割り当てられています。先にそのショートカットを外してください。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>System language: %1</source>
        <translation>システムに合わせる：%1</translation>
    </message>
    <message>
        <source>Reopen window</source>
        <translation>ウィンドウを開き直す</translation>
    </message>
    <message>
        <source>Stops the arm, gives control back and reconnects. The plots restart. The project is saved.</source>
        <translation>アームを止め、制御を返却して接続し直します。グラフは最初から表示されます。プロジェクトは保存されます。</translation>
    </message>
    <message>
        <source>Language of the window and of the connection check. Files and scripts are not affected.</source>
        <translation>ウィンドウと接続チェックの言語です。ファイルとスクリプトには影響しません。</translation>
    </message>
    <message>
        <source>Monitor only</source>
        <translation>監視のみ</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>For PCs that only monitor: this window does not take control, set outputs or start programs. STOP still works.</source>
        <translation>監視専用のPC向け：このウィンドウは制御の取得、出力の設定、プログラムの開始を行いません。STOPは使えます。</translation>
    </message>
    <message>
        <source>Monitor only (set on the command line)</source>
        <translation>監視のみ（コマンドラインで指定）</translation>
    </message>
    <message>
        <source>Press the new shortcut in the field, or Backspace to remove the shortcut. While Tiller is in control, Space and Esc always stop the arm.</source>
        <translation>欄で新しいショートカットを押します。Backspaceで削除します。Tiller が制御している間は、SpaceとEscで必ずアームが停止します。</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted or the window is reopened. The plots then restart.</source>
        <translation>Tiller を再起動するか、ウィンドウを開き直すと有効になります。その際、プロットは最初から始まります。</translation>
    </message>
    <message>
        <source>Maximum speed of the TCP and elbow for all motion commanded by Tiller. A change takes effect immediately and stops any motion.</source>
        <translation>Tiller の全動作での TCP と肘の最高速度です。すぐに有効になり、実行中の動作を停止します。</translation>
    </message>
    <message>
        <source>▲ Above %1. Manual mode and the enabling device of the teach pendant do not limit jogging from a PC. The header shows a warning. The cap is reset when Tiller is closed.</source>
        <translation>▲ %1 を超えています。手動モードとペンダントのイネーブル装置は、PC からのジョグを制限しません。ヘッダーに警告が表示されます。上限は Tiller を閉じると元に戻ります。</translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsTransfer</name>
    <message>
        <source>Tiller settings (*.json)</source>
        <translation>Tiller の設定 (*.json)</translation>
    </message>
    <message>
        <source>Export settings</source>
        <translation>設定をエクスポート</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>設定を取り込む</translation>
    </message>
    <message>
        <source>Settings exported to %1</source>
        <translation>設定を %1 にエクスポートしました</translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed. %2</source>
        <translation>%1 は取り込まれませんでした。何も変わっていません。%2</translation>
    </message>
    <message>
        <source>Settings imported from %1. The previous settings were saved to %2.</source>
        <translation>%1 から設定を取り込みました。以前の設定は %2 にあります。</translation>
    </message>
</context>
<context>
    <name>tiller::app::Tutorial</name>
    <message>
        <source>First steps</source>
        <translation>最初のステップ</translation>
    </message>
    <message>
        <source>Shows a checklist in the view, from powering on to recording.</source>
        <translation>ビューに電源オンから記録までのチェックリストを表示します。</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>練習課題</translation>
    </message>
    <message>
        <source>Five tasks on the simulated robot. Each task checks the result.</source>
        <translation>シミュレートされたロボットでの五つの課題。課題ごとに結果を確認します。</translation>
    </message>
    <message>
        <source>Practice works only with the built-in simulated robot. The current robot is “%1”. Connect to the simulated robot first.</source>
        <translation>練習は内蔵のシミュレートされたロボットでのみ使えます。現在のロボットは「%1」です。先にシミュレートされたロボットに接続してください。</translation>
    </message>
    <message>
        <source>Practice: add “%1”</source>
        <translation>練習：「%1」を追加</translation>
    </message>
</context>
</TS>
