<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>ActionStep</name>
    <message>
        <source>No gripper is configured for this robot. Select a gripper under I/O &gt; Gripper.</source>
        <translation>Aucune pince n’est configurée pour ce robot. Sélectionnez-la sous E/S &gt; Pince.</translation>
    </message>
    <message>
        <source>Run route</source>
        <translation>Itinéraire</translation>
    </message>
    <message>
        <source>%1 did not turn on within %2 s. Check the connected device, then try again.</source>
        <translation>%1 ne s’est pas activée en %2 s. Vérifiez l’appareil raccordé, puis réessayez.</translation>
    </message>
    <message>
        <source>%1 did not turn off within %2 s. Check the connected device, then try again.</source>
        <translation>%1 ne s’est pas désactivée en %2 s. Vérifiez l’appareil raccordé, puis réessayez.</translation>
    </message>
    <message>
        <source>The action “%1” was not completed. %2</source>
        <translation>L’action « %1 » n’a pas été terminée. %2</translation>
    </message>
    <message>
        <source>The gripper did not stop moving within %1 s. Check the gripper, then try again.</source>
        <translation>La pince ne s’est pas arrêtée en %1 s. Vérifiez la pince, puis réessayez.</translation>
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
        <translation>Projet</translation>
    </message>
    <message>
        <source>Power and safety</source>
        <translation>Alimentation et sécurité</translation>
    </message>
    <message>
        <source>Control and programs</source>
        <translation>Contrôle et programmes</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Déplacement manuel</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Points de passage</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/S</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Tracés</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Perspectives</source>
        <translation>Perspectives</translation>
    </message>
    <message>
        <source>Move panels</source>
        <translation>Déplacer les panneaux</translation>
    </message>
    <message>
        <source>Application</source>
        <translation>Application</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Program steps</source>
        <translation>Étapes du programme</translation>
    </message>
</context>
<context>
    <name>ActionWords</name>
    <message>
        <source>%1 on</source>
        <translation>%1 activée</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1 désactivée</translation>
    </message>
    <message>
        <source>%1 on for %2 s</source>
        <translation>%1 activée %2 s</translation>
    </message>
    <message>
        <source>%1 off for %2 s</source>
        <translation>%1 désactivée %2 s</translation>
    </message>
    <message>
        <source>Wait until %1 is on (max. %2 s)</source>
        <translation>Attendre que %1 soit activée (max. %2 s)</translation>
    </message>
    <message>
        <source>Wait until %1 is off (max. %2 s)</source>
        <translation>Attendre que %1 soit désactivée (max. %2 s)</translation>
    </message>
    <message>
        <source>Wait until %1 is on</source>
        <translation>Attendre que %1 soit activée</translation>
    </message>
    <message>
        <source>Wait until %1 is off</source>
        <translation>Attendre que %1 soit désactivée</translation>
    </message>
    <message>
        <source>Wait %1 s</source>
        <translation>Attendre %1 s</translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation>Ouvrir la pince</translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation>Fermer la pince</translation>
    </message>
    <message>
        <source>Set an output</source>
        <translation>Régler une sortie</translation>
    </message>
    <message>
        <source>Pulse an output</source>
        <translation>Impulsion sur une sortie</translation>
    </message>
    <message>
        <source>Wait for an input</source>
        <translation>Attendre une entrée</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Attendre</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Jog, teach, run and monitor a Universal Robots arm from a PC.</source>
        <translation>Déplacer, apprendre, exécuter et surveiller un bras Universal Robots depuis un PC.</translation>
    </message>
    <message>
        <source>Start with the built-in simulated UR5e.</source>
        <translation>Commencer avec l’UR5e simulé intégré.</translation>
    </message>
    <message>
        <source>Connect to the robot at this address or host name.</source>
        <translation>Se connecter au robot à cette adresse ou à ce nom d’hôte.</translation>
    </message>
    <message>
        <source>Run the scripted demonstration on the simulated robot, write its files to this folder, and exit.</source>
        <translation>Exécuter la démonstration sur le robot simulé, écrire ses fichiers dans ce dossier et quitter.</translation>
    </message>
    <message>
        <source>Open this project file (.tiller).</source>
        <translation>Ouvrir ce fichier de projet (.tiller).</translation>
    </message>
    <message>
        <source>Colour theme: light or dark.</source>
        <translation>Thème de couleurs : light (clair) ou dark (sombre).</translation>
    </message>
    <message>
        <source>see tiller --help</source>
        <translation>voir tiller --help</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>argument inattendu &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--theme must be light or dark, not &quot;%1&quot;</source>
        <translation>--theme accepte light ou dark, pas &quot;%1&quot;</translation>
    </message>
    <message>
        <source>--robot and --simulator cannot be combined</source>
        <translation>--robot et --simulator ne peuvent pas être combinés</translation>
    </message>
    <message>
        <source>--demo works only on the simulated robot and cannot be combined with --robot</source>
        <translation>--demo ne fonctionne qu’avec le robot simulé et ne peut pas être combiné avec --robot</translation>
    </message>
    <message>
        <source>--demo requires a folder</source>
        <translation>--demo exige un dossier</translation>
    </message>
    <message>
        <source>--robot requires an address, e.g. --robot 192.168.0.10</source>
        <translation>--robot exige une adresse, p. ex. --robot 192.168.0.10</translation>
    </message>
    <message>
        <source>only one project can be opened; remove &quot;%1&quot;</source>
        <translation>un seul projet peut être ouvert ; retirez &quot;%1&quot;</translation>
    </message>
    <message>
        <source>Monitor only: do not change anything on the robot; STOP still works. Cannot be turned off in Settings.</source>
        <translation>Surveillance seule : ne rien changer sur le robot ; STOP reste actif. Ne peut pas être désactivé dans les réglages.</translation>
    </message>
    <message>
        <source>--demo moves the simulated robot and cannot be combined with --monitor-only</source>
        <translation>--demo déplace le robot simulé et ne peut pas être combiné avec --monitor-only</translation>
    </message>
    <message>
        <source>Open these recordings in the plots.</source>
        <translation>Ouvrir ces enregistrements dans les tracés.</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>Joint positions</source>
        <translation>Positions des articulations</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>Position du TCP</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>Courants des articulations</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Force au TCP</translation>
    </message>
    <message>
        <source>%1: not compared</source>
        <translation>%1 : pas comparé</translation>
    </message>
    <message>
        <source>%1: no values</source>
        <translation>%1 : aucune valeur</translation>
    </message>
    <message>
        <source>%1: within %2 at all times, maximum %3 at %4 s</source>
        <translation>%1 : toujours dans les limites de %2, maximum %3 à %4 s</translation>
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
        <translation>Le bras et le modèle divergent à %1 s : écart de %2 : %3</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the TCP deviates by %2</source>
        <translation>Le bras et le modèle divergent à %1 s : écart du TCP de %2</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: the current of %2 deviates by %3</source>
        <translation>Le bras et le modèle divergent à %1 s : écart du courant de %2 : %3</translation>
    </message>
    <message>
        <source>Arm and model diverge at %1 s: a force of %2 acts on the TCP</source>
        <translation>Le bras et le modèle divergent à %1 s : une force de %2 agit sur le TCP</translation>
    </message>
    <message>
        <source>The motion matches the model of a %1</source>
        <translation>Le mouvement correspond au modèle d’un %1</translation>
    </message>
    <message>
        <source>Nothing to compare: the arm was powered off or guided by hand for the whole recording.</source>
        <translation>Rien à comparer : le bras était hors tension ou guidé à la main pendant tout l’enregistrement.</translation>
    </message>
    <message>
        <source>The arm deviates from the model from the start of the recording. Check the payload and the robot model, and check whether something was touching the arm.</source>
        <translation>Le bras s’écarte du modèle dès le début de l’enregistrement. Vérifiez la charge utile, le modèle de robot et si quelque chose touchait le bras.</translation>
    </message>
    <message>
        <source>From this time on, the arm was pushed or held, its payload differed, or a joint did not follow its target.</source>
        <translation>À partir de cet instant, le bras a été poussé ou retenu, sa charge utile était différente, ou une articulation n’a pas suivi sa consigne.</translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: its sampling interval is too long. Record every packet.</source>
        <translation>Cet enregistrement ne peut pas être comparé à un modèle : son intervalle d’échantillonnage est trop long. Enregistrez chaque paquet.</translation>
    </message>
    <message>
        <source>Not compared with the arm model.</source>
        <translation>Pas comparé au modèle du bras.</translation>
    </message>
    <message>
        <source>The compared values match the model of a %1; other values were not recorded</source>
        <translation>Les valeurs comparées correspondent au modèle d’un %1 ; les autres valeurs n’ont pas été enregistrées</translation>
    </message>
    <message>
        <source>The recorded arm is a %1, but it was compared with the model of a %2</source>
        <translation>Le bras enregistré est un %1, mais il a été comparé au modèle d’un %2</translation>
    </message>
    <message>
        <source>No deviation from the model of a %1, but the recorded values may fit other models too</source>
        <translation>Aucun écart par rapport au modèle d’un %1, mais les valeurs enregistrées peuvent aussi correspondre à d’autres modèles</translation>
    </message>
    <message>
        <source>Compare the recording with the model of a %1.</source>
        <translation>Comparez l’enregistrement au modèle d’un %1.</translation>
    </message>
    <message>
        <source>%1: not compared because the recording has no %2; record all signals to an MCAP file</source>
        <translation>%1 : non comparé, car l’enregistrement ne contient pas %2 ; enregistrez tous les signaux en MCAP</translation>
    </message>
    <message>
        <source>This recording cannot be compared with a model: target or actual joint positions are missing. Record all signals to an MCAP file.</source>
        <translation>Cet enregistrement ne peut pas être comparé à un modèle : les positions articulaires de consigne ou réelles manquent. Enregistrez tous les signaux en MCAP.</translation>
    </message>
    <message>
        <source>%1: exceeds %2 starting at %3 s (%4), maximum %5 at %6 s</source>
        <translation>%1 : dépasse %2 à partir de %3 s (%4), maximum %5 à %6 s</translation>
    </message>
</context>
<context>
    <name>ControllerCodes</name>
    <message>
        <source>Near a joint limit</source>
        <translation>Près d’une butée d’articulation</translation>
    </message>
    <message>
        <source>A joint came close to its limit.</source>
        <translation>Une articulation s’est approchée de la fin de sa plage.</translation>
    </message>
    <message>
        <source>Jog the joint away from the limit, or change the waypoint.</source>
        <translation>Éloignez l’articulation de la limite ou modifiez le point de passage.</translation>
    </message>
    <message>
        <source>Near a tool orientation limit</source>
        <translation>Près d’une limite d’orientation de l’outil</translation>
    </message>
    <message>
        <source>The tool orientation came close to the limit set in the safety configuration.</source>
        <translation>L’orientation de l’outil s’est approchée de la limite de la configuration de sécurité.</translation>
    </message>
    <message>
        <source>Rotate the tool away from the limit, or change the waypoint.</source>
        <translation>Tournez l’outil en arrière ou changez le point de passage.</translation>
    </message>
    <message>
        <source>Near a safety plane</source>
        <translation>Près d’un plan de sécurité</translation>
    </message>
    <message>
        <source>The arm came close to a safety plane.</source>
        <translation>Le bras s’est approché d’un plan de sécurité.</translation>
    </message>
    <message>
        <source>Jog away from the plane, or change the waypoint.</source>
        <translation>Éloignez-vous du plan ou changez le point de passage.</translation>
    </message>
    <message>
        <source>Position deviates from path</source>
        <translation>La position s’écarte de la trajectoire</translation>
    </message>
    <message>
        <source>The arm is not at the commanded position.</source>
        <translation>Le bras n’est pas à la position commandée.</translation>
    </message>
    <message>
        <source>Check for obstacles; check payload, centre of gravity and mounting; reduce the acceleration.</source>
        <translation>Vérifiez s’il y a des obstacles ; vérifiez la charge utile, le centre de gravité et le montage ; réduisez l’accélération.</translation>
    </message>
    <message>
        <source>Singularity</source>
        <translation>Singularité</translation>
    </message>
    <message>
        <source>The linear move passes through a singularity of the arm.</source>
        <translation>Le mouvement linéaire traverse une singularité du bras.</translation>
    </message>
    <message>
        <source>Jog individual joints away from the singularity. Use MoveJ to pass through the region.</source>
        <translation>Sortez-en en déplaçant les articulations une par une ; utilisez MoveJ pour traverser cette zone.</translation>
    </message>
    <message>
        <source>Cannot hold position</source>
        <translation>Ne peut pas tenir sa position</translation>
    </message>
    <message>
        <source>The arm sagged or was pushed while at standstill.</source>
        <translation>Le bras s’est affaissé ou a été poussé à l’arrêt.</translation>
    </message>
    <message>
        <source>Check payload, centre of gravity and mounting.</source>
        <translation>Vérifiez charge utile, centre de gravité et montage.</translation>
    </message>
    <message>
        <source>Wrong payload or mounting</source>
        <translation>Charge utile ou montage erroné</translation>
    </message>
    <message>
        <source>The measured forces do not match the payload, or the arm was pushed when Freedrive started.</source>
        <translation>Les forces mesurées ne correspondent pas à la charge utile, ou le bras a été poussé au démarrage de Freedrive.</translation>
    </message>
    <message>
        <source>Collision detected by a joint</source>
        <translation>Collision détectée par une articulation</translation>
    </message>
    <message>
        <source>A joint required more torque than expected for the motion.</source>
        <translation>Une articulation a demandé plus de couple que le mouvement n’en exige.</translation>
    </message>
    <message>
        <source>Remove the obstacle. If the arm did not touch anything, check the payload.</source>
        <translation>Enlevez l’obstacle ; s’il n’y en avait pas, vérifiez la charge utile.</translation>
    </message>
    <message>
        <source>Collision detected at the tool</source>
        <translation>Collision détectée à l’outil</translation>
    </message>
    <message>
        <source>The force at the tool exceeded the limit.</source>
        <translation>La force à l’outil a dépassé sa limite.</translation>
    </message>
    <message>
        <source>Position deviation</source>
        <translation>Écart de position</translation>
    </message>
    <message>
        <source>A joint deviated from its commanded position.</source>
        <translation>Une articulation a quitté sa position commandée.</translation>
    </message>
    <message>
        <source>Check for obstacles, and check payload and mounting.</source>
        <translation>Vérifiez s’il y a des obstacles, et vérifiez la charge utile et le montage.</translation>
    </message>
    <message>
        <source>Too many protective stops</source>
        <translation>Trop d’arrêts de protection</translation>
    </message>
    <message>
        <source>One joint had fifty protective stops within eight hours.</source>
        <translation>Une articulation a eu cinquante arrêts de protection en huit heures.</translation>
    </message>
    <message>
        <source>Find and correct the cause of the stops, then restart the controller.</source>
        <translation>Trouvez et corrigez la cause des arrêts, puis redémarrez le contrôleur.</translation>
    </message>
    <message>
        <source>Sudden change in target position</source>
        <translation>Saut soudain de la position cible</translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in position.</source>
        <translation>Un programme a commandé un saut de position.</translation>
    </message>
    <message>
        <source>Start the program at the current position of the arm, and send servo targets in small steps.</source>
        <translation>Démarrez le programme à la position actuelle du bras et gardez de petits pas d’asservissement.</translation>
    </message>
    <message>
        <source>Sudden change in target speed</source>
        <translation>Saut soudain de la vitesse cible</translation>
    </message>
    <message>
        <source>A program commanded an abrupt change in speed.</source>
        <translation>Un programme a commandé un saut de vitesse.</translation>
    </message>
    <message>
        <source>Reduce the acceleration, or smooth the path.</source>
        <translation>Réduisez l’accélération ou lissez la trajectoire.</translation>
    </message>
    <message>
        <source>Protective stop requested by a program</source>
        <translation>Arrêt de protection demandé par un programme</translation>
    </message>
    <message>
        <source>The running program requested the stop.</source>
        <translation>Le programme en cours a demandé l’arrêt.</translation>
    </message>
    <message>
        <source>See the preceding program messages in the log.</source>
        <translation>Consultez les messages précédents du programme dans le journal.</translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation>Le robot est en commande locale</translation>
    </message>
    <message>
        <source>A script was sent, but the robot accepts commands only from its teach pendant.</source>
        <translation>Un script a été envoyé, mais le robot n’accepte que les commandes de son pupitre.</translation>
    </message>
    <message>
        <source>Switch to Remote control on the teach pendant.</source>
        <translation>Passez en commande à distance sur le pupitre.</translation>
    </message>
    <message>
        <source>Controller message C%1</source>
        <translation>Message C%1 du contrôleur</translation>
    </message>
    <message>
        <source>Tiller has no description of this message code.</source>
        <translation>Tiller n’a pas de description de ce code de message.</translation>
    </message>
    <message>
        <source>Look up C%1 in the manufacturer&apos;s error code directory.</source>
        <translation>Cherchez C%1 dans le répertoire des codes d’erreur du fabricant.</translation>
    </message>
    <message>
        <source>Correct the payload and the mounting, and do not push the arm when Freedrive starts.</source>
        <translation>Corrigez la charge utile et le montage, et ne poussez pas le bras au démarrage de Freedrive.</translation>
    </message>
</context>
<context>
    <name>DerivedSignal</name>
    <message>
        <source>compute a signal</source>
        <translation>calculer un signal</translation>
    </message>
    <message>
        <source>The signal “%1” does not exist. See the signal list for the names.</source>
        <translation>Il n’existe pas de signal « %1 ». Les noms figurent dans la liste des signaux.</translation>
    </message>
    <message>
        <source>The expression contains no signal. Add the name of a signal.</source>
        <translation>L’expression ne contient aucun signal. Ajoutez le nom d’un signal.</translation>
    </message>
    <message>
        <source>The expression contains too many signals. Use fewer signals.</source>
        <translation>L’expression contient trop de signaux. Utilisez moins de signaux.</translation>
    </message>
    <message>
        <source>The expression must evaluate to one number.</source>
        <translation>Le résultat de l’expression doit être un nombre.</translation>
    </message>
    <message>
        <source>The text is too long. Use a shorter name or expression.</source>
        <translation>Le texte est trop long. Utilisez un nom ou une expression plus courts.</translation>
    </message>
    <message>
        <source>Enter a name, an equals sign and an expression, for example |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</source>
        <translation>Saisissez un nom, un signe égal et une expression, p. ex. |F| [N] = norm(actual_TCP_force_0, actual_TCP_force_1)</translation>
    </message>
    <message>
        <source>Too many equals signs. Use == to compare values.</source>
        <translation>Trop de signes égal. Pour une comparaison, utilisez ==</translation>
    </message>
    <message>
        <source>The functions are nested too deeply. Use at most %1 levels.</source>
        <translation>Les fonctions sont trop imbriquées. Utilisez au plus %1 niveaux.</translation>
    </message>
    <message>
        <source>The closing parenthesis of “%1” is missing.</source>
        <translation>La parenthèse fermante de « %1 » manque.</translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression, a cut-off frequency in Hz and optionally the order (1 to 8), for example %1(actual_q_0, 10, 2).</source>
        <translation>« %1 » nécessite un signal ou une expression, une fréquence de coupure en Hz et, en option, l’ordre (1 à 8), par exemple %1(actual_q_0, 10, 2).</translation>
    </message>
    <message>
        <source>“%1” needs a signal or an expression and a time window in seconds, for example %1(actual_q_0, 0.5).</source>
        <translation>« %1 » nécessite un signal ou une expression et une fenêtre de temps en secondes, par exemple %1(actual_q_0, 0.5).</translation>
    </message>
    <message>
        <source>The cut-off frequency of “%1” must be between %2 and %3 Hz.</source>
        <translation>La fréquence de coupure de « %1 » doit être comprise entre %2 et %3 Hz.</translation>
    </message>
    <message>
        <source>The time window of “%1” must be between 0.001 and 60 seconds.</source>
        <translation>La fenêtre de temps de « %1 » doit être comprise entre 0,001 et 60 secondes.</translation>
    </message>
    <message>
        <source>The function “%1” does not exist.</source>
        <translation>La fonction « %1 » n’existe pas.</translation>
    </message>
    <message>
        <source>“%1” contains a decimal comma. Write decimal numbers with a point: %2</source>
        <translation>« %1 » contient une virgule décimale. Écrivez les nombres décimaux avec un point : %2</translation>
    </message>
</context>
<context>
    <name>DeviceTrainer</name>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
    <message>
        <source>Device axes</source>
        <translation>Axes du périphérique</translation>
    </message>
</context>
<context>
    <name>Doctor</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 de plus</translation>
    </message>
    <message>
        <source>The robot&apos;s software is too old. Update the software to %1.%2 or newer.</source>
        <translation>Le logiciel du robot est trop ancien. Mettez-le à jour en %1.%2 ou plus récent.</translation>
    </message>
    <message>
        <source>Some values and the control registers are missing. Update the robot&apos;s software to %1.%2 or newer.</source>
        <translation>Des valeurs et les registres de commande manquent. Mettez le logiciel du robot à jour en %1.%2 ou plus récent.</translation>
    </message>
    <message>
        <source>Inspect the arm and remove the cause. Then press “Recover…” in the Tiller header, or use the teach pendant.</source>
        <translation>Inspectez le bras, éliminez la cause, puis rétablissez : appuyez sur « Rétablir… » dans l’en-tête ou utilisez le pupitre.</translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes, with the button in the Tiller header or on the teach pendant.</source>
        <translation>Mettez le bras sous tension et desserrez les freins, avec le bouton de l’en-tête de Tiller ou sur le pupitre.</translation>
    </message>
    <message>
        <source>the RTDE port accepts connections but does not respond</source>
        <translation>le port RTDE accepte les connexions mais ne répond pas</translation>
    </message>
    <message>
        <source>the service on port %1 does not use RTDE</source>
        <translation>le service du port %1 n’utilise pas RTDE</translation>
    </message>
    <message>
        <source>Too many RTDE clients are connected, or the controller has stopped responding. Close other programs, then restart the controller.</source>
        <translation>Trop de clients RTDE, ou le contrôleur ne répond plus : fermez d’autres programmes, puis redémarrez le contrôleur.</translation>
    </message>
    <message>
        <source>Check the address. The address may belong to another device, or another program may be using the port.</source>
        <translation>Vérifiez l’adresse : il s’agit d’un autre appareil, ou un autre programme utilise le port.</translation>
    </message>
    <message>
        <source>protocol version %1</source>
        <translation>version de protocole %1</translation>
    </message>
    <message>
        <source>another program uses %1</source>
        <translation>un autre programme utilise %1</translation>
    </message>
    <message>
        <source>Close the other program that controls this robot (another Tiller window, ROS, ur_rtde).</source>
        <translation>Terminez l’autre programme qui commande ce robot (une autre fenêtre, ROS, ur_rtde).</translation>
    </message>
    <message>
        <source>this software version has no registers 24 to 47</source>
        <translation>cette version du logiciel n’a pas de registres 24 à 47</translation>
    </message>
    <message>
        <source>Update the robot&apos;s software to 3.9, 5.3 or newer.</source>
        <translation>Mettez le logiciel du robot à jour en 3.9, 5.3 ou plus récent.</translation>
    </message>
    <message>
        <source>registers 24 to 47 are free</source>
        <translation>les registres 24 à 47 sont libres</translation>
    </message>
    <message>
        <source>a fieldbus adapter or another program uses %1</source>
        <translation>un adaptateur de bus de terrain ou un autre programme utilise %1</translation>
    </message>
    <message>
        <source>No action needed for jogging. To use these registers, disable EtherNet/IP, PROFINET or MODBUS in the robot&apos;s installation.</source>
        <translation>Rien à faire pour le déplacement manuel. Pour utiliser ces registres, désactivez EtherNet/IP, PROFINET ou MODBUS dans l’installation du robot.</translation>
    </message>
    <message>
        <source>registers 0 to 23 are free</source>
        <translation>les registres 0 à 23 sont libres</translation>
    </message>
    <message>
        <source>the robot accepts the subscription but sends no data</source>
        <translation>le robot accepte l’abonnement mais n’envoie pas de données</translation>
    </message>
    <message>
        <source>Close other RTDE programs, then restart the robot&apos;s controller.</source>
        <translation>Fermez d’autres programmes RTDE, puis redémarrez le contrôleur du robot.</translation>
    </message>
    <message>
        <source>%1 of %2 packets per second</source>
        <translation>%1 paquets sur %2 par seconde</translation>
    </message>
    <message>
        <source>Packets are missing. Use a cable instead of a wireless link, and close other programs that put load on the robot or this PC.</source>
        <translation>Il manque des paquets. Utilisez un câble plutôt qu’une liaison radio et fermez d’autres programmes qui chargent le robot ou ce PC.</translation>
    </message>
    <message>
        <source>priority %1</source>
        <translation>priorité %1</translation>
    </message>
    <message>
        <source>the system does not grant this user real-time priority</source>
        <translation>le système n’accorde pas à cet utilisateur de priorité temps réel</translation>
    </message>
    <message>
        <source>CPUs may enter deep sleep states, which delay real-time loops</source>
        <translation>les processeurs peuvent entrer en veille profonde, ce qui retarde les boucles temps réel</translation>
    </message>
    <message>
        <source>TCP %1 mm from the flange, payload %2 kg</source>
        <translation>TCP à %1 mm de la bride, charge utile %2 kg</translation>
    </message>
    <message>
        <source>If a tool is mounted, set the TCP and the payload in the robot&apos;s installation: a wrong payload causes protective stops and makes the arm drift in Freedrive.</source>
        <translation>Si un outil est monté, réglez le TCP et la charge utile dans l’installation du robot : une charge utile fausse cause des arrêts de protection et fait dériver le bras en Freedrive.</translation>
    </message>
    <message>
        <source>“%1” is not a valid address, and no host with this name was found</source>
        <translation>&quot;%1&quot; n’est pas une adresse valide, et aucun hôte de ce nom n’a été trouvé</translation>
    </message>
    <message>
        <source>Enter the IP address shown on the teach pendant under About, or ask your network administrator for the host name.</source>
        <translation>Saisissez l’adresse IP affichée par le pupitre sous « À propos », ou demandez le nom d’hôte à votre administrateur réseau.</translation>
    </message>
    <message>
        <source>%1 does not respond</source>
        <translation>%1 ne répond pas</translation>
    </message>
    <message>
        <source>no network route to %1</source>
        <translation>aucune route réseau vers %1</translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and no firewall blocks the connection.</source>
        <translation>Vérifiez que le robot est allumé, que le câble est branché et qu’aucun pare-feu ne bloque la connexion.</translation>
    </message>
    <message>
        <source>Assign this PC an address in the robot&apos;s network (the same first three numbers), and check the cable.</source>
        <translation>Donnez à ce PC une adresse dans le réseau du robot (les mêmes trois premiers nombres) et vérifiez le câble.</translation>
    </message>
    <message>
        <source>%1 responds, but provides no robot services</source>
        <translation>%1 répond, mais n’offre aucun service de robot</translation>
    </message>
    <message>
        <source>Check that this is the address of the robot. A robot that has just been switched on may need another minute.</source>
        <translation>Vérifiez qu’il s’agit de l’adresse du robot. Un robot qui vient d’être allumé peut avoir besoin d’une minute de plus.</translation>
    </message>
    <message>
        <source>%1 responds</source>
        <translation>%1 répond</translation>
    </message>
    <message>
        <source>dashboard, port %1</source>
        <translation>dashboard, port %1</translation>
    </message>
    <message>
        <source>port %1</source>
        <translation>port %1</translation>
    </message>
    <message>
        <source>port %1 is closed</source>
        <translation>le port %1 est fermé</translation>
    </message>
    <message>
        <source>port %1 does not respond</source>
        <translation>le port %1 ne répond pas</translation>
    </message>
    <message>
        <source>Enable this interface on the robot under Settings &gt; Security &gt; Services.</source>
        <translation>Activez cette interface sur le robot sous Réglages &gt; Sécurité &gt; Services.</translation>
    </message>
    <message>
        <source>A firewall may be blocking this port. Allow TCP port %1 to the robot.</source>
        <translation>Un pare-feu bloque peut-être ce port. Autorisez le port TCP %1 vers le robot.</translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant. Until then, Tiller can only monitor.</source>
        <translation>Passez le robot en commande à distance en haut à droite du pupitre. D’ici là, Tiller ne peut qu’observer.</translation>
    </message>
    <message>
        <source>the dashboard accepts connections but does not respond</source>
        <translation>le dashboard accepte les connexions mais ne répond pas</translation>
    </message>
    <message>
        <source>the service on port %1 is not a dashboard server</source>
        <translation>le service du port %1 n’est pas un serveur Dashboard</translation>
    </message>
    <message>
        <source>Restart the robot&apos;s controller. If the problem persists, see the controller log.</source>
        <translation>Redémarrez le contrôleur du robot ; si le problème persiste, consultez son journal.</translation>
    </message>
    <message>
        <source>Check the address, and check that no other program is using this port.</source>
        <translation>Vérifiez l’adresse et qu’aucun autre programme n’utilise ce port.</translation>
    </message>
    <message>
        <source>this series has no Local/Remote switch</source>
        <translation>cette série n’a pas de commutateur Local/Distant</translation>
    </message>
    <message>
        <source>Remote</source>
        <translation>Distant</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>Local</translation>
    </message>
    <message>
        <source>neither the dashboard (port %1) nor the Robot API (port %2) is available</source>
        <translation>ni le Dashboard (port %1) ni la Robot API (port %2) ne sont disponibles</translation>
    </message>
    <message>
        <source>the primary interface sends no data about the arm</source>
        <translation>l’interface primaire n’envoie aucune donnée sur le bras</translation>
    </message>
    <message>
        <source>Check that this is the address of the robot, and restart its controller.</source>
        <translation>Vérifiez qu’il s’agit de l’adresse du robot, et redémarrez son contrôleur.</translation>
    </message>
    <message>
        <source>robot type %1 is not known to this version of Tiller</source>
        <translation>cette version de Tiller ne connaît pas le type de robot %1</translation>
    </message>
    <message>
        <source>Monitoring works. Limits and previews use the dimensions that the robot reports; jog slowly at first.</source>
        <translation>L’observation fonctionne. Les limites et aperçus utilisent les dimensions indiquées par le robot ; déplacez d’abord lentement.</translation>
    </message>
    <message>
        <source>Address resolves</source>
        <translation>L’adresse se résout</translation>
    </message>
    <message>
        <source>Host responds</source>
        <translation>L’hôte répond</translation>
    </message>
    <message>
        <source>RTDE port</source>
        <translation>Port RTDE</translation>
    </message>
    <message>
        <source>Primary port</source>
        <translation>Port primaire</translation>
    </message>
    <message>
        <source>Secondary port</source>
        <translation>Port secondaire</translation>
    </message>
    <message>
        <source>Real-time port</source>
        <translation>Port temps réel</translation>
    </message>
    <message>
        <source>Dashboard or Robot API</source>
        <translation>Dashboard ou Robot API</translation>
    </message>
    <message>
        <source>RTDE protocol</source>
        <translation>Protocole RTDE</translation>
    </message>
    <message>
        <source>Controller software</source>
        <translation>Logiciel du contrôleur</translation>
    </message>
    <message>
        <source>Robot model</source>
        <translation>Modèle de robot</translation>
    </message>
    <message>
        <source>Remote control</source>
        <translation>Commande à distance</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sécurité</translation>
    </message>
    <message>
        <source>Power and brakes</source>
        <translation>Alimentation et freins</translation>
    </message>
    <message>
        <source>Control registers free</source>
        <translation>Registres de commande libres</translation>
    </message>
    <message>
        <source>Data rate</source>
        <translation>Débit de données</translation>
    </message>
    <message>
        <source>Real-time priority on this PC</source>
        <translation>Priorité temps réel sur ce PC</translation>
    </message>
    <message>
        <source>TCP and payload</source>
        <translation>TCP et charge utile</translation>
    </message>
    <message>
        <source>real-time loops can keep the CPUs out of deep sleep states</source>
        <translation>les boucles temps réel peuvent empêcher la veille profonde des processeurs</translation>
    </message>
    <message>
        <source>Enable the dashboard server on the robot under Settings &gt; Security &gt; Services. On PolyScope X, the Robot API requires version 10.11 or newer.</source>
        <translation>Activez le serveur Dashboard sur le robot sous Réglages &gt; Sécurité &gt; Services. PolyScope X nécessite la version 10.11 ou plus récente pour la Robot API.</translation>
    </message>
    <message>
        <source>Robot API %1, port %2; popups can be closed only on the teach pendant</source>
        <translation>Robot API %1, port %2 ; les messages ne peuvent être fermés que sur le pupitre</translation>
    </message>
    <message>
        <source>Fieldbus registers free</source>
        <translation>Registres de bus de terrain libres</translation>
    </message>
    <message>
        <source>Wake-up latency on this PC</source>
        <translation>Latence de réveil sur ce PC</translation>
    </message>
</context>
<context>
    <name>Freedrive</name>
    <message>
        <source>All axes</source>
        <translation>Tous les axes</translation>
    </message>
    <message>
        <source>Position only</source>
        <translation>Position seule</translation>
    </message>
    <message>
        <source>Orientation only</source>
        <translation>Orientation seule</translation>
    </message>
    <message>
        <source>XY plane</source>
        <translation>Plan XY</translation>
    </message>
    <message>
        <source>Z only</source>
        <translation>Z seul</translation>
    </message>
    <message>
        <source>Wait for standstill before you start Freedrive.</source>
        <translation>Attendez l’arrêt du bras avant de démarrer Freedrive.</translation>
    </message>
    <message>
        <source>The arm would drift: the robot measures %1 with a payload of %2 kg. Do not touch the tool, or correct the payload and the TCP.</source>
        <translation>Le bras dériverait : il mesure %1 avec une charge utile de %2 kg. Lâchez l’outil, ou corrigez la charge utile et le TCP.</translation>
    </message>
</context>
<context>
    <name>Gamepad</name>
    <message>
        <source>left bumper</source>
        <translation>gâchette gauche</translation>
    </message>
    <message>
        <source>Left stick: X and Y. Right stick: Z and rotation. Hold the right bumper to rotate with both sticks.</source>
        <translation>Manche gauche : X et Y. Manche droit : Z et rotation. Maintenez la gâchette droite pour tourner avec les deux manches.</translation>
    </message>
</context>
<context>
    <name>InterfaceSize</name>
    <message>
        <source>This screen has a high resolution. Increase “Interface size” in Settings to enlarge text, controls and plots.</source>
        <translation>Cet écran a une haute résolution. Augmentez « Taille de l’interface » dans les réglages pour agrandir textes, commandes et tracés.</translation>
    </message>
</context>
<context>
    <name>JogActions</name>
    <message>
        <source>Jog speed %1</source>
        <translation>Vitesse manuelle %1</translation>
    </message>
    <message>
        <source>Jog step %1, %2°</source>
        <translation>Pas manuel %1, %2°</translation>
    </message>
    <message>
        <source>Arm or disarm keyboard jogging</source>
        <translation>Armer ou désarmer le déplacement au clavier</translation>
    </message>
    <message>
        <source>While the keyboard is armed, the arrow keys move the arm and a border surrounds the window. The keyboard is disarmed after 30 s without use.</source>
        <translation>Clavier armé, les flèches déplacent le bras et un cadre entoure la fenêtre. Se désarme après 30 s sans utilisation.</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse…</source>
        <translation>Manette et SpaceMouse…</translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation>Affiche les valeurs actuelles de chaque appareil et la direction dans laquelle le bras irait.</translation>
    </message>
    <message>
        <source>Zero here</source>
        <translation>Zéro ici</translation>
    </message>
    <message>
        <source>Shows the TCP displacement from the current position. Press again to show the displacement since the start of the last motion.</source>
        <translation>Affiche le déplacement du TCP depuis cette position. Appuyez de nouveau pour l’afficher depuis le début du dernier mouvement.</translation>
    </message>
    <message>
        <source>Stops the arm. The next press uses this speed.</source>
        <translation>Arrête le bras. Le prochain appui utilise cette vitesse.</translation>
    </message>
    <message>
        <source>Moves the arm by this distance while the button is held.</source>
        <translation>Déplace le bras de cette distance tant que le bouton est maintenu.</translation>
    </message>
    <message>
        <source>Each press moves the arm by this distance.</source>
        <translation>Chaque appui déplace le bras de cette distance.</translation>
    </message>
    <message>
        <source>Jog until contact (%1 N)</source>
        <translation>Déplacer jusqu’au contact (%1 N)</translation>
    </message>
    <message>
        <source>Moves slowly while the button is held and stops when the contact force reaches this value.</source>
        <translation>Déplace lentement tant que le bouton est maintenu et s’arrête quand la force de contact atteint cette valeur.</translation>
    </message>
    <message>
        <source>Other jog speed…</source>
        <translation>Autre vitesse manuelle…</translation>
    </message>
    <message>
        <source>Sets the TCP speed. Rotation and joint speeds change in proportion.</source>
        <translation>Définit la vitesse du TCP. Les vitesses de rotation et des articulations changent en proportion.</translation>
    </message>
    <message>
        <source>Other jog step…</source>
        <translation>Autre pas manuel…</translation>
    </message>
    <message>
        <source>Sets the step length. The step angle does not change.</source>
        <translation>Définit la longueur du pas. L’angle du pas ne change pas.</translation>
    </message>
    <message>
        <source>Other jog angle…</source>
        <translation>Autre rotation manuelle…</translation>
    </message>
    <message>
        <source>Sets the step angle of tool and joint rotations. The step length does not change.</source>
        <translation>Définit l’angle du pas pour les rotations de l’outil et des articulations. La longueur ne change pas.</translation>
    </message>
    <message>
        <source>Other contact force for jogging…</source>
        <translation>Autre force de contact manuelle…</translation>
    </message>
    <message>
        <source>Sets the contact force in N that ends the motion.</source>
        <translation>Définit la force de contact en N qui termine le mouvement.</translation>
    </message>
    <message>
        <source>Freedrive: %1</source>
        <translation>Freedrive : %1</translation>
    </message>
    <message>
        <source>Selects the axes that can be moved by hand during Freedrive.</source>
        <translation>Sélectionne les axes mobiles à la main pendant Freedrive.</translation>
    </message>
</context>
<context>
    <name>JogColumn</name>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
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
        <translation>Épaule</translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation>Coude</translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation>Poignet 1</translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation>Poignet 2</translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation>Poignet 3</translation>
    </message>
</context>
<context>
    <name>KeyStateProbe</name>
    <message>
        <source>Key-state check unavailable on this platform (%1): Tiller relies on window events to detect key releases.</source>
        <translation>Contrôle de touche indisponible sur cette plate-forme (%1) : Tiller détecte le relâchement des touches par les événements de la fenêtre.</translation>
    </message>
    <message>
        <source>Key-state check active: Tiller checks with the display server every 10 ms whether the button or key is still pressed.</source>
        <translation>Contrôle de touche actif : Tiller vérifie toutes les 10 ms auprès du serveur d’affichage que le bouton ou la touche est encore enfoncé.</translation>
    </message>
    <message>
        <source>Key-state check unavailable: Tiller could not open a second connection to the display server. Tiller relies on window events to detect key releases.</source>
        <translation>Contrôle de touche indisponible : pas de seconde connexion au serveur d’affichage. Tiller détecte le relâchement des touches par les événements de la fenêtre.</translation>
    </message>
</context>
<context>
    <name>LimiterAdvice</name>
    <message>
        <source>Elbow almost straight</source>
        <translation>Coude presque tendu</translation>
    </message>
    <message>
        <source>Elbow almost straight: %1 speed</source>
        <translation>Coude presque tendu : %1 de la vitesse</translation>
    </message>
    <message>
        <source>bend the elbow</source>
        <translation>pliez le coude</translation>
    </message>
    <message>
        <source>jog %1 or bend the elbow</source>
        <translation>allez en %1 ou pliez le coude</translation>
    </message>
    <message>
        <source>Wrist near the base axis</source>
        <translation>Poignet près de l’axe de la base</translation>
    </message>
    <message>
        <source>Wrist near the base axis: %1 speed</source>
        <translation>Poignet près de l’axe de la base : %1 de la vitesse</translation>
    </message>
    <message>
        <source>move outwards</source>
        <translation>allez vers l’extérieur</translation>
    </message>
    <message>
        <source>jog %1 or rotate the base</source>
        <translation>allez en %1 ou tournez la base</translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°</source>
        <translation>Poignet 2 près de 0° ou 180°</translation>
    </message>
    <message>
        <source>Wrist 2 near 0° or 180°: %1 speed</source>
        <translation>Poignet 2 près de 0° ou 180° : %1 de la vitesse</translation>
    </message>
    <message>
        <source>rotate wrist 2</source>
        <translation>tournez le poignet 2</translation>
    </message>
    <message>
        <source>jog %1 or rotate wrist 2</source>
        <translation>allez en %1 ou tournez le poignet 2</translation>
    </message>
    <message>
        <source>%1 %2° from its limit</source>
        <translation>%1 à %2° de sa limite</translation>
    </message>
    <message>
        <source>rotate %1 %2</source>
        <translation>tournez %1 %2</translation>
    </message>
    <message>
        <source>jog %1 or rotate %2 %3</source>
        <translation>allez en %1 ou tournez %2 %3</translation>
    </message>
    <message>
        <source>TCP at the speed cap: %1 speed</source>
        <translation>TCP au plafond de vitesse : %1 de la vitesse</translation>
    </message>
    <message>
        <source>change the cap in Settings</source>
        <translation>modifiez le plafond dans les réglages</translation>
    </message>
    <message>
        <source>Elbow at the speed cap: %1 speed</source>
        <translation>Coude au plafond de vitesse : %1 de la vitesse</translation>
    </message>
    <message>
        <source>Rotation at the speed cap: %1 speed</source>
        <translation>Rotation au plafond de vitesse : %1 de la vitesse</translation>
    </message>
    <message>
        <source>%1 at its maximum speed: %2 speed</source>
        <translation>%1 à sa vitesse maximale : %2 de la vitesse</translation>
    </message>
    <message>
        <source>choose a lower speed</source>
        <translation>choisissez une vitesse plus basse</translation>
    </message>
    <message>
        <source>move away</source>
        <translation>s’en éloigner</translation>
    </message>
    <message>
        <source>jog %1</source>
        <translation>déplacer %1</translation>
    </message>
    <message>
        <source>%1 is %2 from %3: %4 speed</source>
        <translation>%1 est à %2 de %3 : %4 de la vitesse</translation>
    </message>
    <message>
        <source>%1 is %2 from %3</source>
        <translation>%1 est à %2 de %3</translation>
    </message>
</context>
<context>
    <name>LocalSimulator</name>
    <message>
        <source>Simulated UR5e</source>
        <translation>UR5e simulé</translation>
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
        <translation>Le bras peut être déplacé à la main.</translation>
    </message>
    <message>
        <source>MOVING</source>
        <translation>EN MOUVEMENT</translation>
    </message>
    <message>
        <source>The robot reports that the arm is moving.</source>
        <translation>Le robot signale que le bras bouge.</translation>
    </message>
    <message>
        <source>Remote</source>
        <translation>Distant</translation>
    </message>
    <message>
        <source>Local</source>
        <translation>Local</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>SANS DONNÉES</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Prise de contrôle…</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>Freedrive</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Prêt</translation>
    </message>
    <message>
        <source>In control</source>
        <translation>Contrôlé</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Refusé</translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation>Non contrôlé</translation>
    </message>
    <message>
        <source>Commands take longer than 20 ms: the arm responds with a delay. Jog slowly.</source>
        <translation>Les commandes prennent plus de 20 ms : le bras réagit avec retard. Déplacez lentement.</translation>
    </message>
    <message>
        <source>Good: the arm responds immediately and stops within 250 ms if the link fails.</source>
        <translation>Bon : le bras réagit aussitôt et s’arrête en 250 ms si la liaison échoue.</translation>
    </message>
    <message>
        <source>Last 10 s: %1 packets, %2 late, %3 lost</source>
        <translation>10 dernières s : %1 paquets, %2 en retard, %3 perdus</translation>
    </message>
    <message>
        <source>Since connecting: %1 packets, %2 late, %3 lost</source>
        <translation>Depuis la connexion : %1 paquets, %2 en retard, %3 perdus</translation>
    </message>
    <message>
        <source>A packet counts as late when it arrives more than half a period after its expected time.</source>
        <translation>Un paquet est en retard s’il arrive plus d’une demi-période après l’heure attendue.</translation>
    </message>
    <message>
        <source>No robot connected</source>
        <translation>Aucun robot connecté</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Connexion…</translation>
    </message>
    <message>
        <source>Late: %1 s</source>
        <translation>Retard : %1 s</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source> · %1 late</source>
        <translation> · %1 en retard</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · %1 perdus</translation>
    </message>
    <message>
        <source>LINK · JOG STOPS</source>
        <translation>LIEN · ARRÊT</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>LIEN</translation>
    </message>
    <message>
        <source>LINK · JOG MAY STOP</source>
        <translation>LIEN · ARRÊT POSSIBLE</translation>
    </message>
    <message>
        <source>LINK · ARM LAGS</source>
        <translation>LIEN · BRAS EN RETARD</translation>
    </message>
    <message>
        <source>LINK · GOOD</source>
        <translation>LIEN · BON</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Connecter…</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Mettre sous tension</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>Desserrer les freins</translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation>Rétablir…</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Prendre le contrôle</translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation>Met le bras sous tension. Les freins restent serrés.</translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation>Le bras peut s’affaisser de quelques millimètres. Restez à l’écart.</translation>
    </message>
    <message>
        <source>Shows the cause of the stop, the five seconds before it, and the recovery steps. The arm does not move.</source>
        <translation>Affiche la cause de l’arrêt, les cinq secondes précédentes et les étapes de rétablissement. Le bras ne bouge pas.</translation>
    </message>
    <message>
        <source>Data late</source>
        <translation>Données en retard</translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation>Démarre le programme de commande sur le robot. Demande confirmation avant d’arrêter un autre programme.</translation>
    </message>
    <message>
        <source>Monitoring</source>
        <translation>Observation</translation>
    </message>
    <message>
        <source>Select the simulator or enter the address of a robot.</source>
        <translation>Sélectionnez le simulateur ou saisissez l’adresse d’un robot.</translation>
    </message>
    <message>
        <source>Packets are late or lost: jogging may stop and plots may have gaps. Use a cable instead of a wireless link, and close other programs.</source>
        <translation>Des paquets sont en retard ou perdus : le déplacement peut s’arrêter et les tracés ont des lacunes. Utilisez un câble au lieu d’une liaison sans fil et fermez d’autres programmes.</translation>
    </message>
</context>
<context>
    <name>ModeWords</name>
    <message>
        <source>No controller</source>
        <translation>Pas de contrôleur</translation>
    </message>
    <message>
        <source>The robot&apos;s controller is not running. Restart the control box.</source>
        <translation>Le contrôleur du robot ne fonctionne pas. Redémarrez le boîtier de commande.</translation>
    </message>
    <message>
        <source>Arm disconnected</source>
        <translation>Bras hors ligne</translation>
    </message>
    <message>
        <source>The controller has no connection to the arm. See the teach pendant for the cause.</source>
        <translation>Le contrôleur n’a pas de liaison avec le bras. Consultez le pupitre.</translation>
    </message>
    <message>
        <source>Confirm safety</source>
        <translation>Confirmer la sécurité</translation>
    </message>
    <message>
        <source>Confirm the safety configuration on the teach pendant.</source>
        <translation>Confirmez la configuration de sécurité sur le pupitre.</translation>
    </message>
    <message>
        <source>Booting</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>The arm is starting. Wait a few seconds.</source>
        <translation>Le bras démarre. Attendez quelques secondes.</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>Hors tension</translation>
    </message>
    <message>
        <source>The arm is powered off. Power on the arm.</source>
        <translation>Le bras est éteint. Mettez-le sous tension.</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Sous tension</translation>
    </message>
    <message>
        <source>The arm is powered on and initializing. Wait a moment.</source>
        <translation>Le bras est sous tension et s’initialise. Attendez un instant.</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Au repos</translation>
    </message>
    <message>
        <source>The brakes are engaged. Release the brakes.</source>
        <translation>Les freins sont serrés. Desserrez-les.</translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation>Backdrive</translation>
    </message>
    <message>
        <source>The arm is being moved by hand with its brakes released. Release the Freedrive button.</source>
        <translation>Le bras est déplacé à la main, freins desserrés. Relâchez le bouton Freedrive.</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marche</translation>
    </message>
    <message>
        <source>Updating firmware</source>
        <translation>Mise à jour du firmware</translation>
    </message>
    <message>
        <source>The joints&apos; firmware is being updated. Do not switch off the power until the update is complete.</source>
        <translation>Le firmware des articulations est mis à jour. Ne coupez pas l’alimentation avant la fin de la mise à jour.</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>No safety stop is active.</source>
        <translation>Aucun arrêt de sécurité n’est actif.</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Réduit</translation>
    </message>
    <message>
        <source>The reduced safety limits are active.</source>
        <translation>Les limites de sécurité réduites sont actives.</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>Arrêt de protection</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Récupération</translation>
    </message>
    <message>
        <source>The arm is outside a safety limit. Use the teach pendant to move the arm back within the limits.</source>
        <translation>Le bras est hors d’une limite de sécurité. Ramenez-le dans ses limites avec le pupitre.</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>Arrêt de sauvegarde</translation>
    </message>
    <message>
        <source>A safeguard is open. Close it and, if a reset is configured, press the reset button.</source>
        <translation>Une protection est ouverte. Fermez-la et, si un réarmement est configuré, appuyez sur le bouton de réarmement.</translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation>Arrêt d’urgence système</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Arrêt d’urgence</translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation>Violation de sécurité</translation>
    </message>
    <message>
        <source>A safety limit was exceeded and power was cut. Check the cause, then restart the safety system.</source>
        <translation>Une limite de sécurité a été dépassée et le courant coupé. Vérifiez la cause, puis redémarrez le système de sécurité.</translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation>Défaut de sécurité</translation>
    </message>
    <message>
        <source>The safety system found a fault. Check the robot&apos;s log, then restart the safety system.</source>
        <translation>Le système de sécurité a trouvé un défaut. Vérifiez le journal du robot, puis redémarrez le système de sécurité.</translation>
    </message>
    <message>
        <source>Validate joints</source>
        <translation>Valider les articulations</translation>
    </message>
    <message>
        <source>A joint was replaced. Validate the joints on the teach pendant.</source>
        <translation>Une articulation a été remplacée. Validez les articulations sur le pupitre.</translation>
    </message>
    <message>
        <source>Undefined</source>
        <translation>Indéfini</translation>
    </message>
    <message>
        <source>The controller does not report its safety mode. Check the teach pendant.</source>
        <translation>Le contrôleur n’indique pas son mode de sécurité. Consultez le pupitre.</translation>
    </message>
    <message>
        <source>Automatic safeguard stop</source>
        <translation>Arrêt de sauvegarde automatique</translation>
    </message>
    <message>
        <source>The automatic mode safeguard is open. Close it, or switch to manual mode.</source>
        <translation>La protection du mode automatique est ouverte. Fermez-la ou passez en mode manuel.</translation>
    </message>
    <message>
        <source>Enabling device stop</source>
        <translation>Arrêt du dispositif de validation</translation>
    </message>
    <message>
        <source>The enabling device is not held. Hold it in its middle position.</source>
        <translation>Le dispositif de validation n’est pas tenu. Tenez-le en position médiane.</translation>
    </message>
    <message>
        <source>Pendant enabling stop</source>
        <translation>Arrêt de validation du pupitre</translation>
    </message>
    <message>
        <source>IMMI emergency stop</source>
        <translation>Arrêt d’urgence IMMI</translation>
    </message>
    <message>
        <source>IMMI safeguard stop</source>
        <translation>Arrêt de sauvegarde IMMI</translation>
    </message>
    <message>
        <source>The moulding machine&apos;s safeguard is open. Close it.</source>
        <translation>La protection de la presse à injecter est ouverte. Fermez-la.</translation>
    </message>
    <message>
        <source>PROFIsafe waiting</source>
        <translation>PROFIsafe en attente</translation>
    </message>
    <message>
        <source>The robot is waiting for the PROFIsafe controller. Check the fieldbus and the PROFIsafe parameters.</source>
        <translation>Le robot attend le contrôleur PROFIsafe. Vérifiez le bus de terrain et les paramètres PROFIsafe.</translation>
    </message>
    <message>
        <source>PROFIsafe automatic stop</source>
        <translation>Arrêt automatique PROFIsafe</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an automatic mode safeguard stop. Clear the request on that controller.</source>
        <translation>Le contrôleur PROFIsafe demande l’arrêt de sauvegarde du mode automatique. Annulez la demande sur ce contrôleur.</translation>
    </message>
    <message>
        <source>PROFIsafe safeguard stop</source>
        <translation>Arrêt de sauvegarde PROFIsafe</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests a safeguard stop. Clear the request on that controller.</source>
        <translation>Le contrôleur PROFIsafe demande un arrêt de sauvegarde. Annulez la demande sur ce contrôleur.</translation>
    </message>
    <message>
        <source>PROFIsafe emergency stop</source>
        <translation>Arrêt d’urgence PROFIsafe</translation>
    </message>
    <message>
        <source>Safety API stop</source>
        <translation>Arrêt par Safety API</translation>
    </message>
    <message>
        <source>A program requests a safeguard stop through the safety API. Clear the request in that program.</source>
        <translation>Un programme demande un arrêt de sauvegarde par l’API de sécurité. Annulez la demande dans ce programme.</translation>
    </message>
    <message>
        <source>I/O plane stop</source>
        <translation>Arrêt par plan d’E/S</translation>
    </message>
    <message>
        <source>The tool crossed a safety plane that is enabled by an input. Move the tool back with the teach pendant, or turn the input off.</source>
        <translation>L’outil a franchi un plan de sécurité activé par une entrée. Sortez-le avec le pupitre ou désactivez l’entrée.</translation>
    </message>
    <message>
        <source>Program stopping</source>
        <translation>Arrêt du programme</translation>
    </message>
    <message>
        <source>The program on the robot is stopping.</source>
        <translation>Le programme sur le robot s’arrête.</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Pas de programme</translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation>Aucun programme ne tourne sur le robot.</translation>
    </message>
    <message>
        <source>Program running</source>
        <translation>Programme en cours</translation>
    </message>
    <message>
        <source>A program is running on the robot and may move the arm.</source>
        <translation>Un programme tourne sur le robot et peut bouger le bras.</translation>
    </message>
    <message>
        <source>Program pausing</source>
        <translation>Mise en pause</translation>
    </message>
    <message>
        <source>The program is pausing.</source>
        <translation>Le programme se met en pause.</translation>
    </message>
    <message>
        <source>Program paused</source>
        <translation>Programme en pause</translation>
    </message>
    <message>
        <source>Press “Play” to continue the interrupted motion, or stop the program to discard it.</source>
        <translation>Appuyez sur Lecture pour poursuivre le mouvement interrompu, ou arrêtez le programme pour l’abandonner.</translation>
    </message>
    <message>
        <source>Program resuming</source>
        <translation>Reprise du programme</translation>
    </message>
    <message>
        <source>The program is resuming, and the arm may move.</source>
        <translation>Le programme reprend : le bras peut bouger.</translation>
    </message>
    <message>
        <source>Unknown robot mode %1. See the teach pendant.</source>
        <translation>Mode de robot inconnu %1. Consultez le pupitre.</translation>
    </message>
    <message>
        <source>Unknown safety mode %1. See the teach pendant.</source>
        <translation>Mode de sécurité inconnu %1. Consultez le pupitre.</translation>
    </message>
    <message>
        <source>Unknown program state %1. See the teach pendant.</source>
        <translation>État de programme inconnu %1. Consultez le pupitre.</translation>
    </message>
    <message>
        <source>The brakes are released. The arm is at standstill.</source>
        <translation>Les freins sont desserrés. Le bras est à l’arrêt.</translation>
    </message>
    <message>
        <source>The controller stopped the arm. Find the cause, wait 5 s, then unlock the protective stop.</source>
        <translation>Le contrôleur a arrêté le bras. Trouvez la cause, attendez 5 s, puis déverrouillez l’arrêt de protection.</translation>
    </message>
    <message>
        <source>The cell&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation>L’arrêt d’urgence de la cellule est enfoncé. Relâchez-le, puis mettez sous tension et desserrez les freins.</translation>
    </message>
    <message>
        <source>The emergency stop button of the robot is pressed. Twist it clockwise to release it, then power on the arm and release the brakes.</source>
        <translation>Le bouton d’arrêt d’urgence du robot est enfoncé. Tournez-le dans le sens horaire pour le déverrouiller, puis mettez sous tension et desserrez les freins.</translation>
    </message>
    <message>
        <source>The moulding machine&apos;s emergency stop is pressed. Release it, then power on the arm and release the brakes.</source>
        <translation>L’arrêt d’urgence de la presse à injecter est enfoncé. Relâchez-le, puis mettez sous tension et desserrez les freins.</translation>
    </message>
    <message>
        <source>The PROFIsafe controller requests an emergency stop. Clear the request on that controller, then power on the arm and release the brakes.</source>
        <translation>Le contrôleur PROFIsafe demande un arrêt d’urgence. Annulez la demande sur ce contrôleur, puis mettez sous tension et desserrez les freins.</translation>
    </message>
    <message>
        <source>The enabling button of the teach pendant is not held. Hold it in its middle position.</source>
        <translation>Le bouton de validation du pupitre n’est pas tenu. Tenez-le en position médiane.</translation>
    </message>
</context>
<context>
    <name>OutputGripper</name>
    <message>
        <source>The robot did not confirm the outputs. Another program or the installation may control them.</source>
        <translation>Le robot n’a pas confirmé les sorties. Un autre programme ou l’installation les commande peut-être.</translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation>Pince : fermer</translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation>Pince : ouvrir</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>en attente…</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>open requested</source>
        <translation>ouverture demandée</translation>
    </message>
    <message>
        <source>close requested</source>
        <translation>fermeture demandée</translation>
    </message>
    <message>
        <source>both outputs off</source>
        <translation>les deux sorties désactivées</translation>
    </message>
    <message>
        <source>both outputs on</source>
        <translation>les deux sorties activées</translation>
    </message>
    <message>
        <source>Choose different outputs for closing and opening.</source>
        <translation>Choisissez deux sorties différentes : l’une ferme, l’autre ouvre.</translation>
    </message>
</context>
<context>
    <name>PanelActions</name>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Records the robot data to a file until you stop the recording.</source>
        <translation>Enregistre les données du robot dans un fichier jusqu’à l’arrêt de l’enregistrement.</translation>
    </message>
    <message>
        <source>A recording is already running.</source>
        <translation>Un enregistrement est déjà en cours.</translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation>Connectez-vous d’abord à un robot.</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Arrêter l’enregistrement</translation>
    </message>
    <message>
        <source>Stops the recording and completes its file.</source>
        <translation>Arrête l’enregistrement et termine son fichier.</translation>
    </message>
    <message>
        <source>No recording is running.</source>
        <translation>Aucun enregistrement en cours.</translation>
    </message>
    <message>
        <source>Pause or resume the plots</source>
        <translation>Mettre en pause ou reprendre les tracés</translation>
    </message>
    <message>
        <source>Freezes the plots while data and recording continue. Press again to return to the newest samples.</source>
        <translation>Fige les tracés ; les données et l’enregistrement continuent. Appuyez de nouveau pour revenir aux derniers échantillons.</translation>
    </message>
    <message>
        <source>Export the plots…</source>
        <translation>Exporter les tracés…</translation>
    </message>
    <message>
        <source>Saves the visible range as an image, PDF page or table of values.</source>
        <translation>Enregistre la plage visible comme image, page PDF ou tableau de valeurs.</translation>
    </message>
    <message>
        <source>Plots: last %1</source>
        <translation>Tracés : derniers %1</translation>
    </message>
    <message>
        <source>Sets the time range of the plots.</source>
        <translation>Règle la plage de temps des tracés.</translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation>Chercher des entrées et sorties</translation>
    </message>
    <message>
        <source>Finds a terminal or a register by its number or name.</source>
        <translation>Trouve une borne ou un registre par numéro ou nom.</translation>
    </message>
    <message>
        <source>Rename selected input or output</source>
        <translation>Renommer l’entrée ou la sortie sélectionnée</translation>
    </message>
    <message>
        <source>Renames the input or output in the selected row of the I/O tab.</source>
        <translation>Renomme l’entrée ou la sortie de la ligne sélectionnée de l’onglet E/S.</translation>
    </message>
    <message>
        <source>Switch selected output</source>
        <translation>Commuter la sortie sélectionnée</translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on or off.</source>
        <translation>Active ou désactive la sortie sélectionnée de l’onglet E/S.</translation>
    </message>
    <message>
        <source>Pulse selected output</source>
        <translation>Impulsion sur la sortie sélectionnée</translation>
    </message>
    <message>
        <source>Switches the selected output on the I/O tab on for 0.5 s, then off.</source>
        <translation>Active la sortie sélectionnée de l’onglet E/S pendant 0,5 s, puis la désactive.</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>Chercher dans le journal</translation>
    </message>
    <message>
        <source>Shows only entries that contain the search text.</source>
        <translation>Affiche seulement les entrées qui contiennent le texte cherché.</translation>
    </message>
    <message>
        <source>Log: show all</source>
        <translation>Journal : tout montrer</translation>
    </message>
    <message>
        <source>Log: show warnings and errors</source>
        <translation>Journal : montrer avertissements et erreurs</translation>
    </message>
    <message>
        <source>Log: show errors only</source>
        <translation>Journal : montrer les erreurs</translation>
    </message>
    <message>
        <source>Selects which log entries are shown.</source>
        <translation>Choisit les entrées du journal à afficher.</translation>
    </message>
    <message>
        <source>Copy the log</source>
        <translation>Copier le journal</translation>
    </message>
    <message>
        <source>Copies the selected entries. If no entry is selected, copies all visible entries.</source>
        <translation>Copie les entrées sélectionnées, ou toutes les entrées visibles.</translation>
    </message>
    <message>
        <source>Export the log…</source>
        <translation>Exporter le journal…</translation>
    </message>
    <message>
        <source>Writes the visible entries to a file.</source>
        <translation>Écrit les entrées visibles dans un fichier.</translation>
    </message>
    <message>
        <source>Search plot signals</source>
        <translation>Chercher des signaux pour les tracés</translation>
    </message>
    <message>
        <source>Opens the list of all signals. To add a signal to a plot, drag it, double-click it or press Return.</source>
        <translation>Ouvre la liste de tous les signaux. Ajoutez-en un à un tracé par glisser-déposer, double-clic ou Entrée.</translation>
    </message>
    <message>
        <source>New plot page</source>
        <translation>Nouvelle page de tracés</translation>
    </message>
    <message>
        <source>Adds an empty page at the end. All pages share the time axis.</source>
        <translation>Ajoute une page vide à la fin. Toutes partagent l’axe du temps.</translation>
    </message>
    <message>
        <source>Show the entire history</source>
        <translation>Afficher tout l’historique</translation>
    </message>
    <message>
        <source>Shows all data in memory and scales each plot automatically.</source>
        <translation>Affiche toutes les données en mémoire et ajuste l’échelle de chaque tracé.</translation>
    </message>
    <message>
        <source>Add note…</source>
        <translation>Ajouter une note…</translation>
    </message>
    <message>
        <source>Adds a note at the selected cursor if it is visible, otherwise at the end of the plots.</source>
        <translation>Ajoute une note au curseur sélectionné s&apos;il est visible, sinon à la fin des tracés.</translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation>Montrer ou cacher %1</translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation>Détacher %1</translation>
    </message>
    <message>
        <source>Moves the panel to a separate window, e.g. on a second screen, or back to the main window.</source>
        <translation>Place le panneau dans une fenêtre séparée, p. ex. pour un second écran, ou le remet en place.</translation>
    </message>
    <message>
        <source>Moves the panel to this side of the main window.</source>
        <translation>Déplace ce panneau de ce côté de la fenêtre principale.</translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation>Afficher les tracés standard</translation>
    </message>
    <message>
        <source>Replaces the pages of live data with the standard page. Pages with recordings are kept.</source>
        <translation>Remplace les pages de données en direct par la page standard. Les pages avec des enregistrements sont conservées.</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Ouvrir un enregistrement…</translation>
    </message>
    <message>
        <source>Shows a recording or a table of another program on its own page.</source>
        <translation>Affiche un enregistrement ou un tableau d’un autre programme sur sa propre page.</translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation>Fermer les enregistrements</translation>
    </message>
    <message>
        <source>Removes all opened recordings from the plots. The files are kept.</source>
        <translation>Retire tous les enregistrements ouverts des tracés. Les fichiers sont conservés.</translation>
    </message>
    <message>
        <source>No recording is open.</source>
        <translation>Aucun enregistrement n’est ouvert.</translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation>Comparer au modèle du bras…</translation>
    </message>
    <message>
        <source>Compares the displayed recording with the model of its arm.</source>
        <translation>Compare l’enregistrement affiché au modèle de son bras.</translation>
    </message>
    <message>
        <source>Show the page of a recording first.</source>
        <translation>Affichez d’abord la page d’un enregistrement.</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>Valeurs aux curseurs</translation>
    </message>
    <message>
        <source>Shows or hides the table of values at the cursors and between them.</source>
        <translation>Affiche ou masque le tableau des valeurs aux curseurs et entre eux.</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>Spectre et XY</translation>
    </message>
    <message>
        <source>Shows or hides the spectrum and the XY plot of two signals.</source>
        <translation>Affiche ou masque le spectre et le tracé XY de deux signaux.</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>Placer %1 à gauche</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>Placer %1 à droite</translation>
    </message>
    <message>
        <source>%1 to the top</source>
        <translation>Placer %1 en haut</translation>
    </message>
    <message>
        <source>%1 to the bottom</source>
        <translation>Placer %1 en bas</translation>
    </message>
    <message>
        <source>Plots: start or stop playback</source>
        <translation>Tracés : démarrer ou arrêter la lecture</translation>
    </message>
    <message>
        <source>Moves cursor A in real time through the recording or the paused plots. The Layout menu contains other speeds.</source>
        <translation>Déplace le curseur A en temps réel dans l’enregistrement ou les tracés en pause. Le menu « Disposition » contient d’autres vitesses.</translation>
    </message>
</context>
<context>
    <name>PlotMenu</name>
    <message>
        <source>Remove lane %1</source>
        <translation>Retirer la piste %1</translation>
    </message>
    <message>
        <source>Add note here…</source>
        <translation>Ajouter une note ici…</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Montrer %1</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>Cacher %1</translation>
    </message>
    <message>
        <source>Show values of %1 at the cursors</source>
        <translation>Afficher les valeurs de %1 aux curseurs</translation>
    </message>
    <message>
        <source>Move %1 to a separate plot</source>
        <translation>Mettre %1 sur un tracé à part</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Ôter %1</translation>
    </message>
    <message>
        <source>Warn when %1</source>
        <translation>Avertir quand %1</translation>
    </message>
    <message>
        <source>Do not warn when %1</source>
        <translation>Ne pas avertir quand %1</translation>
    </message>
    <message>
        <source>Rate of change of %1</source>
        <translation>Taux de variation de %1</translation>
    </message>
    <message>
        <source>Moving mean of %1 over 0.5 s</source>
        <translation>Moyenne mobile de %1 sur 0,5 s</translation>
    </message>
    <message>
        <source>Mean %1</source>
        <translation>Moyenne %1</translation>
    </message>
    <message>
        <source>Norm of the curves in this plot</source>
        <translation>Norme des courbes de ce tracé</translation>
    </message>
    <message>
        <source>New plot below</source>
        <translation>Nouveau tracé dessous</translation>
    </message>
    <message>
        <source>New plot to the right</source>
        <translation>Nouveau tracé à droite</translation>
    </message>
    <message>
        <source>Remove this plot</source>
        <translation>Retirer ce tracé</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout montrer</translation>
    </message>
    <message>
        <source>Low-pass filter of %1 at 10 Hz</source>
        <translation>Filtre passe-bas de %1 à 10 Hz</translation>
    </message>
    <message>
        <source>Filtered %1</source>
        <translation>%1 filtré</translation>
    </message>
    <message>
        <source>Left axis</source>
        <translation>Axe gauche</translation>
    </message>
    <message>
        <source>Right axis</source>
        <translation>Axe droit</translation>
    </message>
    <message>
        <source>Edit %1…</source>
        <translation>Modifier %1…</translation>
    </message>
    <message>
        <source>Axis limits…</source>
        <translation>Limites de l’axe…</translation>
    </message>
    <message>
        <source>Scale to curves</source>
        <translation>Ajuster aux courbes</translation>
    </message>
</context>
<context>
    <name>PlotPane</name>
    <message>
        <source>%1 (right)</source>
        <translation>%1 (droite)</translation>
    </message>
</context>
<context>
    <name>Practice</name>
    <message>
        <source>Waiting for the protective stop.</source>
        <translation>En attente de l’arrêt de protection.</translation>
    </message>
    <message>
        <source>The arm is in a protective stop. Press “Recover…” in the header.</source>
        <translation>Le bras est en arrêt de protection. Appuyez sur « Rétablir… » dans l’en-tête.</translation>
    </message>
    <message>
        <source>Unlocked. The arm is not running yet: follow the steps on the recovery page.</source>
        <translation>Déverrouillé. Le bras n’est pas encore en marche : suivez les étapes de la page de récupération.</translation>
    </message>
    <message>
        <source>Unlocked. Take control again.</source>
        <translation>Déverrouillé. Reprenez le contrôle.</translation>
    </message>
    <message>
        <source>The arm is running and under your control again.</source>
        <translation>Le bras est en marche et de nouveau sous votre contrôle.</translation>
    </message>
    <message>
        <source>No new frame yet. Use “3 points” in the Frames tab.</source>
        <translation>Pas encore de nouveau repère. Utilisez « 3 points » dans l’onglet Repères.</translation>
    </message>
    <message>
        <source>“%1” meets the requirements.</source>
        <translation>« %1 » répond aux exigences.</translation>
    </message>
    <message>
        <source>The Z axis of “%1” differs from the base Z axis by %2°. The third point must be on the +Y side.</source>
        <translation>L’axe Z de « %1 » s’écarte de %2° de l’axe Z de la base. Le troisième point doit être du côté +Y.</translation>
    </message>
    <message>
        <source>The X axis of “%1” differs from the base Y axis by %2°.</source>
        <translation>L’axe X de « %1 » s’écarte de %2° de l’axe Y de la base.</translation>
    </message>
    <message>
        <source>“%1” was not taught with the arm: the TCP was never at its origin.</source>
        <translation>« %1 » n’a pas été appris avec le bras : le TCP n’a jamais été à son origine.</translation>
    </message>
    <message>
        <source>The waypoint was deleted. Press “Start” to add a new waypoint.</source>
        <translation>Le point de passage a été supprimé. Appuyez sur Démarrer pour en ajouter un nouveau.</translation>
    </message>
    <message>
        <source>“%1” has not changed. The arm is %2 away from the waypoint along X.</source>
        <translation>« %1 » n’a pas changé. Le bras en est éloigné de %2 selon X.</translation>
    </message>
    <message>
        <source>“%1” has moved by %2 and is %3 from the expected position.</source>
        <translation>« %1 » a été déplacé de %2 et se trouve à %3 de la position attendue.</translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the tool orientation changed.</source>
        <translation>« %1 » est à la position attendue, mais l’orientation de l’outil a changé.</translation>
    </message>
    <message>
        <source>“%1” matches the part again.</source>
        <translation>« %1 » correspond de nouveau à la pièce.</translation>
    </message>
    <message>
        <source>“%1” is at the expected position, but the arm is not. Touch up the waypoint with the arm at the part.</source>
        <translation>« %1 » est à la position attendue, mais pas le bras. Retouchez le point avec le bras sur la pièce.</translation>
    </message>
    <message>
        <source>Slowed down to %1. Continue.</source>
        <translation>Ralenti à %1. Continuez.</translation>
    </message>
    <message>
        <source>No limit reached yet. The line below the pad will show the limit.</source>
        <translation>Aucune limite atteinte. La ligne sous le pavé l’indiquera.</translation>
    </message>
    <message>
        <source>Limit reached. Now jog back: %1 of %2.</source>
        <translation>Limite atteinte. Revenez maintenant : %1 sur %2.</translation>
    </message>
    <message>
        <source>You reached the limit and moved back.</source>
        <translation>Vous avez atteint la limite et êtes revenu.</translation>
    </message>
    <message>
        <source>Recording: %1 s of %2 s.</source>
        <translation>Enregistrement : %1 s sur %2 s.</translation>
    </message>
    <message>
        <source>The recording is too short. Record for at least three seconds.</source>
        <translation>L’enregistrement est trop court. Enregistrez pendant au moins trois secondes.</translation>
    </message>
    <message>
        <source>No recording yet. Press “Record” above the plots.</source>
        <translation>Pas encore d’enregistrement. Appuyez sur « Enregistrer » au-dessus des tracés.</translation>
    </message>
    <message>
        <source>Recorded. Enter the force shown in the plot.</source>
        <translation>Enregistré. Saisissez la force que montre le tracé.</translation>
    </message>
    <message>
        <source>%1 does not match the recording. Look at the Fz curve.</source>
        <translation>%1 ne correspond pas à l’enregistrement. Regardez la courbe Fz.</translation>
    </message>
    <message>
        <source>Correct: the force was %1.</source>
        <translation>Juste : la force était de %1.</translation>
    </message>
    <message>
        <source>Recover from a protective stop</source>
        <translation>Se rétablir d’un arrêt de protection</translation>
    </message>
    <message>
        <source>Teach a frame</source>
        <translation>Apprendre un repère</translation>
    </message>
    <message>
        <source>Touch up a waypoint</source>
        <translation>Retoucher un point de passage</translation>
    </message>
    <message>
        <source>Find the reach limit</source>
        <translation>Trouver la limite de portée</translation>
    </message>
    <message>
        <source>Record and measure</source>
        <translation>Enregistrer et mesurer</translation>
    </message>
    <message>
        <source>Press “Start” to simulate a collision that causes a protective stop. Find out what stopped the arm, wait five seconds, unlock the arm and take control again.</source>
        <translation>Appuyez sur Démarrer pour simuler une collision qui provoque un arrêt de protection. Trouvez ce qui a arrêté le bras, attendez cinq secondes, déverrouillez-le et reprenez le contrôle.</translation>
    </message>
    <message>
        <source>Teach a frame from three points in the Frames tab. Its X axis must point along the base Y+ direction and its Z axis up: record the origin, then a point further along Y+, then a point further along X−.</source>
        <translation>Apprenez un repère à partir de trois points dans l’onglet Repères. Son axe X doit pointer selon Y+ de la base et son axe Z vers le haut : prenez l’origine, puis un point plus loin selon Y+, puis un point plus loin selon X−.</translation>
    </message>
    <message>
        <source>Press “Start” to add a waypoint “part” at the current position of the arm. The part then moves by %1 along the base X+ direction. Jog to the part, select the waypoint and touch it up (U).</source>
        <translation>Appuyez sur Démarrer pour ajouter un point de passage « pièce » à la position actuelle du bras. La pièce se déplace ensuite de %1 selon X+ de la base. Allez-y, sélectionnez le point et retouchez-le (U).</translation>
    </message>
    <message>
        <source>Jog outwards, away from the base, until a limit halves the speed. The line below the pad shows the limit and how to move away from it. Then jog back by %1.</source>
        <translation>Déplacez vers l’extérieur, loin de la base, jusqu’à ce qu’une limite réduise la vitesse de moitié. La ligne sous le pavé nomme la limite et la façon d’en sortir. Revenez ensuite de %1.</translation>
    </message>
    <message>
        <source>Press “Start” to simulate a hand pressing on the tool from above. Record for at least three seconds, then stop. Read the force Fz in the plots and enter the value.</source>
        <translation>Appuyez sur Démarrer pour simuler une main qui appuie sur l’outil par le haut. Enregistrez au moins trois secondes, puis arrêtez. Lisez la force Fz dans les tracés et saisissez-la.</translation>
    </message>
    <message>
        <source>part</source>
        <translation>pièce</translation>
    </message>
</context>
<context>
    <name>ProgramText</name>
    <message>
        <source>Maximum distance</source>
        <translation>Distance maximale</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>Échouer</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>“%1” is %2. The value must be between %3 and %4.</source>
        <translation>« %1 » vaut %2 ; la valeur doit être entre %3 et %4.</translation>
    </message>
    <message>
        <source>The group “%1” contains no waypoints. Add waypoints to the group, or select a different group.</source>
        <translation>Le groupe « %1 » ne contient aucun point de passage. Ajoutez des points au groupe ou sélectionnez un autre groupe.</translation>
    </message>
    <message>
        <source>“%1” refers to an item that was deleted from the project. Select a different item.</source>
        <translation>« %1 » désigne un élément supprimé du projet. Sélectionnez un autre élément.</translation>
    </message>
    <message>
        <source>“%1” must come directly after “%2”.</source>
        <translation>« %1 » doit suivre directement « %2 ».</translation>
    </message>
    <message>
        <source>“%1” must be inside “%2”.</source>
        <translation>« %1 » doit être dans « %2 ».</translation>
    </message>
    <message>
        <source>Steps in “Watch in parallel” cannot move the arm. Move this step out of the section.</source>
        <translation>Les étapes en parallèle ne peuvent pas déplacer le bras. Sortez cette étape de la section.</translation>
    </message>
    <message>
        <source>This version of Tiller does not support the step “%1”. Update Tiller, or delete the step.</source>
        <translation>Cette version de Tiller ne prend pas en charge l’étape « %1 ». Mettez Tiller à jour ou supprimez l’étape.</translation>
    </message>
    <message>
        <source>A program can start only at a top-level step, and not at a branch such as Else. Select a different step.</source>
        <translation>Un programme ne peut commencer qu’à une étape de niveau supérieur, et pas à une branche comme Sinon. Sélectionnez une autre étape.</translation>
    </message>
    <message>
        <source>The project does not contain this program. Select a different program.</source>
        <translation>Le projet ne contient pas ce programme. Sélectionnez un autre programme.</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a %2. Use “Adapt project to this robot…” first.</source>
        <translation>Le projet a été appris avec un %1, mais le robot est un %2. Utilisez d’abord « Adapter le projet à ce robot… ».</translation>
    </message>
    <message>
        <source>A program with parameters cannot be started directly. Use a “Call program” step in another program.</source>
        <translation>Un programme avec paramètres ne peut pas être lancé directement. Appelez-le avec une étape d’un autre programme.</translation>
    </message>
    <message>
        <source>The program has no steps. Add steps first.</source>
        <translation>Le programme n’a pas d’étapes. Ajoutez d’abord des étapes.</translation>
    </message>
    <message>
        <source>The variable “%1” has a different type elsewhere in the program. Use the same type or a different name.</source>
        <translation>La variable « %1 » a un autre type ailleurs dans le programme. Utilisez le même type ou un autre nom.</translation>
    </message>
    <message>
        <source>Program calls are nested too deeply. Use fewer levels of calls.</source>
        <translation>Les appels de programmes sont trop imbriqués. Utilisez moins de niveaux.</translation>
    </message>
    <message>
        <source>“%1” was taught with a different TCP than the waypoints before it. Set the active TCP, or put the step in a TCP section.</source>
        <translation>« %1 » a été appris avec un TCP différent de celui des points précédents. Définissez le TCP actif ou placez l’étape dans une section TCP.</translation>
    </message>
    <message>
        <source>The blend radii of this move and the previous move (%1 and %2) exceed the distance of %3 between the two targets. Reduce a blend radius.</source>
        <translation>Les rayons de raccordement de ce mouvement et du précédent (%1 et %2) dépassent la distance de %3 entre les deux cibles. Réduisez un rayon.</translation>
    </message>
    <message>
        <source>The expression is empty. Enter an expression.</source>
        <translation>L’expression est vide. Saisissez une expression.</translation>
    </message>
    <message>
        <source>An expression must be a single line.</source>
        <translation>Une expression doit tenir sur une seule ligne.</translation>
    </message>
    <message>
        <source>“%1” is not a valid variable name. Use letters, digits and underscores, and do not start with a digit.</source>
        <translation>« %1 » n’est pas un nom de variable valide. Utilisez des lettres, des chiffres et des tirets bas, sans chiffre au début.</translation>
    </message>
    <message>
        <source>The name “%1” is reserved. Use a different name.</source>
        <translation>Le nom « %1 » est réservé. Utilisez un autre nom.</translation>
    </message>
    <message>
        <source>The arm comes too close to itself.</source>
        <translation>Le bras s’approche trop de lui-même.</translation>
    </message>
    <message>
        <source>The arm comes too close to “%1”.</source>
        <translation>Le bras s’approche trop de « %1 ».</translation>
    </message>
    <message>
        <source>The arm comes too close to the floor.</source>
        <translation>Le bras s’approche trop du sol.</translation>
    </message>
    <message>
        <source>The step failed and ended the program.</source>
        <translation>L’étape a échoué et a terminé le programme.</translation>
    </message>
    <message>
        <source>The program did not end within %1 s.</source>
        <translation>Le programme ne s’est pas terminé en %1 s.</translation>
    </message>
    <message>
        <source>The preview was cancelled.</source>
        <translation>L’aperçu a été annulé.</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Mouvements</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Entrées et sorties</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Attente</translation>
    </message>
    <message>
        <source>Tool and speed</source>
        <translation>Outil et vitesse</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Déroulement</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Set variable</source>
        <translation>Définir une variable</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>Nombre entier</translation>
    </message>
    <message>
        <source>True or false</source>
        <translation>Vrai ou faux</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Call program</source>
        <translation>Appeler un programme</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Parameter values</source>
        <translation>Valeurs des param.</translation>
    </message>
    <message>
        <source>The program “%1” requires %2 comma-separated values, but the step passes %3.</source>
        <translation>Le programme « %1 » exige %2 valeurs séparées par des virgules, mais l’étape en transmet %3.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Cas</translation>
    </message>
    <message>
        <source>“Default” must be the last branch of a Switch.</source>
        <translation>Par défaut doit être la dernière partie d’un choix.</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Par défaut</translation>
    </message>
    <message>
        <source>Else if</source>
        <translation>Sinon si</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condition</translation>
    </message>
    <message>
        <source>Else</source>
        <translation>Sinon</translation>
    </message>
    <message>
        <source>End program</source>
        <translation>Terminer le programme</translation>
    </message>
    <message>
        <source>The program failed.</source>
        <translation>Le programme a échoué.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>For each pattern cell</source>
        <translation>Pour chaque emplacement du motif</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>For each waypoint</source>
        <translation>Pour chaque point de passage</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Force section</source>
        <translation>Section de force</translation>
    </message>
    <message>
        <source>Reference frame</source>
        <translation>Repère de réf.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Section frame</source>
        <translation>Repère de la section</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Limite de vitesse</translation>
    </message>
    <message>
        <source>Frame section</source>
        <translation>Section de repère</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Pince</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation>Sortie de fermeture</translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation>Sortie d’ouverture</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Input to check</source>
        <translation>Vérifier l’entrée</translation>
    </message>
    <message>
        <source>If the input is off</source>
        <translation>Si l’entrée est désactivée</translation>
    </message>
    <message>
        <source>Select different outputs for opening and closing.</source>
        <translation>Choisissez des sorties différentes pour l’ouverture et la fermeture.</translation>
    </message>
    <message>
        <source>The gripper is not holding an object.</source>
        <translation>La pince ne tient pas d’objet.</translation>
    </message>
    <message>
        <source>If</source>
        <translation>Si</translation>
    </message>
    <message>
        <source>Exit loop</source>
        <translation>Quitter la boucle</translation>
    </message>
    <message>
        <source>“Exit loop” must be inside a loop.</source>
        <translation>L’étape de sortie de boucle doit se trouver dans une boucle.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Repetitions (0: endless)</source>
        <translation>Répétitions (0 : sans fin)</translation>
    </message>
    <message>
        <source>Counter</source>
        <translation>Compteur</translation>
    </message>
    <message>
        <source>This loop may never end and contains no delay. Add a Wait step.</source>
        <translation>Cette boucle peut ne jamais finir et ne contient aucune attente. Ajoutez une étape Attendre.</translation>
    </message>
    <message>
        <source>A loop can have 1 to %1 positions; this loop has %2.</source>
        <translation>Une boucle peut avoir de 1 à %1 positions ; celle-ci en a %2.</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Wait for the operator</source>
        <translation>Attendre l’opérateur</translation>
    </message>
    <message>
        <source>MoveC</source>
        <translation>MoveC</translation>
    </message>
    <message>
        <source>Via</source>
        <translation>Par</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Vers</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Raccordement</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientation</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Fixed to arc</source>
        <translation>Fixe par rapport à l’arc</translation>
    </message>
    <message>
        <source>Move through a group</source>
        <translation>Parcourir un groupe</translation>
    </message>
    <message>
        <source>Run waypoint actions</source>
        <translation>Exécuter les actions des points</translation>
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
        <translation>Mouvement relatif</translation>
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
        <translation>La distance est nulle. Saisissez une valeur pour X, Y ou Z.</translation>
    </message>
    <message>
        <source>The waypoint “%1” moves the gripper. In a program, use the Gripper step and turn off “Run waypoint actions”.</source>
        <translation>Le point « %1 » déplace la pince. Dans un programme, utilisez l’étape Pince et désactivez « Exécuter les actions des points ».</translation>
    </message>
    <message>
        <source>Waypoint</source>
        <translation>Point de passage</translation>
    </message>
    <message>
        <source>Approach distance</source>
        <translation>Distance d’approche</translation>
    </message>
    <message>
        <source>The arm cannot reach “%1”. Change the waypoint, or select a different waypoint.</source>
        <translation>Le bras ne peut pas atteindre « %1 ». Modifiez le point de passage ou sélectionnez-en un autre.</translation>
    </message>
    <message>
        <source>Set either a waypoint or a pose, not both.</source>
        <translation>Définissez un point de passage ou une pose, pas les deux.</translation>
    </message>
    <message>
        <source>Set a waypoint or a pose.</source>
        <translation>Définissez un point de passage ou une pose.</translation>
    </message>
    <message>
        <source>Move until</source>
        <translation>Déplacer jusqu’à</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Jusqu’à</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>Input is on</source>
        <translation>Entrée activée</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>If not reached</source>
        <translation>Si non atteint</translation>
    </message>
    <message>
        <source>Select an input.</source>
        <translation>Sélectionnez une entrée.</translation>
    </message>
    <message>
        <source>The input did not turn on within the maximum distance. Check the sensor and its wiring.</source>
        <translation>L’entrée ne s’est pas activée dans la distance maximale. Vérifiez le capteur et son câblage.</translation>
    </message>
    <message>
        <source>No contact was detected within the maximum distance.</source>
        <translation>Aucun contact n’a été détecté dans la distance maximale.</translation>
    </message>
    <message>
        <source>Write to the log</source>
        <translation>Écrire dans le journal</translation>
    </message>
    <message>
        <source>On error</source>
        <translation>En cas d’erreur</translation>
    </message>
    <message>
        <source>Set payload</source>
        <translation>Régler la charge utile</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Charge utile</translation>
    </message>
    <message>
        <source>Pulse output</source>
        <translation>Impulsion sur sortie</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Sortie</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Activée</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Question</translation>
    </message>
    <message>
        <source>Questions require robot software 5.6 or newer.</source>
        <translation>Les questions nécessitent le logiciel de robot 5.6 ou plus récent.</translation>
    </message>
    <message>
        <source>URScript</source>
        <translation>URScript</translation>
    </message>
    <message>
        <source>Names that begin with “tiller_” are reserved.</source>
        <translation>Les noms qui commencent par « tiller_ » sont réservés.</translation>
    </message>
    <message>
        <source>Each block in the script needs an “end”.</source>
        <translation>Chaque bloc du script doit avoir son propre « end ».</translation>
    </message>
    <message>
        <source>Set analog output</source>
        <translation>Régler une sortie analogique</translation>
    </message>
    <message>
        <source>Set output</source>
        <translation>Régler une sortie</translation>
    </message>
    <message>
        <source>Set register</source>
        <translation>Régler un registre</translation>
    </message>
    <message>
        <source>Integer</source>
        <translation>Entier</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Réel</translation>
    </message>
    <message>
        <source>Boolean</source>
        <translation>Booléen</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registre</translation>
    </message>
    <message>
        <source>Programs can set registers only up to %1.</source>
        <translation>Les programmes peuvent régler les registres jusqu’à %1.</translation>
    </message>
    <message>
        <source>Speed section</source>
        <translation>Section de vitesse</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Choix</translation>
    </message>
    <message>
        <source>A Switch must contain at least one Case.</source>
        <translation>Un choix doit contenir au moins un cas.</translation>
    </message>
    <message>
        <source>Only Case and Default can be placed directly in a Switch.</source>
        <translation>Un choix ne contient directement que Cas et Par défaut.</translation>
    </message>
    <message>
        <source>TCP section</source>
        <translation>Section TCP</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Essayer</translation>
    </message>
    <message>
        <source>“Try” must be followed directly by “On error”.</source>
        <translation>« Essayer » doit être suivi directement de « En cas d’erreur ».</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Attendre</translation>
    </message>
    <message>
        <source>Wait for condition</source>
        <translation>Attendre une condition</translation>
    </message>
    <message>
        <source>On timeout</source>
        <translation>En cas de dépassement</translation>
    </message>
    <message>
        <source>The condition did not become true before the timeout.</source>
        <translation>La condition n’est pas devenue vraie à temps.</translation>
    </message>
    <message>
        <source>Wait for input</source>
        <translation>Attendre une entrée</translation>
    </message>
    <message>
        <source>%1 did not change to the expected state before the timeout.</source>
        <translation>%1 n’est pas passé à l’état attendu avant l’expiration du délai.</translation>
    </message>
    <message>
        <source>Watch in parallel</source>
        <translation>Surveiller en parallèle</translation>
    </message>
    <message>
        <source>A parallel watch must be at the top level of the program.</source>
        <translation>Une surveillance parallèle doit être au niveau supérieur du programme.</translation>
    </message>
    <message>
        <source>While</source>
        <translation>Tant que</translation>
    </message>
    <message>
        <source>At %1 s: %2</source>
        <translation>À %1 s : %2</translation>
    </message>
    <message>
        <source>Step %1 (%2) at %3 s: %4</source>
        <translation>Étape %1 (%2) à %3 s : %4</translation>
    </message>
    <message>
        <source>“%1” must be between %2 and %3.</source>
        <translation>« %1 » doit être compris entre %2 et %3.</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>Étape %1 : %2</translation>
    </message>
    <message>
        <source>The TCP of the robot differs from the TCP of the program&apos;s waypoints. Set the active TCP of the project, or use a TCP section.</source>
        <translation>Le TCP du robot diffère du TCP des points du programme. Définissez le TCP actif du projet ou utilisez une section TCP.</translation>
    </message>
    <message>
        <source>Preview the program first.</source>
        <translation>Affichez d&apos;abord l&apos;aperçu du programme.</translation>
    </message>
    <message>
        <source>The preview found problems. Fix them, then preview the program again.</source>
        <translation>L’aperçu a trouvé des problèmes. Corrigez-les, puis relancez l’aperçu.</translation>
    </message>
    <message>
        <source>Move the arm to the start position first.</source>
        <translation>Déplacez d&apos;abord le bras à la position de départ.</translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation>Un programme est en cours d’exécution. Arrêtez d’abord le programme.</translation>
    </message>
    <message>
        <source>The program ended after %1 s.</source>
        <translation>Le programme s&apos;est terminé après %1 s.</translation>
    </message>
    <message>
        <source>Step %1 (%2) failed and ended the program.</source>
        <translation>L&apos;étape %1 (%2) a échoué et a terminé le programme.</translation>
    </message>
    <message>
        <source>Stopped in step %1 (%2): %3</source>
        <translation>Arrêt à l&apos;étape %1 (%2) : %3</translation>
    </message>
    <message>
        <source>Stopped before the first step: %1</source>
        <translation>Arrêt avant la première étape : %1</translation>
    </message>
    <message>
        <source>Later steps use the variable “%1” from step %2 (%3). Start at that step or earlier.</source>
        <translation>Des étapes suivantes utilisent la variable « %1 » de l&apos;étape %2 (%3). Commencez à cette étape ou avant.</translation>
    </message>
    <message>
        <source>Later steps depend on step %1 (%2). Start at that step or earlier.</source>
        <translation>Des étapes suivantes dépendent de l&apos;étape %1 (%2). Commencez à cette étape ou avant.</translation>
    </message>
    <message>
        <source>The preview does not reach this step. Select a different step.</source>
        <translation>L’aperçu n’atteint pas cette étape. Sélectionnez une autre étape.</translation>
    </message>
    <message>
        <source>The simulated program does not complete step %1 (%2).</source>
        <translation>Le programme simulé ne termine pas l&apos;étape %1 (%2).</translation>
    </message>
    <message>
        <source>The arm has left the start position of step %1 (%2).</source>
        <translation>Le bras a quitté la position de départ de l&apos;étape %1 (%2).</translation>
    </message>
    <message>
        <source>The gripper may hold a part and would close again (%1).</source>
        <translation>Le préhenseur tient peut-être une pièce et se refermerait (%1).</translation>
    </message>
    <message>
        <source>The gripper may have lost a part (%1).</source>
        <translation>Le préhenseur a peut-être perdu une pièce (%1).</translation>
    </message>
    <message>
        <source>%1 would turn on again.</source>
        <translation>%1 s&apos;activerait à nouveau.</translation>
    </message>
    <message>
        <source>%1 would have a different value.</source>
        <translation>%1 aurait une autre valeur.</translation>
    </message>
    <message>
        <source>The program would wait in step %1 (%2).</source>
        <translation>Le programme attendrait à l&apos;étape %1 (%2).</translation>
    </message>
    <message>
        <source>The program would fail in step %1 (%2).</source>
        <translation>Le programme échouerait à l&apos;étape %1 (%2).</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>La vérification a été annulée.</translation>
    </message>
    <message>
        <source>An analog output would have a different value.</source>
        <translation>Une sortie analogique aurait une autre valeur.</translation>
    </message>
    <message>
        <source>A register would have a different value.</source>
        <translation>Un registre aurait une autre valeur.</translation>
    </message>
    <message>
        <source>The variable “%1” would have a different value.</source>
        <translation>La variable « %1 » aurait une autre valeur.</translation>
    </message>
    <message>
        <source>The TCP or the payload would differ.</source>
        <translation>Le TCP ou la charge utile seraient différents.</translation>
    </message>
    <message>
        <source>The program would run different steps.</source>
        <translation>Le programme exécuterait d&apos;autres étapes.</translation>
    </message>
    <message>
        <source>The arm would end at a different position.</source>
        <translation>Le bras terminerait à une autre position.</translation>
    </message>
    <message>
        <source>✔ Continue</source>
        <translation>✔ Continuer</translation>
    </message>
    <message>
        <source>↩ Move back</source>
        <translation>↩ Reculer</translation>
    </message>
    <message>
        <source>✖ Unsafe</source>
        <translation>✖ Non sûr</translation>
    </message>
    <message>
        <source>Simulated, after a stop in this step:</source>
        <translation>Simulé, après un arrêt à cette étape :</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>non atteint</translation>
    </message>
    <message>
        <source>can continue</source>
        <translation>peut continuer</translation>
    </message>
    <message>
        <source>can continue after moving back</source>
        <translation>peut continuer après retour en arrière</translation>
    </message>
    <message>
        <source>cannot continue safely</source>
        <translation>ne peut pas continuer en sécurité</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>Arrêt de protection</translation>
    </message>
    <message>
        <source>Stop by the operator</source>
        <translation>Arrêt par l&apos;opérateur</translation>
    </message>
    <message>
        <source>Connection loss</source>
        <translation>Perte de connexion</translation>
    </message>
    <message>
        <source>Power loss</source>
        <translation>Coupure d&apos;alimentation</translation>
    </message>
    <message>
        <source>Simulated: the program cannot continue safely. %1</source>
        <translation>Simulé : le programme ne peut pas continuer en sécurité. %1</translation>
    </message>
    <message>
        <source>Simulated: the program can continue from step %1 (%2).</source>
        <translation>Simulé : le programme peut continuer à partir de l&apos;étape %1 (%2).</translation>
    </message>
    <message>
        <source>The stop was inside a force section, so the contact cannot be restored.</source>
        <translation>L’arrêt s’est produit dans une section de force ; le contact ne peut donc pas être rétabli.</translation>
    </message>
    <message>
        <source>The relative move is only partly complete.</source>
        <translation>Le mouvement relatif est exécuté en partie.</translation>
    </message>
    <message>
        <source>The URScript text was only partly executed.</source>
        <translation>Le texte URScript est exécuté en partie.</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>Délai maximal</translation>
    </message>
    <message>
        <source>A program cannot continue inside a section or a called program. The next run starts from the beginning.</source>
        <translation>Un programme ne peut pas reprendre dans une section ou dans un programme appelé. La prochaine exécution part du début.</translation>
    </message>
    <message>
        <source>A program cannot continue in the middle of this step. The next run starts from the beginning.</source>
        <translation>Un programme ne peut pas reprendre au milieu de cette étape. La prochaine exécution part du début.</translation>
    </message>
    <message>
        <source>paused on the robot</source>
        <translation>mis en pause sur le robot</translation>
    </message>
    <message>
        <source>the speed, acceleration or blend is not a number, or a time is set</source>
        <translation>la vitesse, l’accélération ou le raccordement n’est pas un nombre, ou une durée est indiquée</translation>
    </message>
    <message>
        <source>not imported</source>
        <translation>non importé</translation>
    </message>
    <message>
        <source>%1, disabled</source>
        <translation>%1, désactivée</translation>
    </message>
    <message>
        <source>the program has no name</source>
        <translation>le programme n’a pas de nom</translation>
    </message>
    <message>
        <source>the project already has a program &apos;%1&apos;; choose another name</source>
        <translation>le projet contient déjà un programme « %1 » ; choisissez un autre nom</translation>
    </message>
    <message>
        <source>the file is too large for a program</source>
        <translation>le fichier est trop grand pour un programme</translation>
    </message>
    <message>
        <source>the file is not text in UTF-8</source>
        <translation>le fichier n’est pas du texte en UTF-8</translation>
    </message>
    <message>
        <source>this line ends a block that was not opened</source>
        <translation>cette ligne ferme un bloc qui n’a pas été ouvert</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1 : %2</translation>
    </message>
    <message>
        <source>the program contains a return</source>
        <translation>le programme contient un « return »</translation>
    </message>
    <message>
        <source>the program has too many statements</source>
        <translation>le programme a trop d’instructions</translation>
    </message>
    <message>
        <source>the script of the steps does not compile</source>
        <translation>le script des étapes ne se compile pas</translation>
    </message>
    <message>
        <source>the program is too complex</source>
        <translation>le programme est trop complexe</translation>
    </message>
    <message>
        <source>the file contains no statements</source>
        <translation>le fichier ne contient aucune instruction</translation>
    </message>
    <message>
        <source>the file contains %1 functions or parameters, but no statement that calls a function; add the call</source>
        <translation>le fichier contient %1 fonctions ou paramètres, mais aucune instruction n’appelle une fonction ; ajoutez l’appel</translation>
    </message>
    <message>
        <source>the program contains no statements</source>
        <translation>le programme ne contient aucune instruction</translation>
    </message>
    <message>
        <source>Installation</source>
        <translation>Installation</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>In this project, programs begin with the TCP of the tool &apos;%1&apos;.</source>
        <translation>Dans ce projet, les programmes commencent avec le TCP de l’outil « %1 ».</translation>
    </message>
    <message>
        <source>The program does not set the TCP. Its waypoints require the TCP %1.</source>
        <translation>Le programme ne définit pas le TCP. Ses points de passage exigent le TCP %1.</translation>
    </message>
    <message>
        <source>the TCP applies until the end of the program</source>
        <translation>le TCP s’applique jusqu’à la fin du programme</translation>
    </message>
    <message>
        <source>the program does not call this function</source>
        <translation>le programme n’appelle pas cette fonction</translation>
    </message>
    <message>
        <source>imported as a program</source>
        <translation>importé comme programme</translation>
    </message>
    <message>
        <source>part of a waypoint</source>
        <translation>partie d’un point de passage</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but the robot is a different model. Adapt the project to the robot first.</source>
        <translation>Le projet a été appris avec un %1, mais le robot est d’un autre modèle. Adaptez d’abord le projet au robot.</translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>Simulé : %1</translation>
    </message>
    <message>
        <source>Step %1 failed and ended the program.</source>
        <translation>L’étape %1 a échoué et a mis fin au programme.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>step numbers</comment>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>étape %1</translation>
    </message>
    <message>
        <source>steps %1</source>
        <translation>étapes %1</translation>
    </message>
    <message>
        <source>The position of the arm is unknown because no robot data arrive. Check the connection to the robot.</source>
        <translation>La position du bras est inconnue, car aucune donnée du robot n&apos;arrive. Vérifiez la connexion au robot.</translation>
    </message>
    <message>
        <source>It is unknown whether the program completed, because robot data were missing at its end. Check the workpiece.</source>
        <translation>On ignore si le programme s&apos;est exécuté jusqu&apos;au bout, car des données du robot manquaient à la fin. Vérifiez la pièce.</translation>
    </message>
    <message>
        <source>Last known step: %1 (%2). %3</source>
        <translation>Dernière étape connue : %1 (%2). %3</translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation>Aucun programme en cours.</translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation>Le programme est en pause sur le robot. Reprenez-le sur le pupitre.</translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation>Mettez d&apos;abord le programme en pause.</translation>
    </message>
    <message>
        <source>Wait until the robot has confirmed the new value of “%1”.</source>
        <translation>Attendez que le robot ait confirmé la nouvelle valeur de « %1 ».</translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation>« %1 » n&apos;est pas un nombre. Saisissez un nombre.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number. Enter a number without decimals.</source>
        <translation>« %1 » n&apos;est pas un nombre entier. Saisissez un nombre sans décimales.</translation>
    </message>
    <message>
        <source>“%1” is not True or False. Enter one of these values.</source>
        <translation>« %1 » n&apos;est ni True ni False. Saisissez l&apos;une de ces valeurs.</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrice</translation>
    </message>
    <message>
        <source>A URScript step in this program could move the arm after a change.</source>
        <translation>Une étape URScript de ce programme pourrait déplacer le bras après une modification.</translation>
    </message>
    <message>
        <source>Only numbers and True or False values can be changed.</source>
        <translation>Seuls les nombres et les valeurs True ou False peuvent être modifiés.</translation>
    </message>
    <message>
        <source>The program has no variable “%1”.</source>
        <translation>Le programme n&apos;a pas de variable « %1 ».</translation>
    </message>
    <message>
        <source>Variable “%1”: %2 → %3</source>
        <translation>Variable « %1 » : %2 → %3</translation>
    </message>
    <message>
        <source>The robot did not confirm the new value of “%1”. Check the value in the list.</source>
        <translation>Le robot n&apos;a pas confirmé la nouvelle valeur de « %1 ». Vérifiez la valeur dans la liste.</translation>
    </message>
    <message>
        <source>The robot does not report its variables. Wait until the connection is restored.</source>
        <translation>Le robot ne communique pas ses variables. Attendez que la connexion soit rétablie.</translation>
    </message>
    <message>
        <source>The recoverability check did not reach step %1 (%2). Check again with the inputs of the run to find out whether the program can continue.</source>
        <translation>La vérification de la reprise n’a pas atteint l’étape %1 (%2). Vérifiez à nouveau avec les entrées de l’exécution si le programme peut reprendre.</translation>
    </message>
    <message>
        <source>This variable is set by URScript text. Only variables of a “Set variable” step can be changed.</source>
        <translation>Cette variable est définie par du texte URScript. Seules les variables d’une étape « Définir une variable » peuvent être modifiées.</translation>
    </message>
    <message>
        <source>“%1” is not set. Select or enter a value.</source>
        <translation>« %1 » n’est pas défini. Sélectionnez ou saisissez une valeur.</translation>
    </message>
    <message>
        <source>“%1” has an invalid value. Enter a different value.</source>
        <translation>« %1 » a une valeur non valide. Saisissez une autre valeur.</translation>
    </message>
    <message>
        <source>“%1” cannot contain steps. Move its steps to another section.</source>
        <translation>« %1 » ne peut pas contenir d’étapes. Déplacez les étapes dans une autre section.</translation>
    </message>
    <message>
        <source>A program cannot call itself. Select a different program.</source>
        <translation>Un programme ne peut pas s’appeler lui-même. Sélectionnez un autre programme.</translation>
    </message>
    <message>
        <source>Unexpected character “%1”. Remove this character.</source>
        <translation>Caractère inattendu « %1 ». Supprimez ce caractère.</translation>
    </message>
    <message>
        <source>“%1” cannot be part of an expression. Remove this word.</source>
        <translation>« %1 » ne peut pas faire partie d’une expression. Supprimez ce mot.</translation>
    </message>
    <message>
        <source>The brackets do not match. Add or remove a bracket.</source>
        <translation>Les parenthèses ne correspondent pas. Ajoutez ou supprimez une parenthèse.</translation>
    </message>
    <message>
        <source>a Message step cannot have this title</source>
        <translation>une étape « Message » ne peut pas avoir ce titre</translation>
    </message>
    <message>
        <source>the payload is not given as numbers in the permitted range</source>
        <translation>la charge utile n’est pas donnée par des nombres dans la plage autorisée</translation>
    </message>
    <message>
        <source>the target cannot be stored as a waypoint or as the pose of a step</source>
        <translation>la cible ne peut être ni un point de passage ni une pose d’une étape</translation>
    </message>
    <message>
        <source>the External Control node runs a script from another computer, which cannot be imported. Remove this node from the program.</source>
        <translation>le nœud External Control exécute un script d’un autre ordinateur, qui ne peut pas être importé. Supprimez ce nœud du programme.</translation>
    </message>
    <message>
        <source>the blocks are nested too deeply</source>
        <translation>les blocs sont imbriqués trop profondément</translation>
    </message>
    <message>
        <source>a block extends beyond its node</source>
        <translation>un bloc se poursuit au-delà de son nœud</translation>
    </message>
    <message>
        <source>the line contains several statements</source>
        <translation>plusieurs instructions sont sur la même ligne</translation>
    </message>
    <message>
        <source>the block that begins on line %1 has no end</source>
        <translation>le bloc qui commence à la ligne %1 n’a pas de fin</translation>
    </message>
    <message>
        <source>no step corresponds to this statement</source>
        <translation>aucune étape ne produit cette instruction</translation>
    </message>
    <message>
        <source>The program uses output integer register 46 or 47, to which Tiller writes the number of the running step. Use different registers.</source>
        <translation>Le programme utilise le registre de sortie entier 46 ou 47, dans lequel Tiller écrit le numéro de l’étape en cours. Utilisez d’autres registres.</translation>
    </message>
    <message>
        <source>a disabled node in a section that is imported as URScript text</source>
        <translation>un nœud désactivé dans une partie conservée comme texte</translation>
    </message>
    <message>
        <source>the condition cannot be used in a step</source>
        <translation>sa condition ne peut pas être celle d’une étape</translation>
    </message>
    <message>
        <source>no step corresponds to a thread, or to a function with parameters or a result</source>
        <translation>aucune étape ne correspond aux fonctions avec paramètres ou résultat, ni aux threads</translation>
    </message>
    <message>
        <source>the type or the scope of the variable cannot be determined</source>
        <translation>le type ou la portée de la variable n’est pas certain</translation>
    </message>
    <message>
        <source>%1. Save the program on the teach pendant and copy its .script file to the same folder, or change the program.</source>
        <translation>%1. Enregistrez le programme sur le pupitre et copiez son fichier .script dans le même dossier, ou modifiez le programme.</translation>
    </message>
    <message>
        <source>The nodes cannot be imported: %1. The script saved by the teach pendant was imported instead.</source>
        <translation>Les nœuds ne peuvent pas être traduits : %1. Le script enregistré par le pupitre a été importé à la place.</translation>
    </message>
    <message>
        <source>%1. Complete the program on the teach pendant first.</source>
        <translation>%1. Complétez d’abord le programme sur le pupitre.</translation>
    </message>
    <message>
        <source>ended on the robot (teach pendant, another client or halt)</source>
        <translation>terminé sur le robot (pupitre, autre client ou halt)</translation>
    </message>
    <message>
        <source>a program from another client has taken over</source>
        <translation>un programme d’un autre client a pris le robot</translation>
    </message>
    <message>
        <source>The values of a program from another client cannot be changed.</source>
        <translation>Les valeurs d&apos;un programme d&apos;un autre client ne peuvent pas être modifiées.</translation>
    </message>
    <message>
        <source>the statement is nested too deeply</source>
        <translation>elle est imbriquée trop profondément</translation>
    </message>
    <message>
        <source>The program cannot pause before this step. Select a different step.</source>
        <translation>Le programme ne peut pas faire de pause avant cette étape. Sélectionnez une autre étape.</translation>
    </message>
    <message>
        <source>The move is only partly complete.</source>
        <translation>Le mouvement n’est exécuté qu’en partie.</translation>
    </message>
</context>
<context>
    <name>ProjectLock</name>
    <message>
        <source>%1 on %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>process %1</source>
        <translation>processus %1</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>un autre programme</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>No robot connected. Choose a robot at the top left.</source>
        <translation>Aucun robot connecté. Choisissez-en un en haut à gauche.</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Connexion…</translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically.</source>
        <translation>Aucune donnée du robot. Reconnexion automatique.</translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation>Les données du robot sont en retard. En attente de nouvelles données.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Prise de contrôle…</translation>
    </message>
    <message>
        <source>Not in control. Press “Take control” in the header.</source>
        <translation>Non contrôlé. Appuyez sur « Prendre le contrôle » dans l’en-tête.</translation>
    </message>
    <message>
        <source>Robot data are out of date. Wait for new data.</source>
        <translation>Les données du robot ne sont pas à jour. Attendez de nouvelles données.</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>Aucun robot connecté. Connectez-en un, ou essayez le simulateur.</translation>
    </message>
    <message>
        <source>The arm is moving. Stop the arm first, then store the position.</source>
        <translation>Le bras est en mouvement. Arrêtez d’abord le bras, puis enregistrez la position.</translation>
    </message>
</context>
<context>
    <name>RecordingChoice</name>
    <message>
        <source>A file name must not be empty or begin with a period.</source>
        <translation>Un nom de fichier ne doit pas être vide ni commencer par un point.</translation>
    </message>
    <message>
        <source>A file name cannot contain “%1”.</source>
        <translation>Un nom de fichier ne peut contenir « %1 ».</translation>
    </message>
    <message>
        <source>This name is too long.</source>
        <translation>Ce nom est trop long.</translation>
    </message>
    <message>
        <source>Not a condition: “%1”. Examples: actual_TCP_force_2 &gt; 20, robot_mode = 7, actual_digital_input_bits:3 = 1, runtime_state changes.</source>
        <translation>Ce n’est pas une condition : « %1 ». Exemples : actual_TCP_force_2 &gt; 20, robot_mode = 7, actual_digital_input_bits:3 = 1, runtime_state changes.</translation>
    </message>
    <message>
        <source>There is no signal “%1”. Vectors have one signal per number, such as actual_q_0.</source>
        <translation>Le signal « %1 » n’existe pas. Les vecteurs ont un signal par nombre, par exemple actual_q_0.</translation>
    </message>
</context>
<context>
    <name>RecoveryGuide</name>
    <message>
        <source>Safety mode is Normal again</source>
        <translation>Le mode de sécurité est de nouveau « Normal »</translation>
    </message>
    <message>
        <source>The arm can be moved. Motions interrupted by the stop do not resume. Press the button again for each motion.</source>
        <translation>Le bras peut être déplacé. Les mouvements interrompus par l’arrêt ne reprennent pas : chaque mouvement exige un nouvel appui.</translation>
    </message>
    <message>
        <source>The arm is ready. Take control to move the arm, or continue on the teach pendant.</source>
        <translation>Le bras est prêt. Prenez le contrôle pour le bouger, ou continuez sur le pupitre.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Prise de contrôle…</translation>
    </message>
    <message>
        <source>No data from the robot</source>
        <translation>Pas de données du robot</translation>
    </message>
    <message>
        <source>Waiting for the connection…</source>
        <translation>En attente de la connexion…</translation>
    </message>
    <message>
        <source>I have inspected the arm. No one is touching it, and nothing is trapped.</source>
        <translation>J’ai inspecté le bras. Personne ne le touche et rien n’est coincé.</translation>
    </message>
    <message>
        <source>The cause of the stop is known and has been removed.</source>
        <translation>La cause de l’arrêt est connue et a été éliminée.</translation>
    </message>
    <message>
        <source>Payload and TCP match the mounted tool.</source>
        <translation>La charge utile et le TCP correspondent à l’outil monté.</translation>
    </message>
    <message>
        <source>Unlocking is available in %1 s</source>
        <translation>Déverrouillage possible dans %1 s</translation>
    </message>
    <message>
        <source>I have inspected the arm and the robot&apos;s log, and I know the cause.</source>
        <translation>J’ai inspecté le bras et le journal du robot, et je connais la cause.</translation>
    </message>
    <message>
        <source>The cause has been removed, and no one is within reach of the arm.</source>
        <translation>La cause a été éliminée et personne n’est à portée du bras.</translation>
    </message>
    <message>
        <source>No action is needed in Tiller. This state ends when the cause is removed.</source>
        <translation>Aucune action n’est nécessaire dans Tiller. L’état prend fin quand la cause est éliminée.</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Déverrouiller</translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation>Redémarrer la sécurité</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Mettre sous tension</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>Desserrer les freins</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Prendre le contrôle</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>Replay</name>
    <message>
        <source>REPLAY</source>
        <translation>RELECTURE</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>sans données</translation>
    </message>
    <message>
        <source>history at %1 s</source>
        <translation>historique à %1 s</translation>
    </message>
    <message>
        <source>at %1 s in %2</source>
        <translation>à %1 s dans %2</translation>
    </message>
</context>
<context>
    <name>RetracePath</name>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation>Aucune trajectoire à reparcourir. Déplacez d’abord le bras.</translation>
    </message>
</context>
<context>
    <name>RobotActions</name>
    <message>
        <source>Connect to a robot first.</source>
        <translation>Connectez-vous d’abord à un robot.</translation>
    </message>
    <message>
        <source>Give control back first.</source>
        <translation>Rendez d’abord le contrôle.</translation>
    </message>
    <message>
        <source>No program is running on the robot.</source>
        <translation>Aucun programme ne tourne sur le robot.</translation>
    </message>
    <message>
        <source>A program is already running.</source>
        <translation>Un programme est déjà en cours.</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Connecter…</translation>
    </message>
    <message>
        <source>Select the simulator, a robot or a project.</source>
        <translation>Sélectionnez le simulateur, un robot ou un projet.</translation>
    </message>
    <message>
        <source>Simulated robot</source>
        <translation>Robot simulé</translation>
    </message>
    <message>
        <source>Starts the simulated robot and connects to it.</source>
        <translation>Démarre le robot simulé et s’y connecte.</translation>
    </message>
    <message>
        <source>Check the connection…</source>
        <translation>Vérifier la connexion…</translation>
    </message>
    <message>
        <source>Select a robot first.</source>
        <translation>Choisissez d’abord un robot.</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Déconnecter</translation>
    </message>
    <message>
        <source>Stops Tiller&apos;s motion, then closes the connection.</source>
        <translation>Arrête le mouvement de Tiller, puis ferme la connexion.</translation>
    </message>
    <message>
        <source>No robot is connected.</source>
        <translation>Aucun robot n’est connecté.</translation>
    </message>
    <message>
        <source>Powers on the arm. The brakes stay engaged.</source>
        <translation>Met le bras sous tension. Les freins restent serrés.</translation>
    </message>
    <message>
        <source>The arm is powered on or powering on.</source>
        <translation>Le bras est sous tension ou en cours de mise sous tension.</translation>
    </message>
    <message>
        <source>The arm may sag by a few millimetres. Keep clear.</source>
        <translation>Le bras peut s’affaisser de quelques millimètres. Restez à l’écart.</translation>
    </message>
    <message>
        <source>Stops programs, engages the brakes and powers the arm off.</source>
        <translation>Arrête les programmes, serre les freins et met le bras hors tension.</translation>
    </message>
    <message>
        <source>The arm is powered off.</source>
        <translation>Le bras est éteint.</translation>
    </message>
    <message>
        <source>Recover…</source>
        <translation>Rétablir…</translation>
    </message>
    <message>
        <source>Shows the cause of the stop and the recovery steps.</source>
        <translation>Affiche ce qui a arrêté le bras et les étapes de rétablissement.</translation>
    </message>
    <message>
        <source>The safety system reports no stop.</source>
        <translation>Le système de sécurité ne signale aucun arrêt.</translation>
    </message>
    <message>
        <source>Resets the safety system after a violation or fault. The arm stays powered off.</source>
        <translation>Réinitialise le système de sécurité après une violation ou un défaut. Le bras reste hors tension.</translation>
    </message>
    <message>
        <source>Available only after a safety violation or fault.</source>
        <translation>Disponible seulement après une violation ou un défaut de sécurité.</translation>
    </message>
    <message>
        <source>Closes the popups on the teach pendant.</source>
        <translation>Ferme les messages du pupitre.</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Prendre le contrôle</translation>
    </message>
    <message>
        <source>Already in control.</source>
        <translation>Contrôle déjà pris.</translation>
    </message>
    <message>
        <source>Give control back</source>
        <translation>Rendre le contrôle</translation>
    </message>
    <message>
        <source>Ends the control program on the robot.</source>
        <translation>Termine le programme de commande sur le robot.</translation>
    </message>
    <message>
        <source>Not in control.</source>
        <translation>Non contrôlé.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Software stop of all motion. Not an emergency stop.</source>
        <translation>Arrêt logiciel de tout mouvement. Pas un arrêt d’urgence.</translation>
    </message>
    <message>
        <source>Load program…</source>
        <translation>Charger un programme…</translation>
    </message>
    <message>
        <source>Loads a program on the robot by name.</source>
        <translation>Charge un programme du robot par son nom.</translation>
    </message>
    <message>
        <source>Starts the loaded program or resumes the paused program. The arm may move immediately.</source>
        <translation>Démarre le programme chargé ou reprend un programme en pause : le bras peut bouger aussitôt.</translation>
    </message>
    <message>
        <source>Pauses the running program.</source>
        <translation>Met en pause le programme en cours.</translation>
    </message>
    <message>
        <source>Stops the program on the robot.</source>
        <translation>Arrête le programme du robot.</translation>
    </message>
    <message>
        <source>Starts the control program on the robot. Asks for confirmation before stopping another program.</source>
        <translation>Démarre le programme de commande sur le robot. Demande confirmation avant d’arrêter un autre programme.</translation>
    </message>
    <message>
        <source>Checks the connection between this PC and the robot and suggests fixes.</source>
        <translation>Vérifie la liaison entre ce PC et le robot et propose des remèdes.</translation>
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
        <translation>Sortie %1 : %2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activée</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivée</translation>
    </message>
    <message>
        <source>%1: on</source>
        <translation>%1 : activée</translation>
    </message>
    <message>
        <source>%1: off</source>
        <translation>%1 : désactivée</translation>
    </message>
    <message>
        <source>Analog output %1: %2 %3</source>
        <translation>Sortie analogique %1 : %2 %3</translation>
    </message>
    <message>
        <source>Input int register %1</source>
        <translation>Registre d’entrée entier %1</translation>
    </message>
    <message>
        <source>Speed slider: %1 %</source>
        <translation>Curseur de vitesse : %1 %</translation>
    </message>
    <message>
        <source>%1: on for %2 s</source>
        <translation>%1 : activée %2 s</translation>
    </message>
    <message>
        <source>%1: off for %2 s</source>
        <translation>%1 : désactivée %2 s</translation>
    </message>
    <message>
        <source>The robot times pulses only while Tiller is in control. Take control first, or switch the output on and off manually.</source>
        <translation>Le robot chronomètre les impulsions seulement lorsque Tiller a le contrôle. Prenez d’abord le contrôle, ou activez puis désactivez la sortie manuellement.</translation>
    </message>
    <message>
        <source>The robot did not end the pulse on %1 because the program on the robot was stopped or paused. Tiller switches the output off.</source>
        <translation>Le robot n’a pas terminé l’impulsion de %1 parce que son programme a été arrêté ou mis en pause. Tiller désactive la sortie.</translation>
    </message>
    <message>
        <source>Input float register %1</source>
        <translation>Registre d’entrée réel %1</translation>
    </message>
    <message>
        <source>Input bit register %1</source>
        <translation>Registre d’entrée bit %1</translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation>Curseur de vitesse</translation>
    </message>
    <message>
        <source>The robot cannot time pulses while a program is running. Stop the program first, or switch the output on and off manually.</source>
        <translation>Le robot ne peut pas chronométrer d’impulsions pendant l’exécution d’un programme. Arrêtez d’abord le programme, ou commutez la sortie manuellement.</translation>
    </message>
</context>
<context>
    <name>RobotServices</name>
    <message>
        <source>%1 failed. %2</source>
        <translation>Échec : %1. %2</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Mettre sous tension</translation>
    </message>
    <message>
        <source>Release brakes</source>
        <translation>Desserrer les freins</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>Mettre hors tension</translation>
    </message>
    <message>
        <source>Restart safety</source>
        <translation>Redémarrer la sécurité</translation>
    </message>
    <message>
        <source>Close popups</source>
        <translation>Fermer les messages</translation>
    </message>
    <message>
        <source>Play program</source>
        <translation>Lire le programme</translation>
    </message>
    <message>
        <source>Pause program</source>
        <translation>Mettre le programme en pause</translation>
    </message>
    <message>
        <source>Stop program</source>
        <translation>Arrêter le programme</translation>
    </message>
    <message>
        <source>Protective stop unlocked by the operator</source>
        <translation>Arrêt de protection déverrouillé par l’opérateur</translation>
    </message>
    <message>
        <source>Load program %1</source>
        <translation>Charger le programme %1</translation>
    </message>
    <message>
        <source>The program on the robot was stopped.</source>
        <translation>Le programme sur le robot a été arrêté.</translation>
    </message>
    <message>
        <source>The program on the robot could not be stopped. Stop the program on the teach pendant. %1</source>
        <translation>Le programme du robot n’a pas pu être arrêté : arrêtez-le sur le pupitre. %1</translation>
    </message>
    <message>
        <source>The robot was switched to Local control: the motion was stopped and control was given back. Switch the robot to Remote control on the teach pendant, then take control again.</source>
        <translation>Le robot est passé en commande locale : le mouvement a été arrêté et le contrôle rendu. Repassez-le en commande à distance sur le pupitre, puis reprenez le contrôle.</translation>
    </message>
    <message>
        <source>Unlock protective stop</source>
        <translation>Déverrouiller l’arrêt de protection</translation>
    </message>
    <message>
        <source>The robot sends no data, so a stop may not reach the robot. Press the emergency stop if the arm must stop.</source>
        <translation>Le robot n’envoie pas de données : un arrêt peut ne pas l’atteindre. Appuyez sur l’arrêt d’urgence si le bras doit s’arrêter.</translation>
    </message>
</context>
<context>
    <name>RobotTooling</name>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller n’a pas le contrôle. Prenez d’abord le contrôle.</translation>
    </message>
    <message>
        <source>TCP and payload can be set only at standstill. Wait until the arm has stopped.</source>
        <translation>Le TCP et la charge utile ne se règlent qu’à l’arrêt. Attendez que le bras soit arrêté.</translation>
    </message>
    <message>
        <source>TCP set on the robot: %1</source>
        <translation>TCP réglé sur le robot : %1</translation>
    </message>
    <message>
        <source>Payload set on the robot: %1</source>
        <translation>Charge utile réglée sur le robot : %1</translation>
    </message>
</context>
<context>
    <name>SampleProjects</name>
    <message>
        <source>Pick and place</source>
        <translation>Prendre et poser</translation>
    </message>
    <message>
        <source>Picks a part from a feeder and places it in one of six tray cells. The cells are defined in the frame of the tray and move with it.</source>
        <translation>Prend une pièce dans un distributeur et la place dans l’un des six emplacements d’un plateau. Les emplacements sont définis dans le repère du plateau et se déplacent avec lui.</translation>
    </message>
    <message>
        <source>Gluing along a path</source>
        <translation>Collage le long d’une trajectoire</translation>
    </message>
    <message>
        <source>Applies a bead around a lid with rounded corners in slow, straight moves. Blends keep the nozzle moving through the corners.</source>
        <translation>Dépose un cordon autour d’un couvercle aux coins arrondis par mouvements lents et droits. Les raccordements gardent la buse en mouvement dans les coins.</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>A probe touches a part from above and from four sides. Each touch starts at an approach waypoint with the tool tilted.</source>
        <translation>Un palpeur touche une pièce par le haut et par quatre côtés. Chaque contact part d’un point d’approche, l’outil incliné.</translation>
    </message>
</context>
<context>
    <name>SceneActions</name>
    <message>
        <source>Default view (perspective)</source>
        <translation>Vue par défaut (en perspective)</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Regarder de face</translation>
    </message>
    <message>
        <source>Base X to the right, Z up.</source>
        <translation>X de la base à droite, Z en haut.</translation>
    </message>
    <message>
        <source>Look from the side</source>
        <translation>Regarder de côté</translation>
    </message>
    <message>
        <source>Base Y to the right, Z up.</source>
        <translation>Y de la base à droite, Z en haut.</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>Regarder d’en haut</translation>
    </message>
    <message>
        <source>Base X to the right, Y up.</source>
        <translation>X de la base à droite, Y en haut.</translation>
    </message>
    <message>
        <source>Fit everything in the view</source>
        <translation>Faire tout tenir dans la vue</translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view without changing the viewing direction.</source>
        <translation>Ajuste le bras, la cible et les points de passage à la vue sans changer la direction du regard.</translation>
    </message>
    <message>
        <source>Shows the arm diagonally from the front, slightly from above, and fits everything in the view.</source>
        <translation>Affiche le bras en diagonale depuis l’avant, légèrement d’en haut, et ajuste tout à la vue.</translation>
    </message>
</context>
<context>
    <name>SessionRecording</name>
    <message>
        <source>Cannot record: connect to a robot first.</source>
        <translation>Enregistrement impossible : connectez-vous d’abord à un robot.</translation>
    </message>
    <message>
        <source>Recording to %1</source>
        <translation>Enregistrement dans %1</translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n rows to %1</source>
        <translation>
            <numerusform>%n ligne enregistrée dans %1</numerusform>
            <numerusform>%n lignes enregistrées dans %1</numerusform>
        </translation>
    </message>
    <message>
        <source>The recording continues without notes. %1</source>
        <translation>L&apos;enregistrement continue sans notes. %1</translation>
    </message>
    <message>
        <source>Not recorded, because the robot does not accept a second connection: %1</source>
        <translation>Non enregistrés, car le robot refuse une deuxième connexion pour eux : %1</translation>
    </message>
    <message numerus="yes">
        <source>The recording has gaps: %n packets are missing.</source>
        <translation>
            <numerusform>L’enregistrement a des lacunes : %n paquet manque.</numerusform>
            <numerusform>L’enregistrement a des lacunes : %n paquets manquent.</numerusform>
        </translation>
    </message>
    <message>
        <source>The current recording does not contain %1. Start a new recording to record displayed signals.</source>
        <translation>L’enregistrement en cours ne contient pas %1. Démarrez un nouvel enregistrement pour enregistrer les signaux affichés.</translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. These signals are not recorded: %1</source>
        <translation>Le robot ne peut pas envoyer autant de signaux à la fois. Signaux non enregistrés : %1</translation>
    </message>
    <message>
        <source>Waiting for the trigger %1 to record to %2</source>
        <translation>Attente du déclencheur %1 pour enregistrer dans %2</translation>
    </message>
    <message>
        <source>The trigger has not occurred. No file was written.</source>
        <translation>Le déclencheur ne s’est pas produit. Aucun fichier n’a été écrit.</translation>
    </message>
    <message numerus="yes">
        <source>Recorded %n files; the last one is %1</source>
        <translation>
            <numerusform>%n fichier enregistré ; le dernier est %1</numerusform>
            <numerusform>%n fichiers enregistrés ; le dernier est %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SettingsFile</name>
    <message>
        <source>Invalid value for the setting “%1”.</source>
        <translation>Valeur non valide pour le réglage « %1 ».</translation>
    </message>
    <message>
        <source>The file is too large for a settings file.</source>
        <translation>Le fichier est trop grand pour un fichier de réglages.</translation>
    </message>
    <message>
        <source>The file is damaged at byte %1: %2.</source>
        <translation>Le fichier est endommagé à l’octet %1 : %2.</translation>
    </message>
    <message>
        <source>The file contains no Tiller settings.</source>
        <translation>Le fichier ne contient pas de réglages de Tiller.</translation>
    </message>
    <message>
        <source>The file was written by a newer version of Tiller. Update Tiller to import the file.</source>
        <translation>Le fichier a été écrit par une version plus récente de Tiller. Mettez Tiller à jour pour l’importer.</translation>
    </message>
    <message>
        <source>The file contains no version number.</source>
        <translation>Le fichier ne contient pas de numéro de version.</translation>
    </message>
    <message>
        <source>The list of settings is missing or too long.</source>
        <translation>La liste des réglages manque ou est trop longue.</translation>
    </message>
    <message>
        <source>“%1” is not a valid setting name.</source>
        <translation>« %1 » n’est pas un nom de réglage valide.</translation>
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
        <translation>Articulations</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Entrées et sorties</translation>
    </message>
    <message>
        <source>Modes and states</source>
        <translation>Modes et états</translation>
    </message>
    <message>
        <source>Power and temperature</source>
        <translation>Puissance et température</translation>
    </message>
    <message>
        <source>Speed and program</source>
        <translation>Vitesse et programme</translation>
    </message>
    <message>
        <source>Payload and tool</source>
        <translation>Charge utile et outil</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Autres</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Registres</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Force au TCP</translation>
    </message>
    <message>
        <source>TCP torque</source>
        <translation>Couple au TCP</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>Position du TCP</translation>
    </message>
    <message>
        <source>TCP rotation vector</source>
        <translation>Vecteur de rotation du TCP</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>Vitesse du TCP</translation>
    </message>
    <message>
        <source>TCP angular speed</source>
        <translation>Vitesse de rotation du TCP</translation>
    </message>
    <message>
        <source>TCP acceleration</source>
        <translation>Accélération du TCP</translation>
    </message>
    <message>
        <source>Target TCP position</source>
        <translation>Position cible du TCP</translation>
    </message>
    <message>
        <source>Target TCP rotation vector</source>
        <translation>Vecteur de rotation cible du TCP</translation>
    </message>
    <message>
        <source>Target TCP speed</source>
        <translation>Vitesse cible du TCP</translation>
    </message>
    <message>
        <source>Target TCP angular speed</source>
        <translation>Vitesse de rotation cible du TCP</translation>
    </message>
    <message>
        <source>Raw sensor force</source>
        <translation>Force brute du capteur</translation>
    </message>
    <message>
        <source>Raw sensor torque</source>
        <translation>Couple brut du capteur</translation>
    </message>
    <message>
        <source>TCP force, norm</source>
        <translation>Force au TCP, norme</translation>
    </message>
    <message>
        <source>Tool accelerometer</source>
        <translation>Accéléromètre dans la bride</translation>
    </message>
    <message>
        <source>Elbow position</source>
        <translation>Position du coude</translation>
    </message>
    <message>
        <source>Elbow speed</source>
        <translation>Vitesse du coude</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Quantité de mouvement</translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation>Positions articulaires</translation>
    </message>
    <message>
        <source>Joint speeds</source>
        <translation>Vitesses articulaires</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>Courants articulaires</translation>
    </message>
    <message>
        <source>Joint temperatures</source>
        <translation>Températures articulaires</translation>
    </message>
    <message>
        <source>Joint voltages</source>
        <translation>Tensions articulaires</translation>
    </message>
    <message>
        <source>Target joint positions</source>
        <translation>Positions articulaires cibles</translation>
    </message>
    <message>
        <source>Target joint speeds</source>
        <translation>Vitesses articulaires cibles</translation>
    </message>
    <message>
        <source>Target joint accelerations</source>
        <translation>Accélérations articulaires cibles</translation>
    </message>
    <message>
        <source>Target joint currents</source>
        <translation>Courants articulaires cibles</translation>
    </message>
    <message>
        <source>Target joint torques</source>
        <translation>Couples articulaires cibles</translation>
    </message>
    <message>
        <source>Joint control currents</source>
        <translation>Courants de commande articulaires</translation>
    </message>
    <message>
        <source>Allowed current deviation</source>
        <translation>Écart permis des courants</translation>
    </message>
    <message>
        <source>Position deviation, ratio to limit</source>
        <translation>Écart de position, rapport à la limite</translation>
    </message>
    <message>
        <source>Collision detection, ratio to limit</source>
        <translation>Détection de collision, rapport à la limite</translation>
    </message>
    <message>
        <source>Joint modes</source>
        <translation>Modes articulaires</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>Entrées numériques</translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation>Sorties numériques</translation>
    </message>
    <message>
        <source>Analog input 0</source>
        <translation>Entrée analogique 0</translation>
    </message>
    <message>
        <source>Analog input 1</source>
        <translation>Entrée analogique 1</translation>
    </message>
    <message>
        <source>Analog output 0</source>
        <translation>Sortie analogique 0</translation>
    </message>
    <message>
        <source>Analog output 1</source>
        <translation>Sortie analogique 1</translation>
    </message>
    <message>
        <source>Tool analog input 0</source>
        <translation>Entrée analogique d’outil 0</translation>
    </message>
    <message>
        <source>Tool analog input 1</source>
        <translation>Entrée analogique d’outil 1</translation>
    </message>
    <message>
        <source>Robot mode</source>
        <translation>Mode du robot</translation>
    </message>
    <message>
        <source>Safety mode</source>
        <translation>Mode de sécurité</translation>
    </message>
    <message>
        <source>Safety status</source>
        <translation>État de sécurité</translation>
    </message>
    <message>
        <source>Program state</source>
        <translation>État du programme</translation>
    </message>
    <message>
        <source>Robot status</source>
        <translation>État du robot</translation>
    </message>
    <message>
        <source>Safety bits</source>
        <translation>Bits de sécurité</translation>
    </message>
    <message>
        <source>Tool mode</source>
        <translation>Mode de l’outil</translation>
    </message>
    <message>
        <source>Main voltage</source>
        <translation>Tension principale</translation>
    </message>
    <message>
        <source>Arm voltage</source>
        <translation>Tension du bras</translation>
    </message>
    <message>
        <source>Arm current</source>
        <translation>Courant du bras</translation>
    </message>
    <message>
        <source>I/O current</source>
        <translation>Courant des E/S</translation>
    </message>
    <message>
        <source>Tool temperature</source>
        <translation>Température de l’outil</translation>
    </message>
    <message>
        <source>Tool voltage</source>
        <translation>Tension de l’outil</translation>
    </message>
    <message>
        <source>Tool current</source>
        <translation>Courant de l’outil</translation>
    </message>
    <message>
        <source>Speed scaling</source>
        <translation>Échelle de vitesse</translation>
    </message>
    <message>
        <source>Speed slider</source>
        <translation>Curseur de vitesse</translation>
    </message>
    <message>
        <source>Control step time</source>
        <translation>Durée d’un pas de commande</translation>
    </message>
    <message>
        <source>Script line</source>
        <translation>Ligne du script</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>Temps du contrôleur</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Charge utile</translation>
    </message>
    <message>
        <source>Payload centre of gravity</source>
        <translation>Centre de gravité de la charge utile</translation>
    </message>
    <message>
        <source>TCP offset</source>
        <translation>Décalage du TCP</translation>
    </message>
    <message>
        <source>TCP rotation</source>
        <translation>Rotation du TCP</translation>
    </message>
    <message>
        <source>Power on</source>
        <translation>Mettre sous tension</translation>
    </message>
    <message>
        <source>Program running</source>
        <translation>Programme en cours</translation>
    </message>
    <message>
        <source>Freedrive button</source>
        <translation>Bouton Freedrive</translation>
    </message>
    <message>
        <source>Power button</source>
        <translation>Bouton d’alimentation</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Réduit</translation>
    </message>
    <message>
        <source>Protective stop</source>
        <translation>Arrêt de protection</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Récupération</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>Arrêt de sauvegarde</translation>
    </message>
    <message>
        <source>System emergency stop</source>
        <translation>Arrêt d’urgence système</translation>
    </message>
    <message>
        <source>Robot emergency stop</source>
        <translation>Arrêt d’urgence du robot</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Arrêt d’urgence</translation>
    </message>
    <message>
        <source>Violation</source>
        <translation>Violation</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>Enabling device</source>
        <translation>Dispositif de validation</translation>
    </message>
    <message>
        <source>Bit %1</source>
        <translation>Bit %1</translation>
    </message>
    <message>
        <source>Output registers, floats</source>
        <translation>Registres de sortie, réels</translation>
    </message>
    <message>
        <source>Input registers, floats</source>
        <translation>Registres d’entrée, réels</translation>
    </message>
    <message>
        <source>Output registers, integers</source>
        <translation>Registres de sortie, entiers</translation>
    </message>
    <message>
        <source>Input registers, integers</source>
        <translation>Registres d’entrée, entiers</translation>
    </message>
    <message>
        <source>Output registers, bits</source>
        <translation>Registres de sortie, bits</translation>
    </message>
    <message>
        <source>Input registers, bits</source>
        <translation>Registres d’entrée, bits</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activée</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivée</translation>
    </message>
    <message>
        <source>Stopped due to safety</source>
        <translation>Arrêté par la sécurité</translation>
    </message>
</context>
<context>
    <name>SpaceMouse</name>
    <message>
        <source>left button</source>
        <translation>bouton gauche</translation>
    </message>
    <message>
        <source>The tool follows the motion of the cap.</source>
        <translation>L’outil suit le mouvement du capuchon.</translation>
    </message>
</context>
<context>
    <name>Spectrum</name>
    <message>
        <source>compute a spectrum</source>
        <translation>calculer un spectre</translation>
    </message>
    <message>
        <source>The range contains fewer than %1 samples. Select a longer range.</source>
        <translation>Il y a moins de %1 échantillons : choisissez une plage plus longue.</translation>
    </message>
    <message>
        <source>Values are missing in this range. Select a range without gaps.</source>
        <translation>Des valeurs manquent dans cette plage : sélectionnez une plage sans lacunes.</translation>
    </message>
    <message>
        <source>Not enough memory. Select a shorter range.</source>
        <translation>Mémoire insuffisante : sélectionnez une plage plus courte.</translation>
    </message>
</context>
<context>
    <name>StartProject</name>
    <message>
        <source>The last project no longer exists: %1</source>
        <translation>Le dernier projet n’existe plus : %1</translation>
    </message>
</context>
<context>
    <name>StateLane</name>
    <message>
        <source>Protective stop</source>
        <translation>Arrêt de protection</translation>
    </message>
    <message>
        <source>Recovery</source>
        <translation>Récupération</translation>
    </message>
    <message>
        <source>Safeguard stop</source>
        <translation>Arrêt de sauvegarde</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Arrêt d’urgence</translation>
    </message>
    <message>
        <source>Enabling device released</source>
        <translation>Dispositif de validation lâché</translation>
    </message>
    <message>
        <source>Safety violation</source>
        <translation>Violation de sécurité</translation>
    </message>
    <message>
        <source>Safety fault</source>
        <translation>Défaut de sécurité</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>Power off</source>
        <translation>Hors tension</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>Brakes on</source>
        <translation>Freins serrés</translation>
    </message>
    <message>
        <source>Backdrive</source>
        <translation>Backdrive</translation>
    </message>
    <message>
        <source>Not running</source>
        <translation>Ne marche pas</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Sans données</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>Freedrive</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation>Aller en %1</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>En mouvement</translation>
    </message>
    <message>
        <source>At standstill</source>
        <translation>À l’arrêt</translation>
    </message>
    <message>
        <source>Late data</source>
        <translation>Données en retard</translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Enter an IP address, such as 192.168.0.10, or a host name.</source>
        <translation>Saisissez une adresse IP, p. ex. 192.168.0.10, ou un nom d’hôte.</translation>
    </message>
    <message>
        <source>Check that the robot is switched on, the cable is plugged in, and this PC is on the same network.</source>
        <translation>Vérifiez que le robot est allumé, que le câble est branché et que ce PC est sur le même réseau.</translation>
    </message>
    <message>
        <source>Enable the interface on the robot under Settings &gt; Security &gt; Services. A robot that has just started may need another minute.</source>
        <translation>Activez l’interface sur le robot sous Réglages &gt; Sécurité &gt; Services. Un robot qui vient de démarrer peut avoir besoin d’une minute de plus.</translation>
    </message>
    <message>
        <source>The robot may be restarting or switching between Local and Remote control. Wait a minute, then connect again.</source>
        <translation>Il redémarre peut-être, ou il passe entre Local et À distance. Attendez une minute, puis reconnectez-vous.</translation>
    </message>
    <message>
        <source>The robot does not respond. Check the cable and the address.</source>
        <translation>Le robot ne répond pas. Vérifiez le câble et l’adresse.</translation>
    </message>
    <message>
        <source>No more data received. Check the cable. Tiller reconnects automatically; motion does not resume.</source>
        <translation>Plus aucune donnée reçue. Vérifiez le câble. Tiller se reconnecte automatiquement ; le mouvement ne reprend pas.</translation>
    </message>
    <message>
        <source>The response is not valid for this protocol. Check the address and the port.</source>
        <translation>La réponse ne respecte pas le protocole. Vérifiez l’adresse et le port.</translation>
    </message>
    <message>
        <source>If newer software is available for this robot, update the robot.</source>
        <translation>Si un logiciel plus récent existe pour ce robot, mettez le robot à jour.</translation>
    </message>
    <message>
        <source>The robot&apos;s software does not provide this value.</source>
        <translation>Le logiciel du robot ne fournit pas cette valeur.</translation>
    </message>
    <message>
        <source>Another program or a fieldbus on the robot uses these registers. Close the other program, or disable the fieldbus in the installation.</source>
        <translation>Un autre programme ou un bus de terrain du robot utilise ces registres : fermez l’autre programme ou désactivez le bus de terrain dans l’installation.</translation>
    </message>
    <message>
        <source>Connect to a robot first.</source>
        <translation>Connectez-vous d’abord à un robot.</translation>
    </message>
    <message>
        <source>Take control first.</source>
        <translation>Prenez d’abord le contrôle.</translation>
    </message>
    <message>
        <source>Power on the arm, release the brakes and clear any safety stop first.</source>
        <translation>Mettez d’abord le bras sous tension, desserrez les freins et annulez tout arrêt de sécurité.</translation>
    </message>
    <message>
        <source>Switch the robot to Remote control at the top right of the teach pendant.</source>
        <translation>Passez le robot en commande à distance sur le pupitre, en haut à droite.</translation>
    </message>
    <message>
        <source>Choose a target within the reach of the arm and a speed below the speed cap.</source>
        <translation>Choisissez une cible à la portée du bras et une vitesse sous le plafond.</translation>
    </message>
    <message>
        <source>The arm cannot reach this pose. Move the target closer or rotate the tool.</source>
        <translation>Le bras ne peut pas atteindre cette pose : rapprochez le point ou tournez l’outil.</translation>
    </message>
    <message>
        <source>The robot could not run the program. See the log for the controller&apos;s message.</source>
        <translation>Le robot n’a pas pu exécuter le programme. Le message du contrôleur figure dans le journal.</translation>
    </message>
    <message>
        <source>Check that the file exists and that you have permission to read it.</source>
        <translation>Vérifiez que le fichier existe et que vous avez le droit de le lire.</translation>
    </message>
    <message>
        <source>Choose a folder that you have permission to write to.</source>
        <translation>Choisissez un dossier où vous avez le droit d’écrire.</translation>
    </message>
    <message>
        <source>The file was not changed. Open a backup, or repair the file at the reported position.</source>
        <translation>Le fichier n’a pas été modifié. Ouvrez une sauvegarde ou réparez l’endroit signalé.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fait</translation>
    </message>
    <message>
        <source>Address not found</source>
        <translation>Adresse introuvable</translation>
    </message>
    <message>
        <source>Robot not reachable</source>
        <translation>Robot injoignable</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>Connexion refusée</translation>
    </message>
    <message>
        <source>Connection closed by the robot</source>
        <translation>Connexion terminée par le robot</translation>
    </message>
    <message>
        <source>Timed out</source>
        <translation>Délai dépassé</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Annulé</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>Liaison perdue</translation>
    </message>
    <message>
        <source>Protocol error</source>
        <translation>Erreur de protocole</translation>
    </message>
    <message>
        <source>Not supported by this robot</source>
        <translation>Non pris en charge par ce robot</translation>
    </message>
    <message>
        <source>Value not available</source>
        <translation>Valeur indisponible</translation>
    </message>
    <message>
        <source>Registers in use</source>
        <translation>Registres occupés</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Non connecté</translation>
    </message>
    <message>
        <source>Not in control</source>
        <translation>Non contrôlé</translation>
    </message>
    <message>
        <source>Robot not ready</source>
        <translation>Robot non prêt</translation>
    </message>
    <message>
        <source>Robot is in Local control</source>
        <translation>Le robot est en commande locale</translation>
    </message>
    <message>
        <source>Outside the limits</source>
        <translation>Hors des limites</translation>
    </message>
    <message>
        <source>Invalid value</source>
        <translation>Valeur non valide</translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation>Hors de portée</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>Refused by the robot</source>
        <translation>Refusé par le robot</translation>
    </message>
    <message>
        <source>Program error on the robot</source>
        <translation>Erreur de programme sur le robot</translation>
    </message>
    <message>
        <source>Cannot read the file</source>
        <translation>Le fichier ne peut être lu</translation>
    </message>
    <message>
        <source>Cannot write the file</source>
        <translation>Le fichier ne peut être écrit</translation>
    </message>
    <message>
        <source>File is damaged</source>
        <translation>Le fichier est endommagé</translation>
    </message>
    <message>
        <source>Disk full</source>
        <translation>Disque plein</translation>
    </message>
    <message>
        <source>Internal error</source>
        <translation>Erreur interne</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>button or key released</source>
        <translation>bouton ou touche relâché</translation>
    </message>
    <message>
        <source>pointer left the button</source>
        <translation>le pointeur a quitté le bouton</translation>
    </message>
    <message>
        <source>focus lost</source>
        <translation>focus perdu</translation>
    </message>
    <message>
        <source>another window became active</source>
        <translation>autre fenêtre devenue active</translation>
    </message>
    <message>
        <source>window closed</source>
        <translation>fenêtre fermée</translation>
    </message>
    <message>
        <source>a dialog or menu opened</source>
        <translation>un dialogue ou menu s’est ouvert</translation>
    </message>
    <message>
        <source>another button or key pressed</source>
        <translation>autre bouton ou touche enfoncé</translation>
    </message>
    <message>
        <source>Esc pressed</source>
        <translation>Échap enfoncée</translation>
    </message>
    <message>
        <source>Space pressed</source>
        <translation>Espace enfoncée</translation>
    </message>
    <message>
        <source>STOP pressed</source>
        <translation>STOP enfoncé</translation>
    </message>
    <message>
        <source>input device lost</source>
        <translation>périphérique perdu</translation>
    </message>
    <message>
        <source>robot data arrived too late</source>
        <translation>données du robot trop anciennes</translation>
    </message>
    <message>
        <source>robot or safety mode changed</source>
        <translation>mode du robot ou de sécurité changé</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>liaison perdue</translation>
    </message>
    <message>
        <source>limit reached</source>
        <translation>limite atteinte</translation>
    </message>
    <message>
        <source>control lost</source>
        <translation>contrôle perdu</translation>
    </message>
    <message>
        <source>target reached</source>
        <translation>cible atteinte</translation>
    </message>
    <message>
        <source>stopped by a program</source>
        <translation>arrêté par un programme</translation>
    </message>
    <message>
        <source>contact detected</source>
        <translation>contact détecté</translation>
    </message>
    <message>
        <source>target cannot be reached</source>
        <translation>cible inaccessible</translation>
    </message>
    <message>
        <source>could not verify that the button or key is still pressed</source>
        <translation>impossible de vérifier que le bouton ou la touche est encore enfoncé</translation>
    </message>
    <message>
        <source>maximum hold time reached; press again</source>
        <translation>durée maximale de maintien atteinte ; appuyez de nouveau</translation>
    </message>
    <message>
        <source>PolyScope X before 10.11 does not accept these commands over the network. Use the teach pendant.</source>
        <translation>PolyScope X avant 10.11 n’accepte pas ces commandes par le réseau : utilisez le pupitre.</translation>
    </message>
    <message>
        <source>PolyScope X cannot close popups over the network. Use the teach pendant.</source>
        <translation>PolyScope X ne peut pas fermer les messages par le réseau : utilisez le pupitre.</translation>
    </message>
    <message>
        <source>Monitoring. Take control to move the arm.</source>
        <translation>Observation. Prenez le contrôle pour déplacer le bras.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Prise de contrôle…</translation>
    </message>
    <message>
        <source>Control was given back. Take control to move the arm.</source>
        <translation>Le contrôle a été rendu. Prenez le contrôle pour bouger le bras.</translation>
    </message>
    <message>
        <source>The control program on the robot was stopped. Take control again.</source>
        <translation>Le programme de commande a été arrêté sur le robot. Reprenez le contrôle.</translation>
    </message>
    <message>
        <source>The control program was replaced or does not respond. Take control again.</source>
        <translation>Le programme de commande a été remplacé ou ne répond pas. Reprenez le contrôle.</translation>
    </message>
    <message>
        <source>The connection was lost. Take control again.</source>
        <translation>La connexion a été perdue. Reprenez le contrôle.</translation>
    </message>
    <message>
        <source>Your script is running. Tiller regains control when the script ends.</source>
        <translation>Votre script est en cours. Tiller reprend le contrôle quand il se termine.</translation>
    </message>
    <message>
        <source>Free some space on the disk, then save or record again.</source>
        <translation>Libérez de l’espace disque, puis enregistrez de nouveau.</translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. Turn off “Monitor only” in Settings, or start Tiller without --monitor-only.</source>
        <translation>Surveillance seule : cette fenêtre ne change rien sur le robot. Désactivez « Surveillance seule » dans les réglages, ou démarrez Tiller sans --monitor-only.</translation>
    </message>
    <message>
        <source>No current data from the robot. Check the network connection to the robot.</source>
        <translation>Aucune donnée actuelle du robot. Vérifiez la connexion réseau avec le robot.</translation>
    </message>
    <message>
        <source>selection or modifier key changed</source>
        <translation>sélection ou touche de modification changée</translation>
    </message>
    <message>
        <source>the window did not respond</source>
        <translation>la fenêtre ne répondait pas</translation>
    </message>
    <message>
        <source>not measured: no data during the stop</source>
        <translation>non mesuré : aucune donnée pendant l’arrêt</translation>
    </message>
    <message>
        <source>not measured: another program is moving the arm</source>
        <translation>non mesuré : un autre programme déplace le bras</translation>
    </message>
    <message>
        <source>the PC is going to sleep</source>
        <translation>le PC se met en veille</translation>
    </message>
    <message>
        <source>the robot did not receive the stop command</source>
        <translation>le robot n’a pas reçu la commande d’arrêt</translation>
    </message>
    <message>
        <source>servo target too far from the previous target</source>
        <translation>cible servo trop loin de la précédente</translation>
    </message>
</context>
<context>
    <name>WaypointClipboard</name>
    <message>
        <source>the value is missing</source>
        <translation>la valeur manque</translation>
    </message>
    <message>
        <source>“%1” is not a number</source>
        <translation>« %1 » n’est pas un nombre</translation>
    </message>
    <message>
        <source>%1 is outside the range %2 to %3</source>
        <translation>%1 est hors de %2 à %3</translation>
    </message>
    <message>
        <source>Line %1, column “%2”: %3.</source>
        <translation>Ligne %1, colonne « %2 » : %3.</translation>
    </message>
    <message>
        <source>“%1” must be “J” or “L”</source>
        <translation>« %1 » doit être « J » ou « L »</translation>
    </message>
    <message>
        <source>“%1” must be “joints” or “pose”</source>
        <translation>« %1 » doit être « joints » ou « pose »</translation>
    </message>
    <message>
        <source>the project has no frame named “%1”</source>
        <translation>il n’y a pas de repère « %1 » dans ce projet</translation>
    </message>
    <message>
        <source>The text is not a table of waypoints. Copy a waypoint from the list to see the columns, or use the six values of a pose.</source>
        <translation>Ce n’est pas un tableau de points de passage. Copiez un point de la liste pour voir les colonnes, ou collez les six valeurs d’une pose.</translation>
    </message>
    <message>
        <source>“%1” is not a waypoint colour (none, blue, orange, green, pink, yellow or sky)</source>
        <translation>« %1 » n’est pas une couleur de point de passage (none, blue, orange, green, pink, yellow ou sky)</translation>
    </message>
</context>
<context>
    <name>WaypointExchange</name>
    <message>
        <source>Line %1: the closing quotation mark is missing.</source>
        <translation>Ligne %1 : le guillemet fermant manque.</translation>
    </message>
</context>
<context>
    <name>tiller::ActionsDialog</name>
    <message>
        <source>Actions at “%1”</source>
        <translation>Actions à « %1 »</translation>
    </message>
    <message numerus="yes">
        <source>Actions at %n waypoints</source>
        <translation>
            <numerusform>Actions à %n point de passage</numerusform>
            <numerusform>Actions à %n points de passage</numerusform>
        </translation>
    </message>
    <message>
        <source>“Run route (hold)” runs these actions in order at the waypoint while the button is held.</source>
        <translation>Les actions s’exécutent dans cet ordre quand « Itinéraire » atteint le point de passage et que son bouton est maintenu.</translation>
    </message>
    <message>
        <source>These waypoints have different actions. “Apply” replaces them all with the actions below.</source>
        <translation>Ces points de passage ont des actions différentes. « Appliquer » les remplace toutes par les actions ci-dessous.</translation>
    </message>
    <message>
        <source>Actions in order</source>
        <translation>Actions dans l’ordre</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Remove the selected action</source>
        <translation>Retirer l’action sélectionnée</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Move the selected action up</source>
        <translation>Monter l’action sélectionnée</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Descendre</translation>
    </message>
    <message>
        <source>Move the selected action down</source>
        <translation>Descendre l’action sélectionnée</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Terminal</source>
        <translation>Borne</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivée</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activée</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>Délai maximal</translation>
    </message>
    <message>
        <source>After this time, the action fails with a message. With 0, the action waits while the button is held, up to one hour.</source>
        <translation>Après ce délai, l’attente échoue avec un message. 0 : attend tant que le bouton est maintenu, une heure au plus.</translation>
    </message>
    <message>
        <source>Add an action after the selected action</source>
        <translation>Ajouter une action après celle sélectionnée</translation>
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
        <translation>%1 domaine</translation>
    </message>
    <message>
        <source>%1 value</source>
        <translation>%1 valeur</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Régler</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>Régler %1</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Scale…</source>
        <translation>Échelle…</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Nom de %1</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Échelle de %1</translation>
    </message>
    <message>
        <source>e.g. bar; empty: no scaling</source>
        <translation>p. ex. bar ; vide : sans échelle</translation>
    </message>
    <message>
        <source>At 4 mA or 0 V</source>
        <translation>À 4 mA ou 0 V</translation>
    </message>
    <message>
        <source>At 20 mA or 10 V</source>
        <translation>À 20 mA ou 10 V</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>%1: %2
To rename or scale the signal, right-click it, or press F2 or Shift+F2.</source>
        <translation>%1 : %2
F2 pour renommer, Maj+F2 pour mettre à l’échelle, ou clic droit.</translation>
    </message>
</context>
<context>
    <name>tiller::ArmKey</name>
    <message>
        <source>Keyboard armed</source>
        <translation>Clavier armé</translation>
    </message>
    <message>
        <source>Arm keyboard</source>
        <translation>Armer le clavier</translation>
    </message>
    <message>
        <source>While the keyboard is armed, holding an arrow key moves the arm. A border around the window shows that the keyboard is armed.</source>
        <translation>Clavier armé, les flèches déplacent le bras tant qu’elles sont maintenues. Un cadre autour de la fenêtre indique que le clavier est armé.</translation>
    </message>
    <message>
        <source>Arrow keys move along X and Y, PgUp and PgDn along Z; with Alt, they rotate the tool. Hold 1 to 6 and press + or − to move a joint. Space and Esc stop the arm. To disarm the keyboard, click this button or wait 30 s.</source>
        <translation>Les flèches déplacent X et Y, Pg préc et Pg suiv déplacent Z ; avec Alt, elles tournent. 1 à 6 avec + et − déplacent une articulation. Espace et Échap arrêtent. Pour désarmer, cliquez ou attendez 30 s.</translation>
    </message>
</context>
<context>
    <name>tiller::CellPage</name>
    <message>
        <source>Size %1</source>
        <translation>Taille %1</translation>
    </message>
    <message>
        <source>Shown and checked for collisions</source>
        <translation>Affiché et vérifié contre les collisions</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Enter a name for the box or plane.</source>
        <translation>Saisissez un nom pour la boîte ou le plan.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renommer « %1 » en « %2 »</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cellule</translation>
    </message>
    <message>
        <source>No boxes or planes yet.
Move the TCP to a corner of an obstacle and press “Teach corner”.</source>
        <translation>Pas encore de boîtes ni de plans.
Amenez le TCP à un coin d’un obstacle et appuyez sur « Coin ici ».</translation>
    </message>
    <message>
        <source>Check for collisions</source>
        <translation>Vérifier les collisions</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>Centre of the box. Press Return to apply the values. Only the box changes; the robot does not move.</source>
        <translation>Centre de la boîte. Entrée pour appliquer. Seule la boîte change ; le robot ne bouge pas.</translation>
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
        <translation>boîte</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>Ajouter « %1 »</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>plan</translation>
    </message>
    <message>
        <source>First corner recorded</source>
        <translation>Premier coin pris</translation>
    </message>
    <message>
        <source>Move the TCP to the opposite corner and press “Teach corner 2”.</source>
        <translation>Amenez le TCP au coin opposé et appuyez sur « Autre coin ».</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>The corners must differ by at least 1 mm along X, Y and Z. Move the TCP to the opposite corner of the box.</source>
        <translation>Les coins doivent différer d’au moins 1 mm en X, Y et Z. Amenez le TCP au coin opposé de la boîte.</translation>
    </message>
    <message>
        <source>Move “%1”</source>
        <translation>Déplacer « %1 »</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Dupliquer « %1 »</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>Supprimer « %1 »</translation>
    </message>
    <message>
        <source>Set the floor</source>
        <translation>Définir le sol</translation>
    </message>
    <message>
        <source>Remove the floor</source>
        <translation>Supprimer le sol</translation>
    </message>
    <message>
        <source>Change the safety distance</source>
        <translation>Modifier la distance de sécurité</translation>
    </message>
    <message>
        <source>Teach corner 2</source>
        <translation>Autre coin</translation>
    </message>
    <message>
        <source>Teach corner</source>
        <translation>Coin ici</translation>
    </message>
    <message>
        <source>%1 · %2 in %3</source>
        <translation>%1 · %2 dans %3</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Length along X</source>
        <translation>Longueur selon X</translation>
    </message>
    <message>
        <source>Length along Y</source>
        <translation>Longueur selon Y</translation>
    </message>
    <message>
        <source>Length along Z</source>
        <translation>Longueur selon Z</translation>
    </message>
    <message>
        <source>Point on the plane, X</source>
        <translation>Point du plan, X</translation>
    </message>
    <message>
        <source>Point on the plane, Y</source>
        <translation>Point du plan, Y</translation>
    </message>
    <message>
        <source>Point on the plane, Z</source>
        <translation>Point du plan, Z</translation>
    </message>
    <message>
        <source>Normal X, towards the arm</source>
        <translation>Normale X, vers le bras</translation>
    </message>
    <message>
        <source>Normal Y, towards the arm</source>
        <translation>Normale Y, vers le bras</translation>
    </message>
    <message>
        <source>Normal Z, towards the arm</source>
        <translation>Normale Z, vers le bras</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>When off, the box or plane is neither shown nor checked for collisions.</source>
        <translation>Désactivé, la boîte ou le plan n’est ni affiché ni vérifié contre les collisions.</translation>
    </message>
    <message>
        <source>Horizontal plane in the base frame that the arm must stay above.</source>
        <translation>Plan horizontal dans le repère de base, au-dessus duquel le bras doit rester.</translation>
    </message>
    <message>
        <source>Floor height</source>
        <translation>Hauteur du sol</translation>
    </message>
    <message>
        <source>Safety distance</source>
        <translation>Distance de sécurité</translation>
    </message>
    <message>
        <source>Jogging stops at this distance from objects in the cell and between parts of the arm. Moves that would bring the arm closer are refused.</source>
        <translation>Le déplacement manuel s’arrête à cette distance des objets de la cellule et entre les parties du bras. Les mouvements qui s’approchent davantage sont refusés.</translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation>Au TCP</translation>
    </message>
    <message>
        <source>Set the floor to the TCP height</source>
        <translation>Placer le sol à la hauteur du TCP</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Teach a box corner at the TCP</source>
        <translation>Placer un coin de boîte au TCP</translation>
    </message>
    <message>
        <source>Teach plane</source>
        <translation>Plan ici</translation>
    </message>
    <message>
        <source>Add a plane through the TCP, perpendicular to the tool</source>
        <translation>Ajouter un plan par le TCP, perpendiculaire à l’outil</translation>
    </message>
    <message>
        <source>New box</source>
        <translation>Nouvelle boîte</translation>
    </message>
    <message>
        <source>Add a box numerically</source>
        <translation>Ajouter une boîte par valeurs</translation>
    </message>
    <message>
        <source>Add a plane through the TCP</source>
        <translation>Ajouter un plan par le TCP</translation>
    </message>
    <message>
        <source>Add a plane numerically</source>
        <translation>Ajouter un plan par valeurs</translation>
    </message>
    <message>
        <source>Move the box or plane to the TCP</source>
        <translation>Déplacer la boîte ou le plan au TCP</translation>
    </message>
    <message>
        <source>Rename box or plane</source>
        <translation>Renommer la boîte ou le plan</translation>
    </message>
    <message>
        <source>Duplicate box or plane</source>
        <translation>Dupliquer la boîte ou le plan</translation>
    </message>
    <message>
        <source>Delete box or plane</source>
        <translation>Supprimer la boîte ou le plan</translation>
    </message>
    <message>
        <source>Resize “%1”</source>
        <translation>Redimensionner « %1 »</translation>
    </message>
    <message>
        <source>The normal must not be zero. Enter at least one nonzero component.</source>
        <translation>La normale ne peut pas être nulle. Saisissez d’abord une composante.</translation>
    </message>
    <message>
        <source>Rotate “%1”</source>
        <translation>Tourner « %1 »</translation>
    </message>
    <message>
        <source>missing frame</source>
        <translation>repère manquant</translation>
    </message>
    <message>
        <source>Turn on the collision check of “%1”</source>
        <translation>Activer la vérification des collisions de « %1 »</translation>
    </message>
    <message>
        <source>Turn off the collision check of “%1”</source>
        <translation>Désactiver la vérification des collisions de « %1 »</translation>
    </message>
    <message>
        <source>Turn collision check on or off</source>
        <translation>Activer ou désactiver la vérification des collisions</translation>
    </message>
    <message>
        <source>The cell already contains “%1”. Choose a different name.</source>
        <translation>La cellule contient déjà « %1 ». Choisissez un autre nom.</translation>
    </message>
</context>
<context>
    <name>tiller::ChecklistItem</name>
    <message>
        <source>done</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>not done yet</source>
        <translation>pas encore fait</translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonBand</name>
    <message>
        <source>Comparison with the arm model</source>
        <translation>Comparaison avec le modèle du bras</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Comparer…</translation>
    </message>
    <message>
        <source>Compare this recording with the arm model using different limits</source>
        <translation>Comparer cet enregistrement au modèle du bras avec d’autres limites</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Go to time</source>
        <translation>Y aller</translation>
    </message>
    <message>
        <source>Cancel the comparison</source>
        <translation>Annuler la comparaison</translation>
    </message>
    <message>
        <source>Place cursor A where the arm and the model diverge</source>
        <translation>Placer le curseur A où le bras et le modèle divergent</translation>
    </message>
</context>
<context>
    <name>tiller::ComparisonDialog</name>
    <message>
        <source>Compare with the arm model</source>
        <translation>Comparer au modèle du bras</translation>
    </message>
    <message>
        <source>The simulated arm follows the recorded joint targets, and its motion is compared with the recorded motion. The model includes neither contact nor friction.</source>
        <translation>Le bras simulé suit les consignes articulaires enregistrées, et son mouvement est comparé au mouvement enregistré. Le modèle n’inclut ni contact ni frottement.</translation>
    </message>
    <message>
        <source>Arm model</source>
        <translation>Modèle du bras</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Bras</translation>
    </message>
    <message>
        <source>Joint positions</source>
        <translation>Positions des articulations</translation>
    </message>
    <message>
        <source>TCP position</source>
        <translation>Position du TCP</translation>
    </message>
    <message>
        <source>Joint currents</source>
        <translation>Courants des articulations</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Force au TCP</translation>
    </message>
    <message>
        <source>Signals with a limit of 0 are not compared.</source>
        <translation>Les signaux de limite 0 ne sont pas comparés.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Minimum duration</source>
        <translation>Durée minimale</translation>
    </message>
</context>
<context>
    <name>tiller::CurveDialog</name>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Displayed value = value × scale + offset</source>
        <translation>Valeur affichée = valeur × échelle + décalage</translation>
    </message>
    <message>
        <source>Choose the colour</source>
        <translation>Choisir la couleur</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Automatic colour</source>
        <translation>Couleur automatique</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Continue</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Tirets</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Pointillés</translation>
    </message>
    <message>
        <source>Value axis</source>
        <translation>Axe des valeurs</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Saisissez un nom.</translation>
    </message>
    <message>
        <source>Name and unit cannot contain = [ ].</source>
        <translation>Le nom et l’unité ne peuvent pas contenir = [ ].</translation>
    </message>
    <message>
        <source>Enter a number other than 0 as the scale.</source>
        <translation>Saisissez comme échelle un nombre différent de 0.</translation>
    </message>
    <message>
        <source>Enter a number as the offset.</source>
        <translation>Saisissez un nombre comme décalage.</translation>
    </message>
</context>
<context>
    <name>tiller::DecimalSpinBox</name>
    <message>
        <source>“%1” is out of range (%2 to %3). The value is still %4.</source>
        <translation>« %1 » est hors de la plage (%2 à %3). La valeur reste %4.</translation>
    </message>
</context>
<context>
    <name>tiller::DeviceTrainer</name>
    <message>
        <source>Enable motion (until Tiller is closed)</source>
        <translation>Autoriser le mouvement (jusqu’à la fermeture de Tiller)</translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation>Axe dominant seulement</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation>Manette et SpaceMouse</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Périphérique</translation>
    </message>
    <message>
        <source>Direction in which the arm would move</source>
        <translation>Direction dans laquelle le bras irait</translation>
    </message>
    <message>
        <source>Hold-to-run</source>
        <translation>Validation</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation>Aucune manette ni SpaceMouse trouvée. Branchez-en une ; elle est détectée automatiquement.</translation>
    </message>
    <message>
        <source>● held (%1)</source>
        <translation>● tenu (%1)</translation>
    </message>
    <message>
        <source>○ not held: hold the %1</source>
        <translation>○ non tenu : tenez %1</translation>
    </message>
    <message>
        <source>none (neutral)</source>
        <translation>aucun (neutre)</translation>
    </message>
    <message>
        <source>With the keyboard armed (Ctrl+J): arrow keys for X and Y; PgUp and PgDn for Z; Alt with these keys for rotation; 1 to 6 with + and − for joints; Home for the home position; End to align; Backspace to move back; F for Freedrive; Ctrl for slower; Shift for faster. Space and Esc stop the arm.</source>
        <translation>Clavier armé (Ctrl+J) : flèches : X et Y ; Pg préc, Pg suiv : Z ; avec Alt : rotation ; 1 à 6 avec + et − : articulations ; Début : origine ; Fin : aligner ; Retour arrière : retour ; F : Freedrive ; Ctrl : plus lent ; Maj : plus rapide. Espace et Échap arrêtent.</translation>
    </message>
</context>
<context>
    <name>tiller::EmptyState</name>
    <message>
        <source>Nothing found</source>
        <translation>Rien trouvé</translation>
    </message>
    <message>
        <source>Nothing found with these filters.</source>
        <translation>Rien trouvé avec ces filtres.</translation>
    </message>
    <message>
        <source>Nothing found for “%1”.
Clear the search to see everything.</source>
        <translation>Rien trouvé pour « %1 ».
Videz la recherche pour tout voir.</translation>
    </message>
</context>
<context>
    <name>tiller::FirstSteps</name>
    <message>
        <source>Power on (header)</source>
        <translation>Mettre sous tension (en-tête)</translation>
    </message>
    <message>
        <source>Release brakes (header)</source>
        <translation>Desserrer les freins (en-tête)</translation>
    </message>
    <message>
        <source>Take control and hold a jog button</source>
        <translation>Prendre le contrôle, tenir un bouton</translation>
    </message>
    <message>
        <source>Teach here (T)</source>
        <translation>Apprendre ici (T)</translation>
    </message>
    <message>
        <source>Jog away and hold “Go to” (G)</source>
        <translation>S’éloigner, tenir Aller à (G)</translation>
    </message>
    <message>
        <source>Record (above the plots)</source>
        <translation>Enregistrer (au-dessus des tracés)</translation>
    </message>
</context>
<context>
    <name>tiller::FirstStepsCard</name>
    <message>
        <source>First steps</source>
        <translation>Premiers pas</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>Exercices</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Écarter</translation>
    </message>
    <message>
        <source>The list will not appear again. Use the command “First steps” to reopen it.</source>
        <translation>La liste ne réapparaîtra pas. Utilisez la commande « Premiers pas » pour la rouvrir.</translation>
    </message>
    <message>
        <source>First steps · %1 of %2</source>
        <translation>Premiers pas · %1 sur %2</translation>
    </message>
</context>
<context>
    <name>tiller::FrameDetails</name>
    <message>
        <source>Selected frame</source>
        <translation>Repère choisi</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>In the base frame. Press Return to apply the values. Only the frame changes; the robot does not move.</source>
        <translation>Dans le repère de base. Appuyez sur Entrée pour appliquer. Seul le repère change ; le robot ne bouge pas.</translation>
    </message>
    <message>
        <source>not used by any waypoint</source>
        <translation>utilisé par aucun point de passage</translation>
    </message>
    <message numerus="yes">
        <source>used by %n waypoints</source>
        <translation>
            <numerusform>utilisé par %n point de passage</numerusform>
            <numerusform>utilisé par %n points de passage</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the TCP</source>
        <translation>à %1 du TCP</translation>
    </message>
</context>
<context>
    <name>tiller::FrameEditing</name>
    <message>
        <source>No waypoints moved with the frame.</source>
        <translation>Aucun point de passage n’a été déplacé avec lui.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints moved with the frame.</source>
        <translation>
            <numerusform>%n point de passage a bougé avec lui.</numerusform>
            <numerusform>%n points de passage ont bougé avec lui.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Waypoints out of reach: %n.</source>
        <translation>
            <numerusform>Points de passage hors de portée : %n.</numerusform>
            <numerusform>Points de passage hors de portée : %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>frame</source>
        <translation>repère</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>Apprendre « %1 »</translation>
    </message>
    <message>
        <source>The frame moves by %1 (%2, base frame).</source>
        <translation>Le repère se déplace de %1 (%2, repère de base).</translation>
    </message>
    <message>
        <source>No waypoint uses this frame.</source>
        <translation>Aucun point de passage n’utilise ce repère.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints move with the frame.</source>
        <translation>
            <numerusform>%n point de passage bouge avec lui.</numerusform>
            <numerusform>%n points de passage bougent avec lui.</numerusform>
        </translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>Retoucher « %1 » ?</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Retoucher</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>Retoucher « %1 »</translation>
    </message>
    <message>
        <source>Touched up “%1”</source>
        <translation>« %1 » retouché</translation>
    </message>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Dupliquer « %1 »</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>Supprimer « %1 » ?</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints use this frame. They keep their positions and are converted to Base.</source>
        <translation>
            <numerusform>%n point de passage utilise ce repère. Il garde sa position et est converti en Base.</numerusform>
            <numerusform>%n points de passage utilisent ce repère. Ils gardent leur position et sont convertis en Base.</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation>Supprimer le repère</translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation>Modifier la pose de « %1 »</translation>
    </message>
    <message>
        <source>The pose of “%1” was changed. %2</source>
        <translation>La pose de « %1 » a été modifiée. %2</translation>
    </message>
</context>
<context>
    <name>tiller::FrameModel</name>
    <message>
        <source>Enter a name for the frame.</source>
        <translation>Saisissez un nom pour le repère.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renommer « %1 » en « %2 »</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>Origine %1</translation>
    </message>
    <message>
        <source>Origin in Base, X Y Z, %1</source>
        <translation>Origine en Base, X Y Z, %1</translation>
    </message>
    <message>
        <source>Rotation, rad</source>
        <translation>Rotation, rad</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Rotation vector in Base, radians</source>
        <translation>Vecteur de rotation en Base, radians</translation>
    </message>
    <message>
        <source>Roll, pitch and yaw in Base</source>
        <translation>Roulis, tangage et lacet en Base</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Waypoints that move with the frame</source>
        <translation>Points de passage qui suivent le repère</translation>
    </message>
    <message>
        <source>TCP %1</source>
        <translation>TCP %1</translation>
    </message>
    <message>
        <source>Distance from the TCP, %1</source>
        <translation>Distance depuis le TCP, %1</translation>
    </message>
    <message>
        <source>“%1” is a built-in frame. Choose a different name.</source>
        <translation>« %1 » est un repère prédéfini. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>A frame named “%1” already exists. Choose a different name.</source>
        <translation>Un repère nommé « %1 » existe déjà. Choisissez un autre nom.</translation>
    </message>
</context>
<context>
    <name>tiller::FrameTable</name>
    <message>
        <source>Frames</source>
        <translation>Repères</translation>
    </message>
</context>
<context>
    <name>tiller::FrameTeacher</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Frame from three points</source>
        <translation>Repère par trois points</translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation>Annuler le repère</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>On +X</source>
        <translation>Sur +X</translation>
    </message>
    <message>
        <source>Towards +Y</source>
        <translation>Vers +Y</translation>
    </message>
    <message>
        <source>Record the origin at the TCP</source>
        <translation>Prendre l’origine ici</translation>
    </message>
    <message>
        <source>Record the point on +X at the TCP</source>
        <translation>Prendre le point sur +X ici</translation>
    </message>
    <message>
        <source>Record the point towards +Y at the TCP</source>
        <translation>Prendre le point vers +Y ici</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Prendre</translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation>Créer le repère</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the point again.</source>
        <translation>Le robot a envoyé une position non valide. Reprenez le point.</translation>
    </message>
    <message>
        <source>The point on +X is only %1 from the origin. Record it again at least %2 away. A larger distance gives more accurate axes.</source>
        <translation>Le point sur +X n’est qu’à %1 de l’origine. Reprenez-le à au moins %2. Une plus grande distance donne des axes plus précis.</translation>
    </message>
    <message>
        <source>The third point is only %1 from the origin. Record the point again at least %2 away.</source>
        <translation>Le troisième point n’est qu’à %1 de l’origine. Reprenez-le à au moins %2.</translation>
    </message>
    <message>
        <source>The three points are collinear: the third point is only %1 from the X axis. Record the point again at least %2 towards +Y.</source>
        <translation>Les trois points sont alignés : le troisième n’est qu’à %1 de l’axe X. Reprenez-le à au moins %2 vers +Y.</translation>
    </message>
    <message>
        <source>Ready: the point on +X is %1 from the origin, and the third point is %2 from the X axis.</source>
        <translation>Prêt : le point sur +X est à %1 de l’origine, le troisième à %2 de l’axe X.</translation>
    </message>
    <message>
        <source>Jog the tip to the origin of the frame and record the point (P).</source>
        <translation>Amenez la pointe à l’origine du repère et prenez le point (P).</translation>
    </message>
    <message>
        <source>Now jog to a point on +X: %1 from the origin (minimum %2).</source>
        <translation>Allez maintenant à un point sur +X : à %1 de l’origine, minimum %2.</translation>
    </message>
    <message>
        <source>Now jog towards +Y: %1 from the X axis (minimum %2).</source>
        <translation>Allez maintenant vers +Y : à %1 de l’axe X, minimum %2.</translation>
    </message>
    <message>
        <source>Record  P</source>
        <translation>Prendre  P</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Reprendre</translation>
    </message>
</context>
<context>
    <name>tiller::FramesTab</name>
    <message>
        <source>Frames</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>From TCP</source>
        <translation>Du TCP</translation>
    </message>
    <message>
        <source>Teach a frame from the TCP</source>
        <translation>Apprendre un repère au TCP</translation>
    </message>
    <message>
        <source>3 points</source>
        <translation>3 points</translation>
    </message>
    <message>
        <source>Teach a frame from three points</source>
        <translation>Apprendre un repère par trois points</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Retoucher</translation>
    </message>
    <message>
        <source>Touch up the frame</source>
        <translation>Retoucher le repère</translation>
    </message>
    <message>
        <source>More frame commands</source>
        <translation>Autres commandes de repères</translation>
    </message>
    <message>
        <source>No frames yet.
Jog the tip to a corner of the tray or table. Press “From TCP”, or press “3 points” to record the origin, +X and +Y.</source>
        <translation>Pas encore de repères.
Amenez la pointe à un coin du plateau ou de la table. Appuyez sur « Du TCP », ou sur « 3 points » pour prendre l’origine, +X et +Y.</translation>
    </message>
    <message>
        <source>new frame</source>
        <translation>nouveau repère</translation>
    </message>
    <message>
        <source>Create a frame at the TCP with the axes of the tool (Shift+T)</source>
        <translation>Créer un repère au TCP avec les axes de l’outil (Maj+T)</translation>
    </message>
    <message>
        <source>Create a frame from its origin, a point on +X and a point towards +Y (Ctrl+Shift+T)</source>
        <translation>Créer un repère avec son origine, un point sur +X et un point vers +Y (Ctrl+Maj+T)</translation>
    </message>
    <message>
        <source>Move the selected frame to the TCP (Shift+U)</source>
        <translation>Déplacer le repère sélectionné au TCP (Maj+U)</translation>
    </message>
    <message>
        <source>Select a frame to touch up.</source>
        <translation>Choisissez un repère à retoucher.</translation>
    </message>
    <message>
        <source>Teach frame from the TCP</source>
        <translation>Apprendre un repère au TCP</translation>
    </message>
    <message>
        <source>Teach frame from three points</source>
        <translation>Apprendre un repère par trois points</translation>
    </message>
    <message>
        <source>Record the next point of the frame</source>
        <translation>Prendre le point suivant du repère</translation>
    </message>
    <message>
        <source>Create frame from points</source>
        <translation>Créer le repère à partir des points</translation>
    </message>
    <message>
        <source>Cancel frame teaching</source>
        <translation>Annuler l’apprentissage du repère</translation>
    </message>
    <message>
        <source>Touch up frame from the TCP</source>
        <translation>Retoucher le repère au TCP</translation>
    </message>
    <message>
        <source>Touch up frame from three points</source>
        <translation>Retoucher le repère par trois points</translation>
    </message>
    <message>
        <source>Jog in this frame</source>
        <translation>Déplacer dans ce repère</translation>
    </message>
    <message>
        <source>Rename frame</source>
        <translation>Renommer le repère</translation>
    </message>
    <message>
        <source>Duplicate frame</source>
        <translation>Dupliquer le repère</translation>
    </message>
    <message>
        <source>Delete frame</source>
        <translation>Supprimer le repère</translation>
    </message>
    <message>
        <source>Touch up “%1” from three points</source>
        <translation>Retoucher « %1 » par trois points</translation>
    </message>
    <message>
        <source>New frame from three points</source>
        <translation>Nouveau repère par trois points</translation>
    </message>
    <message>
        <source>Touch up…</source>
        <translation>Retoucher…</translation>
    </message>
    <message>
        <source>Create frame</source>
        <translation>Créer le repère</translation>
    </message>
    <message>
        <source>Edit frame values</source>
        <translation>Modifier les valeurs du repère</translation>
    </message>
</context>
<context>
    <name>tiller::GoThroughBar</name>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Run the route</source>
        <translation>Parcourir l’itinéraire</translation>
    </message>
    <message>
        <source>Run route (hold)</source>
        <translation>Itinéraire (tenir)</translation>
    </message>
    <message>
        <source>Run route, hold</source>
        <translation>Parcourir l’itinéraire, tenir</translation>
    </message>
    <message>
        <source>Previous waypoint, hold</source>
        <translation>Point précédent, maintenir</translation>
    </message>
    <message>
        <source>Moves to the previous waypoint while the button is held</source>
        <translation>Va au point de passage précédent tant que le bouton est maintenu</translation>
    </message>
    <message>
        <source>Next waypoint, hold</source>
        <translation>Point suivant, maintenir</translation>
    </message>
    <message>
        <source>Moves to the next waypoint while the button is held, then stops</source>
        <translation>Va au point de passage suivant tant que le bouton est maintenu, et s’y arrête</translation>
    </message>
    <message>
        <source>Route waypoints</source>
        <translation>Points de l’itinéraire</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Quels points</translation>
    </message>
    <message>
        <source>From here</source>
        <translation>D’ici</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>After the last waypoint, continues with the first waypoint while the button is held</source>
        <translation>Recommence au premier point après le dernier, tant que le bouton est maintenu</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller n’a pas le contrôle. Prenez d’abord le contrôle.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Next: %1 of %2, %3</source>
        <translation>Suivant : %1 sur %2, %3</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>Done. The next press starts at the first waypoint.</source>
        <translation>Terminé. Le prochain appui commence au premier point.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n point de passage</numerusform>
            <numerusform>%n points de passage</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Moves from waypoint to waypoint while the button is held, no faster than the jog speed, and runs the actions of each waypoint. Release to pause; the next press continues to the next waypoint.</source>
        <translation>Va de point en point tant que le bouton est maintenu, sans dépasser la vitesse de déplacement, et exécute les actions de chaque point. Relâchez pour mettre en pause ; l’appui suivant continue vers le point suivant.</translation>
    </message>
    <message>
        <source>At %1: %2</source>
        <translation>À %1 : %2</translation>
    </message>
    <message>
        <source>Selects the waypoints to run, in list order</source>
        <translation>Choisit les points de l’itinéraire, dans l’ordre de la liste</translation>
    </message>
</context>
<context>
    <name>tiller::GoToButton</name>
    <message>
        <source>Go to (hold)  G</source>
        <translation>Aller à (tenir)  G</translation>
    </message>
    <message>
        <source>Go to, hold</source>
        <translation>Aller à, tenir</translation>
    </message>
    <message>
        <source>Moves the arm to the selected waypoint while the button or G is held, no faster than the jog speed</source>
        <translation>Déplace le bras au point choisi tant que le bouton ou G est maintenu, pas plus vite que la vitesse manuelle</translation>
    </message>
</context>
<context>
    <name>tiller::GripperPanel</name>
    <message>
        <source>Gripper state</source>
        <translation>État de la pince</translation>
    </message>
    <message>
        <source>Gripper opening</source>
        <translation>Ouverture de la pince</translation>
    </message>
    <message>
        <source>Gripped object</source>
        <translation>Objet saisi</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>Activer</translation>
    </message>
    <message>
        <source>Activate the gripper</source>
        <translation>Activer la pince</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open the gripper</source>
        <translation>Ouvrir la pince</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close the gripper</source>
        <translation>Fermer la pince</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bouger</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Pince</translation>
    </message>
    <message>
        <source>Gripper: open</source>
        <translation>Pince : ouvrir</translation>
    </message>
    <message>
        <source>Gripper: close</source>
        <translation>Pince : fermer</translation>
    </message>
    <message>
        <source>Gripper: move to %1</source>
        <translation>Pince : aller à %1</translation>
    </message>
    <message>
        <source>Gripper type</source>
        <translation>Type de pince</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Robotiq %1</source>
        <translation>Robotiq %1</translation>
    </message>
    <message>
        <source>One output: on = closed</source>
        <translation>Une sortie : active = fermée</translation>
    </message>
    <message>
        <source>Two outputs: open, close</source>
        <translation>Deux sorties : ouvrir, fermer</translation>
    </message>
    <message>
        <source>Closing output</source>
        <translation>Sortie de fermeture</translation>
    </message>
    <message>
        <source>Opening output</source>
        <translation>Sortie d’ouverture</translation>
    </message>
    <message>
        <source>Target opening</source>
        <translation>Ouverture cible</translation>
    </message>
    <message>
        <source>Finger speed</source>
        <translation>Vitesse des doigts</translation>
    </message>
    <message>
        <source>Finger force</source>
        <translation>Force des doigts</translation>
    </message>
    <message>
        <source>Suggested action</source>
        <translation>Action suggérée</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Ouverture</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Target opening of the fingers, 0 to %1. “Move” starts the motion.</source>
        <translation>Ouverture cible des doigts, 0 à %1. « Déplacer » démarre le mouvement.</translation>
    </message>
    <message>
        <source>Speed of the next motion. 0 % is about %1, 100 % about %2.</source>
        <translation>Vitesse du prochain mouvement. 0 % correspond à environ %1, 100 % à environ %2.</translation>
    </message>
    <message>
        <source>Force of the next grip. 0 % is about %1, 100 % about %2.</source>
        <translation>Force de la prochaine prise. 0 % correspond à environ %1, 100 % à environ %2.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Gripper set to %1</source>
        <translation>Pince réglée : %1</translation>
    </message>
    <message>
        <source>%1 (speed %2, force %3)</source>
        <translation>%1 (vitesse %2, force %3)</translation>
    </message>
    <message>
        <source>Please wait…</source>
        <translation>Veuillez patienter…</translation>
    </message>
    <message>
        <source>Select the mounted gripper. The choice is stored for this robot.</source>
        <translation>Sélectionnez la pince montée. Le choix est enregistré pour ce robot.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>activating…</source>
        <translation>en activation…</translation>
    </message>
    <message>
        <source>not active</source>
        <translation>inactive</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>en attente…</translation>
    </message>
    <message>
        <source>active</source>
        <translation>active</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>en mouvement</translation>
    </message>
    <message>
        <source>active, at standstill</source>
        <translation>active, à l’arrêt</translation>
    </message>
    <message>
        <source>unknown while moving</source>
        <translation>inconnu pendant le mouvement</translation>
    </message>
    <message>
        <source>The gripper is not available with this port offset. Use a smaller port offset.</source>
        <translation>La pince n’est pas disponible avec ce décalage de port. Utilisez un décalage plus petit.</translation>
    </message>
    <message>
        <source>Activating: the fingers open and close once.</source>
        <translation>En activation : les doigts s’ouvrent et se ferment une fois.</translation>
    </message>
    <message>
        <source>Activate the gripper first.</source>
        <translation>Activez d’abord la pince.</translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation>La pince est active.</translation>
    </message>
    <message>
        <source>The fingers open and close once and drop any gripped object. Keep your fingers clear of the gripper.</source>
        <translation>Les doigts s’ouvrent et se ferment une fois et lâchent tout objet saisi. Éloignez vos doigts de la pince.</translation>
    </message>
    <message>
        <source>Opens the gripper and releases the object.</source>
        <translation>Ouvre la pince et lâche l’objet.</translation>
    </message>
    <message>
        <source>Closes the gripper. Keep your fingers clear of the gripper.</source>
        <translation>Ferme la pince. Éloignez vos doigts.</translation>
    </message>
    <message>
        <source>The gripper did not execute the command. Check that no other program controls the gripper, then try again.</source>
        <translation>La pince n’a pas exécuté la commande. Vérifiez qu’aucun autre programme ne commande la pince, puis réessayez.</translation>
    </message>
    <message>
        <source>Gripper: stop</source>
        <translation>Pince : arrêter</translation>
    </message>
    <message>
        <source>Move the fingers to the target opening</source>
        <translation>Amener les doigts à l’ouverture cible</translation>
    </message>
    <message>
        <source>Closed by</source>
        <translation>Ferme</translation>
    </message>
    <message>
        <source>Opened by</source>
        <translation>Ouvre</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Connect to a robot first. Tiller stores the gripper selection for each robot.</source>
        <translation>Connectez-vous d’abord à un robot. Tiller enregistre le choix de la pince pour chaque robot.</translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation>Le robot n’envoie pas de données. Attendez des données ou reconnectez-vous.</translation>
    </message>
    <message>
        <source>external grip</source>
        <translation>prise extérieure</translation>
    </message>
    <message>
        <source>internal grip</source>
        <translation>prise intérieure</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Stopping the arm does not open the gripper.</source>
        <translation>L’arrêt du bras n’ouvre pas la pince.</translation>
    </message>
    <message>
        <source>Moves the fingers to the target opening.</source>
        <translation>Déplace les doigts à l’ouverture cible.</translation>
    </message>
    <message>
        <source>Speed or force is out of range. Enter a value from 0 to 100 %.</source>
        <translation>La vitesse ou la force est hors plage. Saisissez 0 à 100 %.</translation>
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
        <translation>MODE DU ROBOT</translation>
    </message>
    <message>
        <source>SAFETY</source>
        <translation>SÉCURITÉ</translation>
    </message>
    <message>
        <source>CONTROL</source>
        <translation>CONTRÔLE</translation>
    </message>
    <message>
        <source>LINK</source>
        <translation>LIEN</translation>
    </message>
    <message>
        <source>LAST STOP</source>
        <translation>DERNIER ARRÊT</translation>
    </message>
    <message>
        <source>Robot state</source>
        <translation>État du robot</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Étape suivante</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>SANS DONNÉES</translation>
    </message>
    <message>
        <source>LAST STOP · no key check</source>
        <translation>DERNIER ARRÊT · sans contrôle</translation>
    </message>
    <message>
        <source>%1 ms · %2</source>
        <translation>%1 ms · %2</translation>
    </message>
    <message>
        <source>Measured from the stop command to standstill. Cause: %1</source>
        <translation>Mesuré de la commande d’arrêt à l’arrêt complet. Cause : %1</translation>
    </message>
    <message>
        <source>No stop measured yet</source>
        <translation>Pas encore d’arrêt mesuré</translation>
    </message>
    <message>
        <source>▲ Speed cap raised to %1</source>
        <translation>▲ Plafond de vitesse relevé à %1</translation>
    </message>
    <message>
        <source>The arm may move faster than %1. Lower the speed cap in Settings. The cap is reset when Tiller is closed.</source>
        <translation>Le bras peut aller plus vite que %1. Abaissez le plafond de vitesse dans les réglages. Il est réinitialisé à la fermeture de Tiller.</translation>
    </message>
    <message>
        <source>MONITOR ONLY</source>
        <translation>SURVEILLANCE SEULE</translation>
    </message>
    <message>
        <source>Cause: %1 (%2)</source>
        <translation>Cause : %1 (%2)</translation>
    </message>
    <message>
        <source>The program was stopped on the robot, so the stop could not be measured.</source>
        <translation>Le programme a été arrêté sur le robot, l’arrêt n’a donc pas pu être mesuré.</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Non mesuré</translation>
    </message>
    <message>
        <source>The robot stopped sending data while the arm was moving, so the stop could not be measured.</source>
        <translation>Le robot a cessé d’envoyer des données pendant le mouvement du bras : l’arrêt n’a pas pu être mesuré.</translation>
    </message>
    <message>
        <source>Not stopped</source>
        <translation>Non arrêté</translation>
    </message>
</context>
<context>
    <name>tiller::HoldRules</name>
    <message>
        <source>The window was not active. Press again.</source>
        <translation>La fenêtre n’était pas active. Appuyez de nouveau.</translation>
    </message>
    <message>
        <source>Click in the window first.</source>
        <translation>Cliquez d’abord dans la fenêtre.</translation>
    </message>
    <message>
        <source>A dialog or a menu is open. Close it first.</source>
        <translation>Un dialogue ou un menu est ouvert. Fermez-le d’abord.</translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation>Un autre bouton ou une autre touche est déjà maintenu. Relâchez-le d’abord.</translation>
    </message>
    <message>
        <source>The display server does not respond, so Tiller cannot detect the release of a button or key. Release the button or key, then try again.</source>
        <translation>Le serveur d’affichage ne répond pas : le relâchement d’un bouton ou d’une touche ne peut pas être détecté. Relâchez-le et réessayez.</translation>
    </message>
</context>
<context>
    <name>tiller::HoldToRunButton</name>
    <message>
        <source>hold</source>
        <translation>tenir</translation>
    </message>
    <message>
        <source>Hold this button. The arm moves only while the button is held.</source>
        <translation>Maintenez ce bouton : le bras ne bouge que tant qu’il est maintenu.</translation>
    </message>
</context>
<context>
    <name>tiller::ImportReport</name>
    <message>
        <source>Steps: %1. Kept as URScript text: %2. Not imported: %3. New waypoints: %4.</source>
        <translation>Étapes : %1. Conservées comme texte URScript : %2. Non importées : %3. Nouveaux points de passage : %4.</translation>
    </message>
    <message>
        <source>Imported program</source>
        <translation>Programme importé</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Node or statement</source>
        <translation>Nœud ou instruction</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Import report for “%1”</source>
        <translation>Rapport d’importation de « %1 »</translation>
    </message>
</context>
<context>
    <name>tiller::IncidentWatch</name>
    <message>
        <source>protective stop</source>
        <translation>arrêt de protection</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>arrêt d’urgence</translation>
    </message>
    <message>
        <source>safety violation</source>
        <translation>violation de sécurité</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>défaut</translation>
    </message>
    <message>
        <source>The incident (%1) could not be recorded.</source>
        <translation>L’incident (%1) n’a pu être enregistré.</translation>
    </message>
    <message>
        <source>Incident recorded: %1</source>
        <translation>Incident enregistré : %1</translation>
    </message>
    <message>
        <source>The recording %2 starts %1 s before the stop. Double-click this entry to open the recording.</source>
        <translation>L’enregistrement %2 commence %1 s avant l’arrêt. Double-cliquez sur cette entrée pour l’ouvrir.</translation>
    </message>
</context>
<context>
    <name>tiller::IoChannel</name>
    <message>
        <source>no data</source>
        <translation>sans données</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivée</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activée</translation>
    </message>
    <message>
        <source>pending…</source>
        <translation>en attente…</translation>
    </message>
    <message>
        <source>%1, outdated</source>
        <translation>%1, périmé</translation>
    </message>
    <message>
        <source>Pulse</source>
        <translation>Impulsion</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Name of %1</source>
        <translation>Nom de %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>
The output cannot be switched while the robot is not sending data.</source>
        <translation>
La sortie ne peut pas être commutée tant que le robot n’envoie pas de données.</translation>
    </message>
    <message>
        <source>
Click to switch the output %1. Press P to pulse it. Right-click to pulse or rename it.</source>
        <translation>
Cliquez pour commuter : %1. P pour une impulsion. Clic droit pour une impulsion ou renommer.</translation>
    </message>
    <message>
        <source>
Right-click or press F2 to rename the input.</source>
        <translation>
Clic droit ou F2 pour renommer.</translation>
    </message>
</context>
<context>
    <name>tiller::IoPages</name>
    <message>
        <source>Signals</source>
        <translation>Signaux</translation>
    </message>
    <message>
        <source>Gripper</source>
        <translation>Pince</translation>
    </message>
    <message>
        <source>I/O page</source>
        <translation>Page d’E/S</translation>
    </message>
</context>
<context>
    <name>tiller::IoTab</name>
    <message>
        <source>Inputs and outputs</source>
        <translation>Entrées et sorties</translation>
    </message>
    <message>
        <source>Search inputs and outputs</source>
        <translation>Chercher des entrées et sorties</translation>
    </message>
    <message>
        <source>Search by terminal or name</source>
        <translation>Chercher par borne ou nom</translation>
    </message>
    <message>
        <source>Digital outputs</source>
        <translation>Sorties numériques</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>Entrées numériques</translation>
    </message>
    <message>
        <source>Configurable outputs</source>
        <translation>Sorties configurables</translation>
    </message>
    <message>
        <source>Configurable inputs</source>
        <translation>Entrées configurables</translation>
    </message>
    <message>
        <source>Tool outputs</source>
        <translation>Sorties de l’outil</translation>
    </message>
    <message>
        <source>Tool inputs</source>
        <translation>Entrées de l’outil</translation>
    </message>
    <message>
        <source>Press the Tab key to select a row on the I/O tab first.</source>
        <translation>Sélectionnez d’abord une ligne de l’onglet E/S avec la touche Tab.</translation>
    </message>
    <message>
        <source>The robot did not confirm %1</source>
        <translation>Le robot n’a pas confirmé %1</translation>
    </message>
    <message>
        <source>Analog</source>
        <translation>Analogiques</translation>
    </message>
    <message>
        <source>General purpose registers</source>
        <translation>Registres généraux</translation>
    </message>
    <message>
        <source>Replay is active. Press “Back to live” first.</source>
        <translation>La relecture est active. Appuyez d’abord sur « Revenir au direct ».</translation>
    </message>
    <message>
        <source>%1 cannot be pulsed now</source>
        <translation>Impulsion de %1 impossible maintenant</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillé</translation>
    </message>
    <message>
        <source>controlled by another program</source>
        <translation>commandé par un autre programme</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivée</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activée</translation>
    </message>
    <message>
        <source>Another program or the installation may control the output. Check both, then switch the output again.</source>
        <translation>Un autre programme ou l’installation la commande peut-être. Vérifiez les deux, puis commutez à nouveau la sortie.</translation>
    </message>
    <message>
        <source>The robot is not sending data. Wait for data, or reconnect.</source>
        <translation>Le robot n’envoie pas de données. Attendez des données ou reconnectez-vous.</translation>
    </message>
</context>
<context>
    <name>tiller::JogColumn</name>
    <message>
        <source>Jog</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>Hold to move</source>
        <translation>Tenir pour bouger</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulations</translation>
    </message>
    <message>
        <source>Pose or joints</source>
        <translation>Pose ou articulations</translation>
    </message>
    <message>
        <source>There is no path to retrace. Jog the arm first.</source>
        <translation>Aucune trajectoire à reparcourir. Déplacez d’abord le bras.</translation>
    </message>
    <message>
        <source>release and press again</source>
        <translation>relâchez et appuyez de nouveau</translation>
    </message>
    <message>
        <source>Freedrive</source>
        <translation>Freedrive</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Moves all joints to the home position while the button is held</source>
        <translation>Amène toutes les articulations à la position d’origine tant qu’il est maintenu</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Aligner</translation>
    </message>
    <message>
        <source>Aligns the tool with the nearest axis of the selected frame while the button is held</source>
        <translation>Aligne l’outil sur l’axe le plus proche du repère choisi tant qu’il est maintenu</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Retraces the last motion while the button is held</source>
        <translation>Refait le dernier mouvement en sens inverse, tant que maintenu</translation>
    </message>
    <message>
        <source>home</source>
        <translation>à l’origine</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>aligné</translation>
    </message>
    <message>
        <source>Ends in %1 s</source>
        <translation>Finit dans %1 s</translation>
    </message>
    <message>
        <source>Another button or key is already held. Release it first.</source>
        <translation>Un autre bouton ou une autre touche est déjà maintenu. Relâchez-le d’abord.</translation>
    </message>
    <message>
        <source>Last stop: %1, standstill after %2 ms, %3</source>
        <translation>Dernier arrêt : %1, immobile après %2 ms, %3</translation>
    </message>
    <message>
        <source>Move the arm by hand while this button is held: %1. Right-click to select axes.</source>
        <translation>Déplacez le bras à la main tant que ce bouton est maintenu : %1. Clic droit pour choisir les axes.</translation>
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
        <translation>Vérifier la charge utile avant Freedrive (réinitialisé à la reconnexion)</translation>
    </message>
    <message>
        <source>Last stop: not measured (data lost)</source>
        <translation>Dernier arrêt : non mesuré (données perdues)</translation>
    </message>
    <message>
        <source>Press for one step</source>
        <translation>Appui : un pas</translation>
    </message>
    <message>
        <source>Last stop: %1 (%2)</source>
        <translation>Dernier arrêt : %1 (%2)</translation>
    </message>
</context>
<context>
    <name>tiller::JogKey</name>
    <message>
        <source>%1 left in this direction</source>
        <translation>reste %1 dans cette direction</translation>
    </message>
</context>
<context>
    <name>tiller::JogPad</name>
    <message>
        <source>Jog buttons</source>
        <translation>Boutons de déplacement</translation>
    </message>
    <message>
        <source>Jog %1</source>
        <translation>Aller en %1</translation>
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
        <translation>Outil</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Tenir</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Moves while the button is held</source>
        <translation>Bouge tant que le bouton est maintenu</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Rotates while the button is held</source>
        <translation>Tourne tant que le bouton est maintenu</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>View axes: X right, Y away from you, Z up</source>
        <translation>Axes de la vue : X à droite, Y en s’éloignant de vous, Z vers le haut</translation>
    </message>
    <message>
        <source>Requires the 3D view</source>
        <translation>Demande la vue 3D</translation>
    </message>
    <message>
        <source>No frame taught yet. Teach a frame on the Frames tab.</source>
        <translation>Aucun repère appris. Apprenez-en un dans l’onglet Repères.</translation>
    </message>
    <message>
        <source>Moves by %1 per press.</source>
        <translation>Déplace de %1 par appui.</translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press.</source>
        <translation>Tourne l’outil ou l’articulation de %1 par appui.</translation>
    </message>
    <message>
        <source>≤ %1</source>
        <translation>≤ %1</translation>
    </message>
    <message>
        <source>Moves slowly while the button is held, until the contact force reaches %1 N. Click again to select a different step.</source>
        <translation>Déplace lentement tant que le bouton est maintenu, jusqu’à une force de contact de %1 N. Cliquez de nouveau pour choisir un autre pas.</translation>
    </message>
    <message>
        <source>Moves by %1 per press. Click again to select a different step.</source>
        <translation>Déplace de %1 par appui. Cliquez de nouveau pour choisir un autre pas.</translation>
    </message>
    <message>
        <source>Rotates the tool or joint by %1 per press. Click again to select a different angle.</source>
        <translation>Tourne l’outil ou l’articulation de %1 par appui. Cliquez de nouveau pour choisir un autre angle.</translation>
    </message>
    <message>
        <source>%1 · rotation %2 · joints %3 · Ctrl × 0.1, Shift × 3</source>
        <translation>%1 · rotations %2 · articulations %3 · Ctrl × 0,1, Maj × 3</translation>
    </message>
    <message>
        <source>Other angle…</source>
        <translation>Autre angle…</translation>
    </message>
    <message>
        <source>Other step…</source>
        <translation>Autre pas…</translation>
    </message>
    <message>
        <source>Until contact, %1 N</source>
        <translation>Jusqu’au contact, %1 N</translation>
    </message>
    <message>
        <source>Other contact force…</source>
        <translation>Autre force de contact…</translation>
    </message>
    <message>
        <source>Other speed…</source>
        <translation>Autre vitesse…</translation>
    </message>
    <message>
        <source>Step in %1</source>
        <translation>Pas en %1</translation>
    </message>
    <message>
        <source>Angle in degrees</source>
        <translation>Angle en degrés</translation>
    </message>
    <message>
        <source>TCP speed in %1</source>
        <translation>Vitesse du TCP en %1</translation>
    </message>
    <message>
        <source>Contact force that ends the motion, in N</source>
        <translation>Force de contact en N qui termine le mouvement</translation>
    </message>
    <message>
        <source>The step continues after the button is released. Space, Esc and STOP end the step.</source>
        <translation>Le pas continue après le relâchement. Espace, Échap et STOP l&apos;arrêtent.</translation>
    </message>
    <message>
        <source>Hold the button until the step is complete.</source>
        <translation>Maintenez le bouton jusqu&apos;à la fin du pas.</translation>
    </message>
</context>
<context>
    <name>tiller::JointRow</name>
    <message>
        <source>%1 minus</source>
        <translation>%1 moins</translation>
    </message>
    <message>
        <source>%1 plus</source>
        <translation>%1 plus</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>tiller::JointRows</name>
    <message>
        <source>Joints</source>
        <translation>Articulations</translation>
    </message>
</context>
<context>
    <name>tiller::KeyboardJog</name>
    <message>
        <source>Keyboard jogging is armed</source>
        <translation>Le déplacement au clavier est armé</translation>
    </message>
</context>
<context>
    <name>tiller::LimiterLine</name>
    <message>
        <source>Limiter</source>
        <translation>Limiteur</translation>
    </message>
</context>
<context>
    <name>tiller::LimitsDialog</name>
    <message>
        <source>Limits of the value axis</source>
        <translation>Limites de l’axe des valeurs</translation>
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
        <translation>%1, minimum</translation>
    </message>
    <message>
        <source>%1, maximum</source>
        <translation>%1, maximum</translation>
    </message>
    <message>
        <source>%1: enter two numbers. The minimum must be less than the maximum.</source>
        <translation>%1 : saisissez deux nombres. Le minimum doit être inférieur au maximum.</translation>
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
        <translation>▲ Avertissement</translation>
    </message>
    <message>
        <source>⬣ Error</source>
        <translation>⬣ Erreur</translation>
    </message>
    <message>
        <source>Tiller</source>
        <translation>Tiller</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open the recording of this incident at the time of the stop</source>
        <translation>Ouvrir l’enregistrement de cet incident au moment de l’arrêt</translation>
    </message>
    <message>
        <source>Open the recording at this time</source>
        <translation>Ouvrir l’enregistrement à ce moment</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>%1 · Origin: %2</source>
        <translation>%1 · Origine : %2</translation>
    </message>
    <message>
        <source>%1 times between %2 and %3 · Origin: %4</source>
        <translation>%1 fois de %2 à %3 · Origine : %4</translation>
    </message>
    <message>
        <source>(×%1, last at %2) %3</source>
        <translation>(×%1, dernière fois %2) %3</translation>
    </message>
</context>
<context>
    <name>tiller::LogTab</name>
    <message>
        <source>All</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Alertes</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Erreurs</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Minimum severity</source>
        <translation>Gravité minimale</translation>
    </message>
    <message>
        <source>Filter the log by text</source>
        <translation>Filtrer le journal par texte</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the selected entries, or all visible entries (Ctrl+C)</source>
        <translation>Copier les entrées sélectionnées, ou toutes les entrées visibles (Ctrl+C)</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Write the visible entries to a file</source>
        <translation>Écrire les entrées visibles dans un fichier</translation>
    </message>
    <message>
        <source>Details of the selected entry</source>
        <translation>Détails de l’entrée sélectionnée</translation>
    </message>
    <message>
        <source>Export the log</source>
        <translation>Exporter le journal</translation>
    </message>
    <message>
        <source>Text file (*.txt)</source>
        <translation>Fichier texte (*.txt)</translation>
    </message>
    <message>
        <source>Log written to %1</source>
        <translation>Journal écrit dans %1</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Ouvrir l’enregistrement</translation>
    </message>
    <message>
        <source>Open the recording of the selected entry</source>
        <translation>Ouvrir l’enregistrement de l’entrée sélectionnée</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Note : %1</translation>
    </message>
</context>
<context>
    <name>tiller::MetadataDialog</name>
    <message>
        <source>Ask before each recording</source>
        <translation>Demander avant chaque enregistrement</translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation>Métadonnées des enregistrements</translation>
    </message>
    <message>
        <source>Tiller stores the fields with a value in each recording. The names and values are kept for the next recording.</source>
        <translation>Tiller stocke dans chaque enregistrement les champs qui ont une valeur. Les noms et les valeurs sont conservés pour l’enregistrement suivant.</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>Métadonnées</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Add field</source>
        <translation>Ajouter un champ</translation>
    </message>
    <message>
        <source>Remove field</source>
        <translation>Supprimer le champ</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>The value “%1” has no name. Enter a name.</source>
        <translation>La valeur « %1 » n’a pas de nom. Saisissez un nom.</translation>
    </message>
    <message>
        <source>The name “%1” is not valid. Use letters, digits, spaces and _ - . (at most 60).</source>
        <translation>Le nom « %1 » n’est pas valide. Utilisez des lettres, des chiffres, des espaces et _ - . (60 au plus).</translation>
    </message>
    <message>
        <source>Tiller stores “%1” itself. Choose another name.</source>
        <translation>Tiller stocke lui-même « %1 ». Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>The name “%1” occurs twice. Choose another name.</source>
        <translation>Le nom « %1 » apparaît deux fois. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>The value of “%1” must be one line of at most %2 characters.</source>
        <translation>La valeur de « %1 » doit être une ligne de %2 caractères au plus.</translation>
    </message>
    <message>
        <source>Remove fields: at most %1 fields are possible.</source>
        <translation>Supprimez des champs : %1 au plus sont possibles.</translation>
    </message>
</context>
<context>
    <name>tiller::MoveWords</name>
    <message>
        <source>%1 collides with %2 after %3 of the path</source>
        <translation>%1 entre en collision avec %2 après %3 de la trajectoire</translation>
    </message>
    <message>
        <source>The move enters the wrist singularity after %1 of the path</source>
        <translation>La trajectoire entre dans la singularité du poignet après %1 de sa longueur</translation>
    </message>
    <message>
        <source>The move slows down near the wrist singularity at %1 of the path</source>
        <translation>Lent près de la singularité du poignet à %1 de la trajectoire</translation>
    </message>
    <message>
        <source>The move enters the elbow singularity after %1 of the path</source>
        <translation>La trajectoire entre dans la singularité du coude après %1 de sa longueur</translation>
    </message>
    <message>
        <source>The move slows down near the elbow singularity at %1 of the path</source>
        <translation>Lent près de la singularité du coude à %1 de la trajectoire</translation>
    </message>
    <message>
        <source>The move enters the shoulder singularity after %1 of the path</source>
        <translation>La trajectoire entre dans la singularité de l’épaule après %1 de sa longueur</translation>
    </message>
    <message>
        <source>The move slows down near the shoulder singularity at %1 of the path</source>
        <translation>Lent près de la singularité de l’épaule à %1 de la trajectoire</translation>
    </message>
    <message>
        <source>A joint would have to jump after %1 of the path</source>
        <translation>Une articulation devrait sauter après %1 de la trajectoire</translation>
    </message>
    <message>
        <source>%1 exceeds its limit after %2 of the path</source>
        <translation>%1 dépasse sa course après %2 de la trajectoire</translation>
    </message>
    <message>
        <source>The move leaves the reach of the arm after %1 of the path</source>
        <translation>La trajectoire sort de la portée du bras après %1 de sa longueur</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Épaule</translation>
    </message>
    <message>
        <source>Upper arm</source>
        <translation>Bras supérieur</translation>
    </message>
    <message>
        <source>Forearm</source>
        <translation>Avant-bras</translation>
    </message>
    <message>
        <source>Wrist 1</source>
        <translation>Poignet 1</translation>
    </message>
    <message>
        <source>Wrist 2</source>
        <translation>Poignet 2</translation>
    </message>
    <message>
        <source>Wrist 3</source>
        <translation>Poignet 3</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>%1 is in contact with %2, and the move reduces the distance</source>
        <translation>%1 est en contact avec %2, et le mouvement réduit la distance</translation>
    </message>
    <message>
        <source>%1 is only %2 from %3, and the move reduces the distance</source>
        <translation>%1 n’est qu’à %2 de %3, et le mouvement réduit la distance</translation>
    </message>
    <message>
        <source>%1 comes within %2 of %3 after %4 of the path</source>
        <translation>%1 s’approche à moins de %2 de %3 après %4 de la trajectoire</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>le sol</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>« %1 »</translation>
    </message>
    <message>
        <source>The position of “%1” is unknown because its frame is not in the project. Enter its position, turn off its collision check, or delete it on the Cell page</source>
        <translation>La position de « %1 » est inconnue car son repère n’est pas dans le projet. Saisissez la position, désactivez la vérification des collisions de l’objet ou supprimez-le sur la page Cellule</translation>
    </message>
</context>
<context>
    <name>tiller::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>Avis</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Écarter</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Notice action</source>
        <translation>Action de l’avis</translation>
    </message>
    <message>
        <source>Second notice action</source>
        <translation>Seconde action de l’avis</translation>
    </message>
</context>
<context>
    <name>tiller::OpenTableDialog</name>
    <message>
        <source>Open table</source>
        <translation>Ouvrir un tableau</translation>
    </message>
    <message>
        <source>Tiller cannot determine the times of the rows in %1. Select how to read the table.</source>
        <translation>Tiller ne peut pas déterminer les temps des lignes de %1. Choisissez comment lire le tableau.</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>Premières lignes du fichier</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>Colonne de temps</translation>
    </message>
    <message>
        <source>No time column</source>
        <translation>Aucune colonne de temps</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>Unité de temps</translation>
    </message>
    <message>
        <source>Rows per second</source>
        <translation>Lignes par seconde</translation>
    </message>
    <message>
        <source>Column separator</source>
        <translation>Séparateur de colonnes</translation>
    </message>
    <message>
        <source>Comma</source>
        <translation>Virgule</translation>
    </message>
    <message>
        <source>Semicolon</source>
        <translation>Point-virgule</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tabulation</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Decimal separator</source>
        <translation>Séparateur décimal</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>First row</source>
        <translation>Première ligne</translation>
    </message>
    <message>
        <source>Column names</source>
        <translation>Noms de colonnes</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Données</translation>
    </message>
    <message>
        <source>Reason: %1</source>
        <translation>Raison : %1</translation>
    </message>
    <message>
        <source>Detect automatically</source>
        <translation>Détecter automatiquement</translation>
    </message>
</context>
<context>
    <name>tiller::PartModel</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
</context>
<context>
    <name>tiller::PartPage</name>
    <message>
        <source>More</source>
        <translation>Plus</translation>
    </message>
</context>
<context>
    <name>tiller::PathControls</name>
    <message>
        <source>Path tolerance</source>
        <translation>Tolérance de trajectoire</translation>
    </message>
    <message>
        <source>Record path</source>
        <translation>Enregistrer la trajectoire</translation>
    </message>
    <message>
        <source>Export path as CSV…</source>
        <translation>Exporter la trajectoire en CSV…</translation>
    </message>
    <message>
        <source>Import path from CSV…</source>
        <translation>Importer une trajectoire CSV…</translation>
    </message>
    <message>
        <source>The path recorded so far is kept.</source>
        <translation>La trajectoire enregistrée jusqu’ici est conservée.</translation>
    </message>
    <message>
        <source>Stop recording path</source>
        <translation>Arrêter l’enregistrement de la trajectoire</translation>
    </message>
    <message>
        <source>Simplifying the path…</source>
        <translation>Simplification de la trajectoire…</translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation>Aucune trajectoire ne peut être enregistrée, car le robot n’envoie pas de données. Attendez les données ou connectez un robot.</translation>
    </message>
    <message>
        <source>Stops recording and stores the path as waypoints</source>
        <translation>Arrête l’enregistrement et garde la trajectoire comme points de passage</translation>
    </message>
    <message>
        <source>Records the path of the arm during Freedrive or jogging and stores it as waypoints. Press again to stop. Recording does not move the robot.</source>
        <translation>Enregistre la trajectoire du bras en Freedrive ou en déplacement manuel et la garde comme points de passage. Appuyez de nouveau pour arrêter. Le robot ne bouge pas.</translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation>Sélectionnez au moins deux points de la trajectoire.</translation>
    </message>
    <message>
        <source>Export path</source>
        <translation>Exporter la trajectoire</translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation>Fichier CSV (*.csv)</translation>
    </message>
    <message>
        <source>The path was not exported.</source>
        <translation>La trajectoire n’a pas été exportée.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints exported as a path to %1</source>
        <translation>
            <numerusform>%n point écrit comme trajectoire dans %1</numerusform>
            <numerusform>%n points écrits comme trajectoire dans %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Import path</source>
        <translation>Importer une trajectoire</translation>
    </message>
    <message>
        <source>○ Path</source>
        <translation>○ Trajet</translation>
    </message>
    <message>
        <source>The path of the arm is being recorded. To stop recording, press “● REC” or select “Stop recording path” in the menu.</source>
        <translation>La trajectoire du bras est enregistrée. Pour terminer, appuyez sur « ● REC » ou sélectionnez la même commande dans le menu.</translation>
    </message>
    <message>
        <source>Path recording stopped because the maximum duration of ten minutes was reached.</source>
        <translation>Enregistrement de la trajectoire arrêté : durée maximale de dix minutes atteinte.</translation>
    </message>
    <message>
        <source>Path recording stopped because the robot stopped sending data or was restarted.</source>
        <translation>Enregistrement de la trajectoire arrêté : le robot n’envoie plus de données ou a redémarré.</translation>
    </message>
</context>
<context>
    <name>tiller::PathRecorder</name>
    <message>
        <source>%1 has no column “%2”. The columns “timestamp” and “actual_q_0” to “actual_q_5” are required.</source>
        <translation>%1 n’a pas de colonne « %2 ». Les colonnes timestamp et actual_q_0 à actual_q_5 sont nécessaires.</translation>
    </message>
    <message>
        <source>No path can be recorded because the robot is not sending data. Wait for data, or connect a robot.</source>
        <translation>Aucune trajectoire ne peut être enregistrée, car le robot n’envoie pas de données. Attendez les données ou connectez un robot.</translation>
    </message>
    <message>
        <source>Import refused because another path is being recorded or processed. Stop the recording, or wait, and try again.</source>
        <translation>Importation refusée, car une autre trajectoire est en cours d’enregistrement ou de traitement. Arrêtez l’enregistrement ou attendez, puis réessayez.</translation>
    </message>
    <message>
        <source>The path could not be imported.</source>
        <translation>La trajectoire n’a pas pu être importée.</translation>
    </message>
    <message>
        <source>path %1</source>
        <translation>trajectoire %1</translation>
    </message>
    <message>
        <source>The arm did not move. No path was stored.</source>
        <translation>Le bras n’a pas bougé : aucune trajectoire n’a été gardée.</translation>
    </message>
    <message>
        <source>Record “%1”</source>
        <translation>Enregistrer « %1 »</translation>
    </message>
    <message>
        <source>“%1”: %2 s, %3 waypoints. Maximum deviation from the recording: %4 and %5.</source>
        <translation>« %1 » : %2 s, %3 points de passage. Écart maximal par rapport à l’enregistrement : %4 et %5.</translation>
    </message>
    <message numerus="yes">
        <source>%n packets were lost.</source>
        <translation>
            <numerusform>%n paquet a été perdu.</numerusform>
            <numerusform>%n paquets ont été perdus.</numerusform>
        </translation>
    </message>
    <message>
        <source>Select at least two waypoints of the path.</source>
        <translation>Sélectionnez au moins deux points de la trajectoire.</translation>
    </message>
    <message>
        <source>“%1” is out of reach. Touch up or delete the waypoint.</source>
        <translation>« %1 » est hors de portée. Retouchez-le ou retirez-le.</translation>
    </message>
</context>
<context>
    <name>tiller::PatternDialog</name>
    <message>
        <source>pattern</source>
        <translation>motif</translation>
    </message>
    <message>
        <source>Pattern from three corners</source>
        <translation>Motif par trois coins</translation>
    </message>
    <message>
        <source>Pattern “%1”</source>
        <translation>Motif « %1 »</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>First cell</source>
        <translation>Premier emplacement</translation>
    </message>
    <message>
        <source>End of the first row</source>
        <translation>Fin de la première rangée</translation>
    </message>
    <message>
        <source>Start of the last row</source>
        <translation>Début de la dernière rangée</translation>
    </message>
    <message>
        <source>Select a waypoint</source>
        <translation>choisir un point de passage</translation>
    </message>
    <message>
        <source>As taught</source>
        <translation>comme appris</translation>
    </message>
    <message>
        <source>Cells per row</source>
        <translation>Emplacements par rangée</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Rangées</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Couches</translation>
    </message>
    <message>
        <source>Layer height</source>
        <translation>Hauteur de couche</translation>
    </message>
    <message>
        <source>Distance from one layer to the next, measured opposite to the tool direction.</source>
        <translation>Distance entre les couches, opposée à la direction de l’outil.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Row by row</source>
        <translation>Rangée par rangée</translation>
    </message>
    <message>
        <source>Zigzag</source>
        <translation>Méandre</translation>
    </message>
    <message>
        <source>Create pattern</source>
        <translation>Créer le motif</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Enter a name for the pattern.</source>
        <translation>Saisissez un nom pour le motif.</translation>
    </message>
    <message>
        <source>Teach the corners first, then select a waypoint for each corner.</source>
        <translation>Apprenez d’abord les coins du motif, puis sélectionnez un point de passage pour chacun.</translation>
    </message>
    <message>
        <source>The layer height must not be 0. Enter a layer height.</source>
        <translation>La hauteur de couche ne doit pas être 0. Saisissez une hauteur de couche.</translation>
    </message>
    <message>
        <source>The pattern has %1 cells; the maximum is %2. Enter fewer cells per row, rows or layers.</source>
        <translation>Le motif a %1 emplacements ; le maximum est %2. Saisissez moins d’emplacements par rangée, de rangées ou de couches.</translation>
    </message>
    <message>
        <source>All cells are excluded. Click a cell to include it.</source>
        <translation>Tous les emplacements sont exclus. Cliquez sur un emplacement pour l’inclure.</translation>
    </message>
    <message>
        <source>The three corners are on a straight line. Select a different waypoint for one of them.</source>
        <translation>Les trois coins sont alignés. Sélectionnez un autre point de passage pour l&apos;un d&apos;eux.</translation>
    </message>
    <message>
        <source>Two corners are at the same position. Select a different waypoint for one of them.</source>
        <translation>Deux coins sont à la même position. Sélectionnez un autre point pour l’un d’eux.</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints</source>
        <translation>
            <numerusform>%n point de passage</numerusform>
            <numerusform>%n points de passage</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, all within reach.</source>
        <translation>%1, tous à portée.</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n out of reach and marked.</source>
        <translation>
            <numerusform>%1, %n hors de portée et marqué.</numerusform>
            <numerusform>%1, %n hors de portée et marqués.</numerusform>
        </translation>
    </message>
    <message>
        <source>A pattern with this name already exists. Choose a different name.</source>
        <translation>Un motif de ce nom existe déjà. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>The layer height is not a number or is out of range. Enter a different layer height.</source>
        <translation>La hauteur de couche n’est pas un nombre ou est hors de la plage. Saisissez une autre hauteur de couche.</translation>
    </message>
</context>
<context>
    <name>tiller::PatternGrid</name>
    <message>
        <source>Pattern cells</source>
        <translation>Emplacements du motif</translation>
    </message>
    <message>
        <source>Click a cell to exclude or include it. The first cell is at the lower left.</source>
        <translation>Cliquez sur un emplacement pour l’exclure ou l’inclure. Le premier emplacement est en bas à gauche.</translation>
    </message>
    <message>
        <source>Row %1, column %2</source>
        <translation>Rangée %1, colonne %2</translation>
    </message>
</context>
<context>
    <name>tiller::PayloadEstimator</name>
    <message>
        <source>Next pose (hold)</source>
        <translation>Pose suivante (tenir)</translation>
    </message>
    <message>
        <source>Keep payload</source>
        <translation>Garder la charge utile</translation>
    </message>
    <message>
        <source>Measure payload</source>
        <translation>Mesurer la charge utile</translation>
    </message>
    <message>
        <source>Measure the payload in several poses</source>
        <translation>Mesurer la charge utile dans plusieurs poses</translation>
    </message>
    <message>
        <source>Next pose, hold</source>
        <translation>Pose suivante, tenir</translation>
    </message>
    <message>
        <source>Rotates the wrist to the next pose while the button is held, no faster than the jog speed. Make sure that the tool has space to rotate.</source>
        <translation>Tourne le poignet vers la pose suivante tant que le bouton est maintenu, sans dépasser la vitesse de déplacement. Assurez-vous que l’outil a la place de tourner.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancel payload measurement</source>
        <translation>Annuler la mesure de la charge utile</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller n’a pas le contrôle. Prenez d’abord le contrôle.</translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and record the pose again.</source>
        <translation>Le bras a bougé. Attendez l’arrêt, gardez l’outil sans contact et reprenez la pose.</translation>
    </message>
    <message>
        <source>The robot is not sending force data. Enter the mass and the centre of gravity instead.</source>
        <translation>Le robot n’envoie pas de données de force. Saisissez plutôt la masse et le centre de gravité.</translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation>Mesure de la charge utile… Gardez l’outil sans contact.</translation>
    </message>
    <message>
        <source>%1 kg, centre of gravity at %2 from the flange. The poses agree within %3 and %4.</source>
        <translation>%1 kg, centre de gravité à %2 de la bride. Les poses concordent à %3 et %4 près.</translation>
    </message>
    <message>
        <source>%1 The accuracy is low: pose %2 deviates most. Remove this pose and record another pose.</source>
        <translation>%1 La précision est faible : la pose %2 s’écarte le plus. Retirez-la et prenez-en une autre.</translation>
    </message>
    <message>
        <source>The load of %1 kg is too light to measure the centre of gravity. Enter the payload manually.</source>
        <translation>La charge de %1 kg est trop légère pour mesurer le centre de gravité. Saisissez la charge utile manuellement.</translation>
    </message>
    <message>
        <source>Wait for standstill, keep the tool free of contact, and record the pose. Then rotate the wrist by jogging or with “Next pose (hold)”, and record three more poses.</source>
        <translation>Attendez l’arrêt, gardez l’outil sans contact et prenez la pose. Tournez ensuite le poignet, par déplacement ou avec « Pose suivante », et prenez trois autres poses.</translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation>Prendre la pose %1</translation>
    </message>
    <message>
        <source>Remove least accurate pose</source>
        <translation>Retirer la pose la moins précise</translation>
    </message>
    <message>
        <source>Remove last pose</source>
        <translation>Retirer la dernière pose</translation>
    </message>
    <message>
        <source>Pose %1  %2</source>
        <translation>Pose %1  %2</translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation>  ◀ la moins précise</translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool rotated in a different direction.</source>
        <translation>Les orientations de l’outil sont trop semblables. Prenez une pose de plus, l’outil tourné dans une autre direction.</translation>
    </message>
    <message numerus="yes">
        <source>Rotate the wrist in a different direction and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>Tournez le poignet dans une autre direction et prenez la pose. Poses encore nécessaires : %n.</numerusform>
            <numerusform>Tournez le poignet dans une autre direction et prenez la pose. Poses encore nécessaires : %n.</numerusform>
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
        <translation>Utilisé</translation>
    </message>
    <message>
        <source>Enter a name for the payload.</source>
        <translation>Saisissez un nom pour la charge utile.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renommer « %1 » en « %2 »</translation>
    </message>
    <message>
        <source>Nothing mounted</source>
        <translation>Rien de monté</translation>
    </message>
    <message>
        <source>Robotiq 2F-85, empty</source>
        <translation>Robotiq 2F-85, à vide</translation>
    </message>
    <message>
        <source>Robotiq 2F-140, empty</source>
        <translation>Robotiq 2F-140, à vide</translation>
    </message>
    <message>
        <source>Payloads</source>
        <translation>Charges utiles</translation>
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
        <translation>Masse de la charge utile</translation>
    </message>
    <message>
        <source>Centre of gravity X</source>
        <translation>Centre de gravité X</translation>
    </message>
    <message>
        <source>Centre of gravity Y</source>
        <translation>Centre de gravité Y</translation>
    </message>
    <message>
        <source>Centre of gravity Z</source>
        <translation>Centre de gravité Z</translation>
    </message>
    <message>
        <source>Press Return to apply the value to the project. The robot&apos;s payload does not change.</source>
        <translation>Appuyez sur Entrée pour appliquer au projet. La charge utile du robot ne change pas.</translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation>Régler sur le robot</translation>
    </message>
    <message>
        <source>Use this payload and set it on the robot</source>
        <translation>Utiliser cette charge utile et la régler sur le robot</translation>
    </message>
    <message>
        <source>Measure…</source>
        <translation>Mesurer…</translation>
    </message>
    <message>
        <source>Measure the payload with the arm</source>
        <translation>Mesurer la charge utile avec le bras</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Verify the payload</source>
        <translation>Vérifier la charge utile</translation>
    </message>
    <message>
        <source>Store the active payload of the robot</source>
        <translation>Garder la charge utile active du robot</translation>
    </message>
    <message>
        <source>Enter new payload</source>
        <translation>Saisir une nouvelle charge utile</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>charge utile</translation>
    </message>
    <message>
        <source>Add preset: %1</source>
        <translation>Ajouter un modèle : %1</translation>
    </message>
    <message>
        <source>Rename payload</source>
        <translation>Renommer la charge utile</translation>
    </message>
    <message>
        <source>Duplicate payload</source>
        <translation>Dupliquer la charge utile</translation>
    </message>
    <message>
        <source>Delete payload</source>
        <translation>Supprimer la charge utile</translation>
    </message>
    <message>
        <source>Add the payload “%1”</source>
        <translation>Ajouter la charge utile « %1 »</translation>
    </message>
    <message>
        <source>Change the payload “%1”</source>
        <translation>Changer la charge utile « %1 »</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>Aucun robot connecté. Connectez-en un, ou essayez le simulateur.</translation>
    </message>
    <message>
        <source>Select the payload to set.</source>
        <translation>Sélectionnez la charge utile à régler.</translation>
    </message>
    <message>
        <source>Use the payload “%1”</source>
        <translation>Utiliser la charge utile « %1 »</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller n’a pas le contrôle. Prenez d’abord le contrôle.</translation>
    </message>
    <message>
        <source>Delete the payload “%1”</source>
        <translation>Supprimer la charge utile « %1 »</translation>
    </message>
    <message>
        <source>Measuring payload… Keep the tool free of contact.</source>
        <translation>Mesure de la charge utile… Gardez l’outil sans contact.</translation>
    </message>
    <message>
        <source>The arm moved. Wait for standstill, keep the tool free of contact, and press “Verify” again.</source>
        <translation>Le bras a bougé. Attendez l’arrêt, gardez l’outil sans contact et vérifiez de nouveau.</translation>
    </message>
    <message>
        <source>The payload cannot be verified because the robot is not sending force data. Wait for data, or reconnect.</source>
        <translation>La charge utile ne peut pas être vérifiée, car le robot n’envoie pas de données de force. Attendez des données ou reconnectez-vous.</translation>
    </message>
    <message>
        <source>With a payload of %1 kg, the arm measures a force of %2 and a torque of %3.</source>
        <translation>Avec une charge utile de %1 kg, le bras mesure une force de %2 et un couple de %3.</translation>
    </message>
    <message>
        <source>The payload is correct. %1</source>
        <translation>La charge utile est correcte. %1</translation>
    </message>
    <message>
        <source>The payload is correct</source>
        <translation>La charge utile est correcte</translation>
    </message>
    <message>
        <source>The load is about %1 kg heavier than the configured payload.</source>
        <translation>La charge est plus lourde d’environ %1 kg que la charge utile configurée.</translation>
    </message>
    <message>
        <source>The load is about %1 kg lighter than the configured payload.</source>
        <translation>La charge est plus légère d’environ %1 kg que la charge utile configurée.</translation>
    </message>
    <message>
        <source>The centre of gravity differs, or something is touching the tool.</source>
        <translation>Le centre de gravité diffère, ou quelque chose touche l’outil.</translation>
    </message>
    <message>
        <source>%1 %2 Measure the payload, or select a different payload. Zeroing the force sensor hides a wrong payload until the tool rotates.</source>
        <translation>%1 %2 Mesurez la charge utile ou sélectionnez-en une autre. La mise à zéro du capteur de force masque une charge utile erronée jusqu’à ce que l’outil tourne.</translation>
    </message>
    <message>
        <source>The payload is wrong. %1 %2</source>
        <translation>La charge utile est erronée. %1 %2</translation>
    </message>
    <message>
        <source>The payload is wrong</source>
        <translation>La charge utile est erronée</translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation>%1, actif sur le robot</translation>
    </message>
    <message>
        <source>%1; the robot uses %2 kg, centre of gravity %3</source>
        <translation>%1 ; le robot utilise %2 kg, centre de gravité %3</translation>
    </message>
    <message>
        <source>The robot&apos;s payload differs from “%1”</source>
        <translation>La charge utile du robot diffère de « %1 »</translation>
    </message>
    <message>
        <source>On the robot: %1 kg, centre of gravity %2. In the project: %3 kg, centre of gravity %4. Nothing was changed.</source>
        <translation>Sur le robot : %1 kg, centre %2. Dans le projet : %3 kg, centre %4. Rien n’a été changé.</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>Régler « %1 » sur le robot</translation>
    </message>
    <message>
        <source>No payloads yet.
Press “Measure…” to measure the payload with the arm.</source>
        <translation>Aucune charge.
Appuyez sur Mesurer… pour mesurer la charge avec le bras.</translation>
    </message>
    <message>
        <source>A payload named “%1” already exists. Choose a different name.</source>
        <translation>Une charge utile nommée « %1 » existe déjà. Choisissez un autre nom.</translation>
    </message>
</context>
<context>
    <name>tiller::PlotAnalysis</name>
    <message>
        <source>Spectrum</source>
        <translation>Spectre</translation>
    </message>
    <message>
        <source>XY</source>
        <translation>XY</translation>
    </message>
    <message>
        <source>vs.</source>
        <translation>selon</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>Spectre et XY</translation>
    </message>
    <message>
        <source>Analysis type</source>
        <translation>Type d’analyse</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>X-axis signal</source>
        <translation>Signal de l’axe X</translation>
    </message>
    <message>
        <source>Add a signal to the plots first.</source>
        <translation>Ajoutez d’abord un signal aux tracés.</translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range.</source>
        <translation>Cette plage ne contient aucun échantillon. Sélectionnez une autre plage.</translation>
    </message>
    <message>
        <source>Samples are missing in this range. Place cursors A and B around a range without gaps.</source>
        <translation>Des échantillons manquent dans cette plage : placez les curseurs A et B sans lacune entre eux.</translation>
    </message>
    <message>
        <source>Frequency [Hz]</source>
        <translation>Fréquence [Hz]</translation>
    </message>
    <message>
        <source>Amplitude of %1</source>
        <translation>Amplitude de %1</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n échantillon</numerusform>
            <numerusform>%n échantillons</numerusform>
        </translation>
    </message>
    <message>
        <source>This range is too long to combine signals from different recordings. Place cursors A and B around a shorter range.</source>
        <translation>Cette plage est trop longue pour combiner des signaux d’enregistrements différents. Placez les curseurs A et B autour d’une plage plus courte.</translation>
    </message>
    <message>
        <source>Reading the recording: %1</source>
        <translation>Lecture de l’enregistrement : %1</translation>
    </message>
    <message numerus="yes">
        <source>Hann window of %1 samples · resolution %2 Hz · mean of %n segment(s) · %3 to %4 s</source>
        <translation>
            <numerusform>Fenêtre de Hann de %1 échantillons · résolution %2 Hz · moyenne de %n segment · %3 à %4 s</numerusform>
            <numerusform>Fenêtre de Hann de %1 échantillons · résolution %2 Hz · moyenne de %n segments · %3 à %4 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) shown, 1 of every %1</source>
        <translation>
            <numerusform>%n échantillon affiché, 1 sur %1</numerusform>
            <numerusform>%n échantillons affichés, 1 sur %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 to %3 s</source>
        <translation>%1 · %2 à %3 s</translation>
    </message>
    <message>
        <source>This range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation>Cette plage contient des échantillons de robots différents. Placez les curseurs A et B autour des données d’un seul robot.</translation>
    </message>
</context>
<context>
    <name>tiller::PlotComparison</name>
    <message>
        <source>Arm and model diverge: %1</source>
        <translation>Le bras et le modèle divergent : %1</translation>
    </message>
    <message>
        <source>Comparing the arm with its model: %1</source>
        <translation>Comparaison du bras avec son modèle : %1</translation>
    </message>
    <message>
        <source>Not compared with the arm model: the recording does not specify the robot model. Press “Compare…” and select the model.</source>
        <translation>Non comparé au modèle du bras : l’enregistrement n’indique pas le modèle de robot. Appuyez sur « Comparer… » et sélectionnez le modèle.</translation>
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
        <translation>Tracés</translation>
    </message>
    <message>
        <source>Time range of the plots. The mouse wheel zooms the time axis; over the value axis, or with Ctrl, it zooms the values. Double-click the value axis to scale automatically.</source>
        <translation>Plage de temps des tracés. La molette zoome l’axe du temps ; sur l’axe des valeurs ou avec Ctrl, elle zoome les valeurs. Double-cliquez sur l’axe des valeurs pour l’échelle automatique.</translation>
    </message>
    <message>
        <source>Pause the plots</source>
        <translation>Mettre les tracés en pause</translation>
    </message>
    <message>
        <source>Zero the displayed force</source>
        <translation>Mettre à zéro la force affichée</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Zéro</translation>
    </message>
    <message>
        <source>Export the visible range</source>
        <translation>Exporter la plage visible</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Save the visible range as an image (e.g. PNG) or as values (e.g. CSV)</source>
        <translation>Enregistrer la plage visible comme image (p. ex. PNG) ou comme valeurs (p. ex. CSV)</translation>
    </message>
    <message>
        <source>Cannot zero the force: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation>Mise à zéro de la force impossible : les tracés n’affichent aucun échantillon. Connectez-vous à un robot ou allez à un moment avec des échantillons.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
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
        <translation>Pause</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Freeze the plots. Reception and recording of data continue.</source>
        <translation>Figer les tracés ; les données et l’enregistrement continuent</translation>
    </message>
    <message>
        <source>Show the force as measured by the robot. %1</source>
        <translation>Afficher la force mesurée par le robot. %1</translation>
    </message>
    <message>
        <source>Subtract the current force in the plots. The robot, recordings and exported values are not changed.</source>
        <translation>Soustraire la force actuelle dans les tracés. Le robot, les enregistrements et les valeurs exportées ne changent pas.</translation>
    </message>
    <message>
        <source>● REC %1</source>
        <translation>● REC %1</translation>
    </message>
    <message>
        <source>● Record</source>
        <translation>● Enregistrer</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Arrêter l’enregistrement</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulé</translation>
    </message>
    <message>
        <source>Cannot export: the plots show no samples. Connect to a robot, or scroll to a time with samples.</source>
        <translation>Exportation impossible : les tracés n’affichent aucun échantillon. Connectez-vous à un robot ou allez à un moment avec des échantillons.</translation>
    </message>
    <message>
        <source>Exported the visible range to %1</source>
        <translation>Plage visible exportée vers %1</translation>
    </message>
    <message>
        <source>PNG image (*.png)</source>
        <translation>Image PNG (*.png)</translation>
    </message>
    <message>
        <source>SVG image (*.svg)</source>
        <translation>Image SVG (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Document PDF (*.pdf)</translation>
    </message>
    <message>
        <source>CSV file (*.csv)</source>
        <translation>Fichier CSV (*.csv)</translation>
    </message>
    <message>
        <source>Recording options</source>
        <translation>Options d’enregistrement</translation>
    </message>
    <message>
        <source>Rows, signals, folder and file name of the next recording</source>
        <translation>Lignes, signaux, dossier et nom de fichier du prochain enregistrement</translation>
    </message>
    <message>
        <source>One row per packet</source>
        <translation>Une ligne par paquet</translation>
    </message>
    <message numerus="yes">
        <source>One row every %n packet(s)</source>
        <translation>
            <numerusform>Une ligne tous les %n paquet</numerusform>
            <numerusform>Une ligne tous les %n paquets</numerusform>
        </translation>
    </message>
    <message>
        <source>All signals…</source>
        <translation>Tous les signaux…</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s)…</source>
        <translation>
            <numerusform>%n signal…</numerusform>
            <numerusform>%n signaux…</numerusform>
        </translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ouvrir le dossier</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>Dossier des enregistrements</translation>
    </message>
    <message>
        <source>This range contains no samples. Select a different range, then export again.</source>
        <translation>Il n’y a pas d’échantillons dans cette plage. Sélectionnez une autre plage, puis exportez de nouveau.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>What happened at this time?</source>
        <translation>Que s’est-il passé à ce moment ?</translation>
    </message>
    <message>
        <source>The plots were copied to the clipboard as an image.</source>
        <translation>Les tracés ont été copiés comme image dans le presse-papiers.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>History %1 · %2</source>
        <translation>Historique %1 · %2</translation>
    </message>
    <message>
        <source>New page</source>
        <translation>Nouvelle page</translation>
    </message>
    <message>
        <source>Remove this page</source>
        <translation>Retirer cette page</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Ouvrir un enregistrement…</translation>
    </message>
    <message>
        <source>Close recordings</source>
        <translation>Fermer les enregistrements</translation>
    </message>
    <message>
        <source>Copy plots as image</source>
        <translation>Copier les tracés comme image</translation>
    </message>
    <message>
        <source>Save layout…</source>
        <translation>Enregistrer la disposition…</translation>
    </message>
    <message>
        <source>Open layout…</source>
        <translation>Ouvrir une disposition…</translation>
    </message>
    <message>
        <source>History memory</source>
        <translation>Mémoire pour l’historique</translation>
    </message>
    <message>
        <source>Opened the recording %1</source>
        <translation>Enregistrement %1 ouvert</translation>
    </message>
    <message>
        <source>Open recording</source>
        <translation>Ouvrir un enregistrement</translation>
    </message>
    <message>
        <source>Save plot layout</source>
        <translation>Enregistrer la disposition des tracés</translation>
    </message>
    <message>
        <source>Plot layouts (*.json)</source>
        <translation>Dispositions de tracés (*.json)</translation>
    </message>
    <message>
        <source>Open plot layout</source>
        <translation>Ouvrir une disposition de tracés</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 et d’autres</translation>
    </message>
    <message>
        <source>Signal list</source>
        <translation>Liste des signaux</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signaux</translation>
    </message>
    <message>
        <source>Robot signals. Drag a signal to a plot, or to the edge of a plot to create a new plot. Double-click a signal to add it to a plot.</source>
        <translation>Signaux du robot. Faites glisser un signal vers un tracé, ou vers le bord d’un tracé pour en créer un. Double-cliquez sur un signal pour l’ajouter à un tracé.</translation>
    </message>
    <message>
        <source>Values at the cursors</source>
        <translation>Valeurs aux curseurs</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Values at cursors A and B, and statistics of the range between the cursors: minimum, maximum, mean, RMS, standard deviation, slope</source>
        <translation>Valeurs aux curseurs A et B et statistiques entre eux : minimum, maximum, moyenne, RMS, écart type, pente</translation>
    </message>
    <message>
        <source>Plot pages and layout</source>
        <translation>Pages et disposition des tracés</translation>
    </message>
    <message>
        <source>Layout ▾</source>
        <translation>Disposition ▾</translation>
    </message>
    <message>
        <source>Spectrum and XY</source>
        <translation>Spectre et XY</translation>
    </message>
    <message>
        <source>Export the visible range…</source>
        <translation>Exporter la plage visible…</translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation>Axe du temps</translation>
    </message>
    <message>
        <source>Relative to the newest sample</source>
        <translation>Par rapport au dernier échantillon</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>Temps du contrôleur</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Heure du jour</translation>
    </message>
    <message>
        <source>The maximum number of plot pages has been reached. Remove a page first.</source>
        <translation>Le nombre maximal de pages de tracés est atteint : retirez d’abord une page.</translation>
    </message>
    <message>
        <source>CSV: text, for pandas and spreadsheets</source>
        <translation>CSV : texte, pour pandas et tableurs</translation>
    </message>
    <message>
        <source>MCAP: every field, the log and the project, for ROS tools</source>
        <translation>MCAP : tous les champs, le journal et le projet, pour les outils ROS</translation>
    </message>
    <message>
        <source>Compare with the arm model…</source>
        <translation>Comparer au modèle du bras…</translation>
    </message>
    <message>
        <source>Exported the range between cursors A and B to %1</source>
        <translation>Plage entre les curseurs A et B exportée vers %1</translation>
    </message>
    <message>
        <source>Cursor A to cursor B (*%1)</source>
        <translation>Du curseur A au curseur B (*%1)</translation>
    </message>
    <message>
        <source>The page shows several recordings, or a recording and live signals. Show only one of them on the page, then export again.</source>
        <translation>La page montre plusieurs enregistrements, ou un enregistrement et des signaux en direct. N’en affichez qu’un sur la page, puis exportez de nouveau.</translation>
    </message>
    <message>
        <source>Live signals can be exported only as .csv. For other formats, record the signals first.</source>
        <translation>Les signaux en direct ne peuvent être exportés qu’en .csv. Pour d’autres formats, enregistrez-les d’abord.</translation>
    </message>
    <message>
        <source>The range contains too many values to export from this window. Export a shorter range, or run “tiller-cli export”.</source>
        <translation>La plage contient trop de valeurs pour être exportée depuis cette fenêtre. Exportez une plage plus courte ou exécutez « tiller-cli export ».</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>Robot : %1</translation>
    </message>
    <message>
        <source>Recordings (%1);;All files (*)</source>
        <translation>Enregistrements (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Record to a file (%1)</source>
        <translation>Enregistrer dans un fichier (%1)</translation>
    </message>
    <message>
        <source>Record robot data to a file (%1). Use the arrow button to select the signals and the folder.</source>
        <translation>Enregistrer les données du robot dans un fichier (%1). Utilisez la flèche pour choisir signaux et dossier.</translation>
    </message>
    <message>
        <source>All %1 pages show recordings. Remove a page or close the recordings first.</source>
        <translation>Les %1 pages affichent des enregistrements. Supprimez d’abord une page ou fermez les enregistrements.</translation>
    </message>
    <message>
        <source>Cursor readout</source>
        <translation>Lecture au curseur</translation>
    </message>
    <message>
        <source>Click in the plots to place cursors A and B; drag them, or use the A, B and arrow keys. Click a legend entry to hide its curve; Ctrl+click the entry to show its values at the cursors.</source>
        <translation>Cliquez dans les tracés pour placer les curseurs A et B ; faites-les glisser ou utilisez A, B et les flèches. Cliquez sur une entrée de légende pour masquer sa courbe ; Ctrl+clic pour lire ce signal aux curseurs.</translation>
    </message>
    <message>
        <source>Time range</source>
        <translation>Plage de temps</translation>
    </message>
    <message>
        <source>Paused · %1 s behind</source>
        <translation>En pause · %1 s de retard</translation>
    </message>
    <message>
        <source>Return to the newest samples</source>
        <translation>Retour aux valeurs les plus récentes</translation>
    </message>
    <message>
        <source>controller time %1 to %2 s</source>
        <translation>temps du contrôleur %1 à %2 s</translation>
    </message>
    <message>
        <source>%1 to %2 s</source>
        <translation>%1 à %2 s</translation>
    </message>
    <message>
        <source>Folder: %1…</source>
        <translation>Dossier : %1…</translation>
    </message>
    <message>
        <source>The file type is not supported. Use the suffix .png, .svg or .pdf for an image, or .csv for values.</source>
        <translation>Le type de fichier n’est pas pris en charge. Utilisez le suffixe .png, .svg ou .pdf pour une image, ou .csv pour des valeurs.</translation>
    </message>
    <message>
        <source>%1 at controller time %2 s.</source>
        <translation>%1 (temps du contrôleur : %2 s).</translation>
    </message>
    <message>
        <source>Show standard plots</source>
        <translation>Afficher les tracés standard</translation>
    </message>
    <message>
        <source>the file does not contain a plot layout</source>
        <translation>le fichier ne contient pas de disposition de tracés</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %2/s · %3 free · %n packet(s) lost</source>
        <translation>
            <numerusform>%1 · %2/s · %3 libres · %n paquet perdu</numerusform>
            <numerusform>%1 · %2/s · %3 libres · %n paquets perdus</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened the recording %1, but part of it could not be read. %2</source>
        <translation>Enregistrement %1 ouvert, mais une partie n’a pas pu être lue. %2</translation>
    </message>
    <message>
        <source>Part of the recording %1 could not be read. %2</source>
        <translation>Une partie de l’enregistrement %1 n’a pas pu être lue. %2</translation>
    </message>
    <message>
        <source>The range contains samples from different robots. Use cursors A and B to select a range with data from one robot, then export again.</source>
        <translation>La plage contient des valeurs de différents robots. Sélectionnez avec les curseurs A et B une plage d’un seul robot, puis exportez de nouveau.</translation>
    </message>
    <message>
        <source>The image %1 could not be created. Choose a different image format.</source>
        <translation>L’image %1 n’a pas pu être créée. Choisissez un autre format d’image.</translation>
    </message>
    <message>
        <source>Recordings…</source>
        <translation>Enregistrements…</translation>
    </message>
    <message>
        <source>The plots do not contain data from %1.</source>
        <translation>Les graphiques ne contiennent pas de données de %1.</translation>
    </message>
    <message>
        <source>● Waiting</source>
        <translation>● Attente</translation>
    </message>
    <message>
        <source>Waiting for the trigger. Files so far: %1</source>
        <translation>Attente du déclencheur. Fichiers jusqu’ici : %1</translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation>Métadonnées…</translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>Métadonnées (%n champ)…</numerusform>
            <numerusform>Métadonnées (%n champs)…</numerusform>
        </translation>
    </message>
    <message>
        <source>Trigger…</source>
        <translation>Déclencheur…</translation>
    </message>
    <message>
        <source>Trigger %1…</source>
        <translation>Déclencheur %1…</translation>
    </message>
    <message>
        <source>File name: %1…</source>
        <translation>Nom du fichier : %1…</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation>%1 × temps réel</translation>
    </message>
    <message>
        <source>Stop playback</source>
        <translation>Arrêter la lecture</translation>
    </message>
    <message>
        <source>Cannot play: the page has no samples. Connect to a robot or open a recording first.</source>
        <translation>Lecture impossible : la page ne contient aucun échantillon. Connectez d’abord un robot ou ouvrez un enregistrement.</translation>
    </message>
</context>
<context>
    <name>tiller::PlotMarks</name>
    <message>
        <source>%1 is above %2</source>
        <translation>%1 est au-dessus de %2</translation>
    </message>
    <message>
        <source>%1 is below %2</source>
        <translation>%1 est au-dessous de %2</translation>
    </message>
</context>
<context>
    <name>tiller::PlotPages</name>
    <message>
        <source>Plot pages</source>
        <translation>Pages de tracés</translation>
    </message>
    <message>
        <source>Page name</source>
        <translation>Nom de la page</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Page %1</translation>
    </message>
    <message>
        <source>Double-click to rename</source>
        <translation>Double-cliquez pour renommer</translation>
    </message>
</context>
<context>
    <name>tiller::PlotValues</name>
    <message>
        <source>Values at the cursors</source>
        <translation>Valeurs aux curseurs</translation>
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
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Std</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation>Crête à crête</translation>
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
        <translation>Cliquez dans les tracés pour placer le curseur A, puis le curseur B. Le tableau affiche alors les statistiques de la plage entre les curseurs.</translation>
    </message>
    <message>
        <source>%1 · calculating: %2</source>
        <translation>%1 · calcul en cours : %2</translation>
    </message>
    <message>
        <source>Statistics are incomplete: %1</source>
        <translation>Les statistiques sont incomplètes : %1</translation>
    </message>
    <message>
        <source>Slope per second</source>
        <translation>Pente par s</translation>
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
        <translation>%1 (à zéro)</translation>
    </message>
    <message>
        <source>%1 %2 s · %3 %4</source>
        <translation>%1 %2 s · %3 %4</translation>
    </message>
    <message>
        <source>Fixed scale · double-click the axis to scale automatically</source>
        <translation>Échelle fixe · double-cliquez sur l’axe pour l’échelle automatique</translation>
    </message>
    <message>
        <source>Zeroed (offset %1 %2)</source>
        <translation>Mis à zéro (décalage %1 %2)</translation>
    </message>
    <message>
        <source>Plots over time</source>
        <translation>Tracés dans le temps</translation>
    </message>
    <message>
        <source>A and B place the cursors. Left and Right move the active cursor. Up and Down select the signal at the cursors. H hides the curve of this signal; Ctrl+Delete removes it. Plus and Minus change the time range, or the value scale with Ctrl; Ctrl+0 scales automatically. N adds a note, F shows all data, and End returns to the newest samples.</source>
        <translation>A et B placent les curseurs. Gauche et Droite déplacent le curseur actif. Haut et Bas choisissent le signal lu. H masque la courbe de ce signal ; Ctrl+Suppr la retire. Plus et Moins changent la plage de temps, avec Ctrl l’échelle des valeurs ; Ctrl+0 pour l’échelle automatique. N ajoute une note, F affiche toutes les données et Fin revient aux derniers échantillons.</translation>
    </message>
    <message>
        <source>A–B Δt %1 s</source>
        <translation>A–B Δt %1 s</translation>
    </message>
    <message>
        <source>Drop signals here</source>
        <translation>Déposez les signaux ici</translation>
    </message>
    <message>
        <source>No samples yet. Connect to a robot.</source>
        <translation>Pas encore de valeurs. Connectez-vous à un robot.</translation>
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
        <translation>Rotation autour de X (RX)</translation>
    </message>
    <message>
        <source>Rotation about Y (RY)</source>
        <translation>Rotation autour de Y (RY)</translation>
    </message>
    <message>
        <source>Rotation about Z (RZ)</source>
        <translation>Rotation autour de Z (RZ)</translation>
    </message>
</context>
<context>
    <name>tiller::PoseView</name>
    <message>
        <source>TCP at the flange</source>
        <translation>TCP à la bride</translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation>TCP à %1 de la bride</translation>
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
        <translation>Pose du TCP en %1</translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ₀: displacement from the zero position. Click to show the displacement since the start of the last motion.</source>
        <translation>orientation selon les réglages. Δ₀ : déplacement depuis zéro. Cliquez pour afficher le déplacement depuis le début du dernier mouvement.</translation>
    </message>
    <message>
        <source>orientation as set in Settings. Δ: displacement since the start of the last motion. Click to set the displacement to zero.</source>
        <translation>orientation selon les réglages. Δ : déplacement depuis le début du dernier mouvement. Cliquez pour mettre à zéro ici.</translation>
    </message>
    <message>
        <source>TCP in the flange frame: %1</source>
        <translation>TCP dans le repère de la bride : %1</translation>
    </message>
</context>
<context>
    <name>tiller::PositionsPage</name>
    <message>
        <source>Joints °</source>
        <translation>Articulations °</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Enter a name for the position.</source>
        <translation>Saisissez un nom pour la position.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renommer « %1 » en « %2 »</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positions</translation>
    </message>
    <message>
        <source>No positions yet.
Jog the arm to a position and press “Set home here” or “Add position”.</source>
        <translation>Pas encore de positions.
Amenez le bras à une position et appuyez sur « Origine ici » ou « Ajouter position ».</translation>
    </message>
    <message>
        <source>Safe height</source>
        <translation>Hauteur sûre</translation>
    </message>
    <message>
        <source>%1. Press Return to apply the values. Only the stored position changes; the robot does not move.</source>
        <translation>%1. Appuyez sur Entrée pour appliquer. Seule la position enregistrée change ; le robot ne bouge pas.</translation>
    </message>
    <message>
        <source>Height in the base frame. Above this height, the cell is free of obstacles, and the TCP may move sideways.</source>
        <translation>Hauteur dans le repère de base au-dessus de laquelle il n’y a pas d’obstacles : au-dessus, le TCP peut se déplacer latéralement.</translation>
    </message>
    <message>
        <source>At TCP</source>
        <translation>Au TCP</translation>
    </message>
    <message>
        <source>Set the safe height to the current TCP height</source>
        <translation>Régler la hauteur sûre à la hauteur actuelle du TCP</translation>
    </message>
    <message>
        <source>Set home here</source>
        <translation>Origine ici</translation>
    </message>
    <message>
        <source>Add position</source>
        <translation>Ajouter position</translation>
    </message>
    <message>
        <source>Store the current position of the arm</source>
        <translation>Garder la position actuelle du bras</translation>
    </message>
    <message>
        <source>Use as home</source>
        <translation>Utiliser comme origine</translation>
    </message>
    <message>
        <source>Use the selected position as home</source>
        <translation>Utiliser la position choisie comme origine</translation>
    </message>
    <message>
        <source>Touch up position</source>
        <translation>Retoucher la position</translation>
    </message>
    <message>
        <source>Reset to default home</source>
        <translation>Rétablir l’origine par défaut</translation>
    </message>
    <message>
        <source>Rename position</source>
        <translation>Renommer la position</translation>
    </message>
    <message>
        <source>Delete position</source>
        <translation>Supprimer la position</translation>
    </message>
    <message>
        <source>Set “%1” to the current position of the arm?</source>
        <translation>Définir « %1 » à la position actuelle du bras ?</translation>
    </message>
    <message>
        <source>The Home button will then move the arm to this position.</source>
        <translation>Le bouton Origine y amènera le bras.</translation>
    </message>
    <message>
        <source>Set home</source>
        <translation>Régler l’origine</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>Add the position “%1”</source>
        <translation>Ajouter la position « %1 »</translation>
    </message>
    <message>
        <source>Select a position to touch up.</source>
        <translation>Choisissez une position à retoucher.</translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>Retoucher « %1 » ?</translation>
    </message>
    <message>
        <source>Largest joint change: %1 %2.</source>
        <translation>Plus grand changement articulaire : %1 %2.</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Retoucher</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>Retoucher « %1 »</translation>
    </message>
    <message>
        <source>Use “%1” as home</source>
        <translation>Utiliser « %1 » comme origine</translation>
    </message>
    <message>
        <source>Select a position to use as home.</source>
        <translation>Choisissez une position comme origine.</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>Supprimer « %1 »</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>Changer « %1 »</translation>
    </message>
    <message>
        <source>Set the safe height</source>
        <translation>Régler la hauteur sûre</translation>
    </message>
    <message>
        <source>Remove the safe height</source>
        <translation>Supprimer la hauteur sûre</translation>
    </message>
    <message>
        <source>The Home button moves the arm to the default home position: upright, without self-collision.</source>
        <translation>Le bouton Origine amène le bras à la position par défaut : vertical, sans collision avec lui-même.</translation>
    </message>
    <message>
        <source>%1: target of the Home button</source>
        <translation>%1 : cible du bouton Origine</translation>
    </message>
    <message>
        <source>%1 · %2 %3 from the current position</source>
        <translation>%1 · %2 %3 d’ici</translation>
    </message>
    <message>
        <source>A position named “%1” already exists. Choose a different name.</source>
        <translation>Une position nommée « %1 » existe déjà. Choisissez un autre nom.</translation>
    </message>
</context>
<context>
    <name>tiller::Practice</name>
    <message>
        <source>Start the simulated robot in the Robot menu first.</source>
        <translation>Démarrez d’abord le robot simulé (menu Robot).</translation>
    </message>
    <message>
        <source>Power on the arm and release the brakes first.</source>
        <translation>Mettez d’abord le bras sous tension et desserrez les freins.</translation>
    </message>
    <message>
        <source>The safety system has stopped the arm. Use “Recover…” first.</source>
        <translation>Le système de sécurité a arrêté le bras. Utilisez d’abord « Rétablir… ».</translation>
    </message>
    <message>
        <source>Done. Press “Start” to repeat the task.</source>
        <translation>Terminé. Appuyez sur Démarrer pour répéter l’exercice.</translation>
    </message>
    <message>
        <source>Press “Start”.</source>
        <translation>Appuyez sur Démarrer.</translation>
    </message>
</context>
<context>
    <name>tiller::PracticeCard</name>
    <message>
        <source>Practice</source>
        <translation>Exercices</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fait</translation>
    </message>
    <message>
        <source>Force Fz in newtons</source>
        <translation>Force Fz en newtons</translation>
    </message>
    <message>
        <source>Enter a value and press Return</source>
        <translation>Saisissez la valeur, appuyez sur Entrée</translation>
    </message>
    <message>
        <source>Fz [N]</source>
        <translation>Fz [N]</translation>
    </message>
    <message>
        <source>Previous task</source>
        <translation>L’exercice précédent</translation>
    </message>
    <message>
        <source>Next task</source>
        <translation>L’exercice suivant</translation>
    </message>
    <message>
        <source>Practice · %1 of %2</source>
        <translation>Exercices · %1 sur %2</translation>
    </message>
    <message>
        <source>Starts or restarts the task</source>
        <translation>Démarre ou redémarre l’exercice</translation>
    </message>
    <message>
        <source>Continues with the next task</source>
        <translation>Continue avec l’exercice suivant</translation>
    </message>
    <message>
        <source>Available after the check above has passed</source>
        <translation>Disponible une fois la vérification ci-dessus réussie</translation>
    </message>
</context>
<context>
    <name>tiller::PreflightPage</name>
    <message>
        <source>Good</source>
        <translation>Bon</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Attention</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échec</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Non vérifié</translation>
    </message>
    <message>
        <source>Before you connect to %1</source>
        <translation>Avant de vous connecter à %1</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Contrôles</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Vérifier encore</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connecter</translation>
    </message>
    <message>
        <source>Keep everyone out of reach of the arm.
Keep the emergency stop within reach: STOP in this window is a software stop.
Start slowly: the initial speed is %1.
Watch the arm, not the screen, while you hold a button.
Release the button to stop the arm.</source>
        <translation>Tenez tout le monde hors de portée du bras.
Gardez l’arrêt d’urgence à portée de main : STOP dans cette fenêtre est un arrêt logiciel.
Commencez lentement : la vitesse initiale est %1.
Regardez le bras, pas l’écran, quand vous maintenez un bouton.
Relâchez le bouton pour arrêter le bras.</translation>
    </message>
    <message>
        <source>Checking %1…</source>
        <translation>Vérification de %1…</translation>
    </message>
    <message>
        <source>Problems found</source>
        <translation>Problèmes détectés</translation>
    </message>
    <message>
        <source>Ready, with warnings</source>
        <translation>Prêt, avec des avertissements</translation>
    </message>
    <message>
        <source>Everything is ready</source>
        <translation>Tout est prêt</translation>
    </message>
    <message>
        <source>Connect anyway</source>
        <translation>Connecter malgré tout</translation>
    </message>
    <message>
        <source>If you connect anyway, the window shows the available data. The red items above may prevent Tiller from taking control or may stop a running motion.</source>
        <translation>Si vous vous connectez malgré tout, la fenêtre affiche les données disponibles. Les points rouges ci-dessus peuvent empêcher la prise de contrôle ou arrêter un mouvement en cours.</translation>
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
        <translation>%1, désactivée</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>%1, running</source>
        <translation>%1, en cours</translation>
    </message>
    <message>
        <source>%1, breakpoint</source>
        <translation>%1, point d’arrêt</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, modifiée</translation>
    </message>
</context>
<context>
    <name>tiller::ProgramTab</name>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Modifier</translation>
    </message>
    <message>
        <source>Show step</source>
        <translation>Afficher l’étape</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Move steps</source>
        <translation>Déplacer des étapes</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>Modifier « %1 »</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>Add steps, or edit the selected step</source>
        <translation>Ajouter des étapes ou modifier l’étape sélectionnée</translation>
    </message>
    <message>
        <source>Step fields</source>
        <translation>Champs de l’étape</translation>
    </message>
    <message>
        <source>New program</source>
        <translation>Nouveau programme</translation>
    </message>
    <message>
        <source>Rename program…</source>
        <translation>Renommer le programme…</translation>
    </message>
    <message>
        <source>Delete program</source>
        <translation>Supprimer le programme</translation>
    </message>
    <message>
        <source>Export script…</source>
        <translation>Exporter le script…</translation>
    </message>
    <message>
        <source>Paste steps</source>
        <translation>Coller des étapes</translation>
    </message>
    <message>
        <source>Cut steps</source>
        <translation>Couper des étapes</translation>
    </message>
    <message>
        <source>Copy steps</source>
        <translation>Copier des étapes</translation>
    </message>
    <message>
        <source>Duplicate steps</source>
        <translation>Dupliquer des étapes</translation>
    </message>
    <message>
        <source>Delete steps</source>
        <translation>Supprimer des étapes</translation>
    </message>
    <message>
        <source>Disable or enable steps</source>
        <translation>Désactiver ou activer des étapes</translation>
    </message>
    <message>
        <source>Move steps up</source>
        <translation>Monter des étapes</translation>
    </message>
    <message>
        <source>Move steps down</source>
        <translation>Descendre des étapes</translation>
    </message>
    <message>
        <source>Move steps into the section above</source>
        <translation>Déplacer des étapes dans la section au-dessus</translation>
    </message>
    <message>
        <source>Move steps out of the section</source>
        <translation>Sortir des étapes de la section</translation>
    </message>
    <message>
        <source>Drag steps into the program, or double-click them.</source>
        <translation>Glissez des étapes dans le programme, ou double-cliquez dessus.</translation>
    </message>
    <message>
        <source>⚠ Step %1: %2</source>
        <translation>⚠ Étape %1 : %2</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>The program can run. Press “Preview” to simulate it.</source>
        <translation>Le programme peut s’exécuter. Appuyez sur « Aperçu » pour le simuler.</translation>
    </message>
    <message>
        <source>Add steps</source>
        <translation>Ajouter des étapes</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>Ajouter « %1 »</translation>
    </message>
    <message>
        <source>Rename program</source>
        <translation>Renommer le programme</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renommer « %1 » en « %2 »</translation>
    </message>
    <message>
        <source>Delete “%1”</source>
        <translation>Supprimer « %1 »</translation>
    </message>
    <message>
        <source>Disable steps</source>
        <translation>Désactiver des étapes</translation>
    </message>
    <message>
        <source>Enable steps</source>
        <translation>Activer des étapes</translation>
    </message>
    <message>
        <source>Simulating…</source>
        <translation>Simulation en cours…</translation>
    </message>
    <message>
        <source>Simulated: the program takes %1 s. No problems found.</source>
        <translation>Simulé : le programme dure %1 s. Aucun problème trouvé.</translation>
    </message>
    <message numerus="yes">
        <source>⚠ Simulated: %n problem(s) found. %1</source>
        <translation>
            <numerusform>⚠ Simulé : %n problème trouvé. %1</numerusform>
            <numerusform>⚠ Simulé : %n problèmes trouvés. %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Export script</source>
        <translation>Exporter le script</translation>
    </message>
    <message>
        <source>URScript (*.script)</source>
        <translation>URScript (*.script)</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exporté vers %1</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Démarrage…</translation>
    </message>
    <message>
        <source>Running step %1 (%2)</source>
        <translation>Étape %1 (%2) en cours</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En cours</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Arrêt…</translation>
    </message>
    <message>
        <source>Paused before step %1 (%2)</source>
        <translation>En pause avant l&apos;étape %1 (%2)</translation>
    </message>
    <message>
        <source>Pausing after step %1 (%2)</source>
        <translation>Pause après l&apos;étape %1 (%2)</translation>
    </message>
    <message>
        <source>Simulated: two cycles of the endless program take %1 s. No problems found.</source>
        <translation>Simulé : deux cycles du programme sans fin durent %1 s. Aucun problème trouvé.</translation>
    </message>
    <message>
        <source>Check recoverability</source>
        <translation>Vérifier la reprise</translation>
    </message>
    <message>
        <source>The check was cancelled.</source>
        <translation>La vérification a été annulée.</translation>
    </message>
    <message>
        <source>Cancel check</source>
        <translation>Annuler la vérification</translation>
    </message>
    <message>
        <source>In simulation, the program can continue after a stop in %1 of %2 steps.</source>
        <translation>En simulation, le programme peut continuer après un arrêt dans %1 étapes sur %2.</translation>
    </message>
    <message>
        <source>Add or remove breakpoints</source>
        <translation>Ajouter ou supprimer des points d’arrêt</translation>
    </message>
    <message>
        <source>⚠ The program cannot pause before this step.</source>
        <translation>⚠ Le programme ne peut pas faire de pause avant cette étape.</translation>
    </message>
    <message>
        <source>New breakpoints take effect at the next start.</source>
        <translation>Les nouveaux points d’arrêt prennent effet au prochain démarrage.</translation>
    </message>
    <message>
        <source>The program is running, so it cannot be deleted. Stop the program first.</source>
        <translation>Le programme est en cours d’exécution et ne peut pas être supprimé. Arrêtez d’abord le programme.</translation>
    </message>
    <message>
        <source>Paused on the robot in step %1 (%2)</source>
        <translation>En pause sur le robot à l’étape %1 (%2)</translation>
    </message>
    <message>
        <source>Program “%1” deleted. Ctrl+Z restores it.</source>
        <translation>Programme « %1 » supprimé. Ctrl+Z le restaure.</translation>
    </message>
    <message>
        <source>Import program…</source>
        <translation>Importer un programme…</translation>
    </message>
    <message>
        <source>Import program</source>
        <translation>Importer un programme</translation>
    </message>
    <message>
        <source>Robot programs (*.script *.urp *.urpx);;All files (*)</source>
        <translation>Programmes de robot (*.script *.urp *.urpx);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <translation>Importation de %1…</translation>
    </message>
    <message>
        <source>Import “%1”</source>
        <translation>Importer « %1 »</translation>
    </message>
    <message>
        <source>Imported “%1”.</source>
        <translation>« %1 » importé.</translation>
    </message>
    <message>
        <source>⚠ The import failed. The project is unchanged.</source>
        <translation>⚠ L’importation a échoué. Le projet est inchangé.</translation>
    </message>
    <message>
        <source>Step %1 (%2)</source>
        <translation>Étape %1 (%2)</translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation>Non vérifié : %1.</translation>
    </message>
    <message>
        <source>Checking recoverability…</source>
        <translation>Vérification de la reprise…</translation>
    </message>
    <message>
        <source>⚠ Correct the problems in the program first.</source>
        <translation>⚠ Corrigez d’abord le programme.</translation>
    </message>
    <message>
        <source>Outputs were changed after the stop, so the program cannot continue. Run the program from the beginning.</source>
        <translation>Des sorties ont été modifiées après l’arrêt : le programme ne peut pas reprendre. Exécutez-le depuis le début.</translation>
    </message>
    <message>
        <source>The program was changed after the stop, so it cannot continue. Run the program from the beginning.</source>
        <translation>Le programme a été modifié après l’arrêt : il ne peut pas reprendre. Exécutez-le depuis le début.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) changed because the project changed. Press “Preview” to simulate the program.</source>
        <translation>
            <numerusform>%n étape a changé avec le projet. Appuyez sur « Aperçu » pour simuler le programme.</numerusform>
            <numerusform>%n étapes ont changé avec le projet. Appuyez sur « Aperçu » pour simuler le programme.</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused before step %1 (%2) because of the maximum hold time. Hold “Continue (hold)” to continue.</source>
        <translation>En pause avant l’étape %1 (%2) en raison de la durée maximale de maintien. Maintenez « Reprendre (maintenir) » pour reprendre.</translation>
    </message>
    <message>
        <source>Running step %1 (%2). Joint moves are slow because the preview did not run the whole program from this position.</source>
        <translation>Étape %1 (%2) en cours. Les mouvements articulaires sont lents, car l’aperçu n’a pas exécuté tout le programme à partir de cette position.</translation>
    </message>
    <message>
        <source>Not run: %1.</source>
        <translation>Non exécuté : %1.</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectDocument</name>
    <message>
        <source>Delete “%1”</source>
        <translation>Supprimer « %1 »</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n waypoints</source>
        <translation>
            <numerusform>Supprimer %n point de passage</numerusform>
            <numerusform>Supprimer %n points de passage</numerusform>
        </translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>Changer l’ordre</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFiles</name>
    <message>
        <source>The damaged project file was kept as %1.</source>
        <translation>Le fichier de projet endommagé a été gardé sous %1</translation>
    </message>
    <message>
        <source>The project could not be saved</source>
        <translation>Le projet n’a pu être enregistré</translation>
    </message>
    <message>
        <source>%1. Update Tiller to open the file. The file was not changed.</source>
        <translation>%1. Mettez Tiller à jour pour l’ouvrir. Le fichier n’a pas été modifié.</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Ouvrir un projet</translation>
    </message>
    <message>
        <source>Tiller projects (*.tiller)</source>
        <translation>Projets Tiller (*.tiller)</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>The project could not be opened</source>
        <translation>Le projet n’a pu être ouvert</translation>
    </message>
    <message>
        <source>Opened a copy of “%1”. Save the copy to a file to keep changes.</source>
        <translation>Une copie de « %1 » est ouverte. Enregistrez-la dans un fichier pour garder les changements.</translation>
    </message>
    <message>
        <source>“%1” is a copy with unsaved changes.</source>
        <translation>« %1 » est une copie avec des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Abandonner les changements</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>%1 is damaged</source>
        <translation>%1 est endommagé</translation>
    </message>
    <message>
        <source>%1. Readable waypoints: %2, unreadable: %3. The damaged file is kept.</source>
        <translation>%1. Points de passage lisibles : %2, non lisibles : %3. Le fichier endommagé est gardé.</translation>
    </message>
    <message numerus="yes">
        <source>Open %n waypoints</source>
        <translation>
            <numerusform>Ouvrir %n point de passage</numerusform>
            <numerusform>Ouvrir %n points de passage</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes are saved to %1 again.</source>
        <translation>Enregistrement de %1 repris</translation>
    </message>
    <message>
        <source>The other window closed %1. This window saves changes again.</source>
        <translation>L’autre fenêtre a fermé %1. Cette fenêtre enregistre de nouveau les modifications.</translation>
    </message>
    <message>
        <source>%1 is open in another window</source>
        <translation>%1 est ouvert dans une autre fenêtre</translation>
    </message>
    <message>
        <source>Opened by %1. Changes in this window are not saved to the file until you take over the project.</source>
        <translation>Ouvert par %1. Les modifications de cette fenêtre ne sont pas enregistrées dans le fichier tant que vous ne reprenez pas le projet.</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Save as a copy</source>
        <translation>Enregistrer une copie</translation>
    </message>
    <message>
        <source>View only</source>
        <translation>Lecture seule</translation>
    </message>
    <message>
        <source>Another window or program has changed %1</source>
        <translation>Une autre fenêtre ou un autre programme a modifié %1</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recharger</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>Garder les deux</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>Décider plus tard</translation>
    </message>
    <message>
        <source>Reloaded %1</source>
        <translation>%1 rechargé</translation>
    </message>
    <message>
        <source>The project in this window is now %1.</source>
        <translation>Le projet de cette fenêtre est maintenant %1</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>Projet sans titre</translation>
    </message>
    <message>
        <source>Unsaved work can be recovered</source>
        <translation>Du travail non enregistré peut être récupéré</translation>
    </message>
    <message>
        <source>“%1” was changed on %2 and not saved to a file.</source>
        <translation>« %1 » a été modifié le %2 et n’a pas été enregistré dans un fichier.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Ask again next time</source>
        <translation>Redemander la prochaine fois</translation>
    </message>
    <message>
        <source>%1 has unsaved changes. %2</source>
        <translation>%1 contient des modifications non enregistrées. %2</translation>
    </message>
    <message>
        <source>The project has unsaved changes.</source>
        <translation>Le projet contient des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>“Keep both” saves the project of this window to a second file. “Reload” shows the new content. Tiller then offers to restore the unsaved changes at the next start.</source>
        <translation>« Garder les deux » enregistre le projet de cette fenêtre dans un second fichier. « Recharger » affiche le nouveau contenu ; les modifications non enregistrées de cette fenêtre sont proposées au prochain démarrage.</translation>
    </message>
    <message>
        <source>Unreadable boxes and planes of the cell: %1. Collisions with these objects are not prevented.</source>
        <translation>Boîtes et plans illisibles de la cellule : %1. Les collisions avec eux ne sont pas évitées.</translation>
    </message>
    <message>
        <source>The unsaved work in “%1” will be deleted. This cannot be undone.</source>
        <translation>Le travail non enregistré de « %1 » sera supprimé. Cette action est irréversible.</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Nouveau projet</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <source>The project could not be taken over</source>
        <translation>Impossible de reprendre le projet</translation>
    </message>
    <message>
        <source>%1 already exists. Choose a different name for the new project.</source>
        <translation>%1 existe déjà. Choisissez un autre nom pour le nouveau projet.</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectFit</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 et %n de plus</numerusform>
            <numerusform>%1 et %n de plus</numerusform>
        </translation>
    </message>
    <message>
        <source>TCP of %1</source>
        <translation>TCP de %1</translation>
    </message>
    <message>
        <source>The project was taught with a %1, but a %2 is connected. The same joint positions lead to different poses.</source>
        <translation>Le projet a été appris avec un %1, mais un %2 est connecté. Les mêmes positions articulaires mènent à d’autres poses.</translation>
    </message>
    <message>
        <source>The project uses the TCP “%1”. The active TCP of the robot differs by %2.</source>
        <translation>Le projet utilise le TCP « %1 ». Le TCP actif du robot en diffère de %2.</translation>
    </message>
    <message>
        <source>The project matches the connected robot.</source>
        <translation>Le projet convient au robot connecté.</translation>
    </message>
    <message>
        <source>No robot is connected. Connect the robot that belongs to this project.</source>
        <translation>Aucun robot n’est connecté. Connectez le robot de ce projet.</translation>
    </message>
    <message>
        <source>Keep poses</source>
        <translation>Conserver les poses</translation>
    </message>
    <message>
        <source>Keep joints</source>
        <translation>Conserver les articulations</translation>
    </message>
    <message>
        <source>TCP differs from the project</source>
        <translation>Le TCP diffère du projet</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>Régler « %1 » sur le robot</translation>
    </message>
    <message>
        <source>Keep the robot&apos;s TCP</source>
        <translation>Conserver le TCP du robot</translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same poses</source>
        <translation>Convertir de %1 en %2, conserver les poses</translation>
    </message>
    <message>
        <source>Convert from %1 to %2 with the same joint positions</source>
        <translation>Convertir de %1 en %2, conserver les articulations</translation>
    </message>
    <message>
        <source>Out of reach: %1.</source>
        <translation>Hors de portée : %1.</translation>
    </message>
    <message>
        <source>Removed because they are out of reach: %1. Press Ctrl+Z to restore them.</source>
        <translation>Supprimés car hors de portée : %1. Annuler les rétablit.</translation>
    </message>
    <message>
        <source>Some positions are out of reach</source>
        <translation>Certaines positions sont hors de portée</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>The robot model is not known yet. Wait until the robot reports the model.</source>
        <translation>Le modèle du robot n’est pas encore connu. Attendez que le robot l’ait indiqué.</translation>
    </message>
    <message>
        <source>Project for a different robot model</source>
        <translation>Projet pour un autre modèle de robot</translation>
    </message>
    <message>
        <source>“Keep poses” recalculates the joint positions; the tool reaches the same poses. “Keep joints” keeps the arm configuration; the tool reaches different poses. Until you decide, moves to positions in the project are blocked.</source>
        <translation>« Conserver les poses » recalcule les positions articulaires ; l’outil atteint les mêmes poses. « Conserver les articulations » garde la configuration du bras ; l’outil atteint d’autres poses. Jusqu’à votre décision, les mouvements vers les positions du projet sont bloqués.</translation>
    </message>
    <message>
        <source>With the robot&apos;s TCP, the flange moves to the same poses as taught, but the TCP does not. Until you decide, moves to positions in the project are blocked.</source>
        <translation>Avec le TCP du robot, la bride atteint les poses apprises, mais pas le TCP. Jusqu’à votre décision, les mouvements vers les positions du projet sont bloqués.</translation>
    </message>
    <message>
        <source>Moves to positions in this project are blocked</source>
        <translation>Les mouvements vers les positions de ce projet sont bloqués</translation>
    </message>
</context>
<context>
    <name>tiller::ProjectStore</name>
    <message>
        <source>%1 — a copy, not saved to a file</source>
        <translation>%1 — une copie, non enregistrée dans un fichier</translation>
    </message>
    <message>
        <source>Project not saved to a file</source>
        <translation>Projet non enregistré dans un fichier</translation>
    </message>
    <message>
        <source>disk full</source>
        <translation>disque plein</translation>
    </message>
    <message>
        <source>%1 — not saved: %2</source>
        <translation>%1 — non enregistré : %2</translation>
    </message>
    <message>
        <source>%1 — saving…</source>
        <translation>%1 — enregistrement…</translation>
    </message>
    <message>
        <source>%1 — saved</source>
        <translation>%1 — enregistré</translation>
    </message>
    <message>
        <source>No file is selected for the project. Save the project to a file first.</source>
        <translation>Aucun fichier n’est choisi pour le projet. Enregistrez d’abord le projet dans un fichier.</translation>
    </message>
    <message>
        <source>%1 — open in another window; changes here are not saved</source>
        <translation>%1 — ouvert dans une autre fenêtre, modifications non enregistrées ici</translation>
    </message>
    <message>
        <source>%1 — changed by another program; changes here are not saved</source>
        <translation>%1 — modifié par un autre programme, modifications non enregistrées ici</translation>
    </message>
    <message>
        <source>Unsaved project</source>
        <translation>Projet non enregistré</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>un autre programme</translation>
    </message>
    <message>
        <source>%1 — new</source>
        <translation>%1 — nouveau</translation>
    </message>
    <message>
        <source>%1 is open in another window (%2). Close the project in that window, or save under a different name.</source>
        <translation>%1 est ouvert dans une autre fenêtre (%2). Fermez-le dans cette fenêtre ou enregistrez sous un autre nom.</translation>
    </message>
    <message>
        <source>%1 was changed by another program. Reload the project, or save it under a different name.</source>
        <translation>%1 a été modifié par un autre programme. Rechargez-le ou enregistrez sous un autre nom.</translation>
    </message>
</context>
<context>
    <name>tiller::RangeStatisticsCache</name>
    <message>
        <source>The range contains samples from different robots. Place cursors A and B around data from one robot.</source>
        <translation>La plage contient des échantillons de robots différents. Placez les curseurs A et B dans les données d’un seul robot.</translation>
    </message>
</context>
<context>
    <name>tiller::RecordingsDialog</name>
    <message>
        <source>Recordings</source>
        <translation>Enregistrements</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Choisir le dossier</translation>
    </message>
    <message>
        <source>Search recordings</source>
        <translation>Rechercher des enregistrements</translation>
    </message>
    <message>
        <source>Search name, date, metadata and notes</source>
        <translation>Rechercher nom, date, métadonnées et notes</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>Métadonnées</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>This folder contains no recordings.</source>
        <translation>Ce dossier ne contient aucun enregistrement.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n recording(s)</source>
        <translation>
            <numerusform>%1 sur %n enregistrement</numerusform>
            <numerusform>%1 sur %n enregistrements</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>reading %n file(s)…</source>
        <translation>
            <numerusform>lecture de %n fichier…</numerusform>
            <numerusform>lecture de %n fichiers…</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder with recordings</source>
        <translation>Dossier des enregistrements</translation>
    </message>
</context>
<context>
    <name>tiller::RecoveryPage</name>
    <message>
        <source>Recovery</source>
        <translation>Rétablissement</translation>
    </message>
    <message>
        <source>TCP force</source>
        <translation>Force au TCP</translation>
    </message>
    <message>
        <source>Joint current</source>
        <translation>Courant articulaire</translation>
    </message>
    <message>
        <source>TCP speed</source>
        <translation>Vitesse du TCP</translation>
    </message>
    <message>
        <source>Waiting for data from the robot…</source>
        <translation>En attente de données du robot…</translation>
    </message>
    <message>
        <source>Stopped at X %1, Y %2, Z %3.</source>
        <translation>Arrêt à X %1, Y %2, Z %3.</translation>
    </message>
    <message>
        <source>Suspected joint: %1 (largest deviation from its target current).</source>
        <translation>Articulation suspecte : %1 (plus grand écart par rapport à son courant de consigne).</translation>
    </message>
    <message>
        <source> (%1 s)</source>
        <translation> (%1 s)</translation>
    </message>
    <message>
        <source>Tick the items that you have checked.</source>
        <translation>Cochez les points que vous avez vérifiés.</translation>
    </message>
    <message>
        <source>Command sent; waiting for the robot…</source>
        <translation>Commande envoyée ; en attente du robot…</translation>
    </message>
</context>
<context>
    <name>tiller::RegisterPanel</name>
    <message>
        <source>General purpose registers</source>
        <translation>Registres généraux</translation>
    </message>
    <message>
        <source>Int %1</source>
        <translation>Entier %1</translation>
    </message>
    <message>
        <source>Float %1</source>
        <translation>Réel %1</translation>
    </message>
    <message>
        <source>Int</source>
        <translation>Entier</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Réel</translation>
    </message>
    <message>
        <source>Bit</source>
        <translation>Bit</translation>
    </message>
    <message>
        <source>Input register type</source>
        <translation>Type du registre d’entrée</translation>
    </message>
    <message>
        <source>Input register number</source>
        <translation>Numéro du registre d’entrée</translation>
    </message>
    <message>
        <source>Input register value</source>
        <translation>Valeur pour le registre d’entrée</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Écrire</translation>
    </message>
</context>
<context>
    <name>tiller::ReplayBand</name>
    <message>
        <source>Replay</source>
        <translation>Relecture</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Revenir au direct</translation>
    </message>
    <message>
        <source>Show the current state of the robot. The recording stays open in the plots.</source>
        <translation>Afficher l’état actuel du robot. L’enregistrement reste ouvert dans les tracés.</translation>
    </message>
</context>
<context>
    <name>tiller::RobotPopup</name>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>Popup on the robot</source>
        <translation>Message sur le robot</translation>
    </message>
    <message>
        <source>Tiller could not close the popup. Close the popup on the teach pendant.</source>
        <translation>Tiller n’a pas pu fermer le message. Fermez-le sur le pupitre.</translation>
    </message>
    <message>
        <source>No data from the robot. Close the popup on the teach pendant.</source>
        <translation>Pas de données du robot. Fermez le message sur le pupitre.</translation>
    </message>
    <message numerus="yes">
        <source>%n more popup(s) on the robot.</source>
        <translation>
            <numerusform>%n de plus sur le robot.</numerusform>
            <numerusform>%n de plus sur le robot.</numerusform>
        </translation>
    </message>
    <message>
        <source>A waiting program continues when the popup is closed: keep clear of the arm.</source>
        <translation>Un programme en attente continue à la fermeture du message : restez à distance du bras.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Cacher</translation>
    </message>
    <message>
        <source>Close the popup on the robot</source>
        <translation>Fermer le message sur le robot</translation>
    </message>
    <message>
        <source>Hide the popup</source>
        <translation>Cacher le message</translation>
    </message>
    <message>
        <source>Read the popup first.</source>
        <translation>Lisez d’abord le message.</translation>
    </message>
    <message>
        <source>The popup is being closed.</source>
        <translation>La fenêtre contextuelle est en cours de fermeture.</translation>
    </message>
</context>
<context>
    <name>tiller::RobotSession</name>
    <message>
        <source>Stopped: %1 (%2 ms, %3)</source>
        <translation>Arrêté : %1 (%2 ms, %3)</translation>
    </message>
    <message>
        <source>Connecting to %1 (%2)</source>
        <translation>Connexion à %1 (%2)</translation>
    </message>
    <message>
        <source>Disconnected from %1</source>
        <translation>Déconnecté de %1</translation>
    </message>
    <message>
        <source>In control</source>
        <translation>Contrôlé</translation>
    </message>
    <message>
        <source>Taking control was cancelled by a stop.</source>
        <translation>La prise de contrôle a été annulée par un arrêt.</translation>
    </message>
    <message>
        <source>Connected to %1</source>
        <translation>Connecté à %1</translation>
    </message>
    <message>
        <source>Safety mode is Normal again</source>
        <translation>Le mode de sécurité est de nouveau « Normal »</translation>
    </message>
    <message>
        <source>Program: %1</source>
        <translation>Programme : %1</translation>
    </message>
    <message>
        <source>Program error on line %1, column %2: %3</source>
        <translation>Erreur de programme ligne %1, colonne %2 : %3</translation>
    </message>
    <message>
        <source>Popup on the robot: %1 %2</source>
        <translation>Message sur le robot : %1 %2</translation>
    </message>
    <message>
        <source>The program on the robot is waiting for a response on the teach pendant: %1</source>
        <translation>Le programme du robot attend une réponse sur le pupitre : %1</translation>
    </message>
    <message>
        <source>Not connected to a robot.</source>
        <translation>Connecté à aucun robot.</translation>
    </message>
    <message>
        <source>Waiting for data from %1.</source>
        <translation>En attente de données de %1.</translation>
    </message>
    <message>
        <source>Connecting to %1…</source>
        <translation>Connexion à %1…</translation>
    </message>
    <message>
        <source>No data from the robot. Reconnecting automatically; motion does not resume.</source>
        <translation>Aucune donnée du robot. Reconnexion automatique ; le mouvement ne reprend pas.</translation>
    </message>
    <message>
        <source>Robot data are late. Waiting for new data.</source>
        <translation>Les données du robot sont en retard. En attente de nouvelles données.</translation>
    </message>
    <message>
        <source>Taking control…</source>
        <translation>Prise de contrôle…</translation>
    </message>
    <message>
        <source>Monitor only: this window does not change anything on the robot. STOP still works.</source>
        <translation>Surveillance seule : cette fenêtre ne change rien sur le robot. STOP reste actif.</translation>
    </message>
    <message>
        <source>“Monitor only” is off. Commands to the robot are enabled.</source>
        <translation>« Surveillance seule » est désactivée. Les commandes au robot sont possibles.</translation>
    </message>
    <message>
        <source>%1: refused. %2</source>
        <translation>%1 : refusé. %2</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Prendre le contrôle</translation>
    </message>
    <message>
        <source>Control was lost: the control connection did not respond for 0.5 s or was closed. STOP, Space and Esc still stop the robot. Take control again.</source>
        <translation>Le contrôle a été perdu : la connexion de commande n’a pas répondu pendant 0,5 s ou a été fermée. STOP, Espace et Échap arrêtent toujours le robot. Reprenez le contrôle.</translation>
    </message>
    <message numerus="yes">
        <source>The robot is sending too many messages. %n messages were not shown.</source>
        <translation>
            <numerusform>Le robot envoie trop de messages. %n message n’a pas été affiché.</numerusform>
            <numerusform>Le robot envoie trop de messages. %n messages n’ont pas été affichés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move refused: %1.</source>
        <translation>Mouvement refusé : %1.</translation>
    </message>
    <message>
        <source>Moves are refused. %1.</source>
        <translation>Les mouvements sont refusés. %1.</translation>
    </message>
    <message>
        <source>No data from the robot: the arm may be moving. Reconnecting automatically.</source>
        <translation>Aucune donnée du robot : le bras peut être en mouvement. Reconnexion automatique.</translation>
    </message>
    <message>
        <source>A program is running. Wait until the program ends, or stop the program.</source>
        <translation>Un programme est en cours d&apos;exécution. Attendez qu&apos;il se termine, ou arrêtez-le.</translation>
    </message>
    <message>
        <source>Stopping the other client&apos;s program to take control.</source>
        <translation>Le programme de l&apos;autre client est arrêté pour prendre le contrôle.</translation>
    </message>
    <message>
        <source>The program on the robot is paused.</source>
        <translation>Le programme du robot est en pause.</translation>
    </message>
    <message>
        <source>Robot mode: %1</source>
        <translation>Mode du robot : %1</translation>
    </message>
    <message>
        <source>Stopped: %1 (%2)</source>
        <translation>Arrêté : %1 (%2)</translation>
    </message>
    <message>
        <source>Not stopped: a program is still running (%1). Press STOP again.</source>
        <translation>Pas d’arrêt : un programme est toujours en cours (%1). Appuyez de nouveau sur STOP.</translation>
    </message>
    <message>
        <source>Not stopped: the arm is still moving (%1). Press STOP again.</source>
        <translation>Non arrêté : le bras bouge (%1). Appuyez de nouveau sur STOP.</translation>
    </message>
    <message>
        <source>The robot at %1 is a %2 now. It was a %3 before.</source>
        <translation>Le robot à l’adresse %1 est maintenant un %2. C’était auparavant un %3.</translation>
    </message>
    <message>
        <source>A program from another client has replaced the running program.</source>
        <translation>Un programme d’un autre client a remplacé le programme en cours.</translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot. Taking control ends that program.</source>
        <translation>Un programme d&apos;un autre client a pris le robot. Prendre le contrôle y met fin.</translation>
    </message>
    <message>
        <source>A program from another client has taken over the robot, and control was lost. Taking control again ends that program.</source>
        <translation>Un programme d&apos;un autre client a pris le robot, et le contrôle a été perdu. Reprendre le contrôle met fin à ce programme.</translation>
    </message>
    <message>
        <source>A program from another client is running on the robot.</source>
        <translation>Un programme d&apos;un autre client s&apos;exécute sur le robot.</translation>
    </message>
    <message>
        <source>while moving to point %1 of %2: %3</source>
        <translation>en route vers le point %1 sur %2 : %3</translation>
    </message>
    <message>
        <source>The program from the other client has ended.</source>
        <translation>Le programme de l’autre client est terminé.</translation>
    </message>
    <message>
        <source>The program started while Tiller was not connected, at most %1 s before this entry.</source>
        <translation>Le programme a démarré sans connexion avec Tiller, au plus %1 s avant cette entrée.</translation>
    </message>
</context>
<context>
    <name>tiller::RobotiqLink</name>
    <message>
        <source>Connecting to the gripper…</source>
        <translation>Connexion à la pince…</translation>
    </message>
    <message>
        <source>The gripper does not send any values. Power on the arm. If the problem persists, check the gripper cable at the wrist.</source>
        <translation>La pince n’envoie aucune valeur. Mettez le bras sous tension ; si le problème persiste, vérifiez le câble de la pince au poignet.</translation>
    </message>
    <message>
        <source>The gripper responds again.</source>
        <translation>La pince répond de nouveau.</translation>
    </message>
    <message>
        <source>The gripper is active.</source>
        <translation>La pince est active.</translation>
    </message>
    <message>
        <source>The gripper was not activated. Check that nothing blocks its fingers, then press “Activate” again.</source>
        <translation>La pince n’a pas été activée. Vérifiez que rien ne bloque ses doigts, puis appuyez de nouveau sur Activer.</translation>
    </message>
    <message>
        <source>The gripper holds an object (%1 open).</source>
        <translation>La pince tient un objet (ouverte de %1).</translation>
    </message>
    <message>
        <source>The gripper lost the object.</source>
        <translation>La pince a perdu l’objet.</translation>
    </message>
    <message>
        <source>Gripper: activate</source>
        <translation>Pince : activer</translation>
    </message>
    <message>
        <source>%1 failed. %2</source>
        <translation>Échec : %1. %2</translation>
    </message>
    <message>
        <source>No gripper service responds at %1:%2. Install Robotiq&apos;s URCap on the robot and select the gripper in the robot&apos;s installation.</source>
        <translation>Aucun service de pince ne répond à %1:%2. Installez l’URCap de Robotiq sur le robot et sélectionnez la pince dans son installation.</translation>
    </message>
    <message>
        <source>The gripper is not responding. Check the cable at the wrist and the gripper settings on the Installation tab of the teach pendant. If the problem persists, restart the robot.</source>
        <translation>La pince ne répond pas. Vérifiez le câble au poignet et les réglages de la pince dans l’onglet Installation du boîtier. Si le problème persiste, redémarrez le robot.</translation>
    </message>
    <message>
        <source>The gripper did not accept the command. Activate the gripper. If it is already active, check its settings on the Installation tab of the teach pendant.</source>
        <translation>La pince n’a pas accepté la commande. Activez-la. Si elle est déjà active, vérifiez ses réglages dans l’onglet Installation du boîtier.</translation>
    </message>
    <message>
        <source>The gripper is activating; the command runs afterwards.</source>
        <translation>La pince s’active ; la commande est exécutée ensuite.</translation>
    </message>
    <message>
        <source>The gripper received a motion command before it was active. Press “Activate”.</source>
        <translation>La pince a reçu une commande de mouvement avant d’être active. Appuyez sur Activer.</translation>
    </message>
    <message>
        <source>The gripper is too hot. Let it cool down, then press “Activate”.</source>
        <translation>La pince est trop chaude. Laissez-la refroidir, puis appuyez sur Activer.</translation>
    </message>
    <message>
        <source>The gripper received no command for one second. Check its cable at the wrist, then press “Activate”.</source>
        <translation>La pince n’a reçu aucune commande pendant une seconde. Vérifiez son câble au poignet, puis appuyez sur Activer.</translation>
    </message>
    <message>
        <source>The supply voltage of the gripper is too low. Set the tool voltage to 24 V, then press “Activate”.</source>
        <translation>La tension d’alimentation de la pince est trop basse. Réglez la tension de l’outil à 24 V, puis appuyez sur Activer.</translation>
    </message>
    <message>
        <source>The automatic release of the gripper is in progress. Wait until it is complete, then press “Activate”.</source>
        <translation>L’ouverture automatique de la pince est en cours. Attendez la fin, puis appuyez sur Activer.</translation>
    </message>
    <message>
        <source>The automatic release of the gripper is complete. Press “Activate”.</source>
        <translation>L’ouverture automatique de la pince est terminée. Appuyez sur Activer.</translation>
    </message>
    <message>
        <source>The gripper has an internal fault. Press “Activate”. If the fault returns, contact Robotiq.</source>
        <translation>La pince a un défaut interne. Appuyez sur Activer ; si le défaut revient, contactez Robotiq.</translation>
    </message>
    <message>
        <source>Activation failed. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation>L’activation a échoué. Vérifiez que rien ne bloque les doigts, puis appuyez sur Activer.</translation>
    </message>
    <message>
        <source>The gripper draws too much current. Check that nothing blocks the fingers, then press “Activate”.</source>
        <translation>La pince consomme trop de courant. Vérifiez que rien ne bloque les doigts, puis appuyez sur Activer.</translation>
    </message>
    <message>
        <source>The gripper reports fault %1. Press “Activate”. If the fault returns, see the gripper manual.</source>
        <translation>La pince signale le défaut %1. Appuyez sur Activer ; si le défaut revient, consultez son manuel.</translation>
    </message>
    <message>
        <source>The robot closed the connection to the gripper and may be restarting. Tiller reconnects automatically; the gripper continues to hold its object.</source>
        <translation>Le robot a fermé la connexion à la pince et redémarre peut-être. Tiller se reconnecte automatiquement ; la pince maintient sa prise.</translation>
    </message>
</context>
<context>
    <name>tiller::RouteRunner</name>
    <message>
        <source>The route has no waypoints. Teach or select waypoints first.</source>
        <translation>L’itinéraire ne contient aucun point de passage. Apprenez ou sélectionnez d’abord des points.</translation>
    </message>
    <message>
        <source>A waypoint of the route was deleted from the project. Select the waypoints of the route again.</source>
        <translation>Un point de passage de l’itinéraire a été supprimé du projet. Sélectionnez de nouveau les points de l’itinéraire.</translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation>« %1 » : %2</translation>
    </message>
    <message>
        <source>A loop requires at least two waypoints. Select more waypoints, or clear “Loop”.</source>
        <translation>Une boucle demande au moins deux points de passage. Sélectionnez-en d’autres ou désactivez la boucle.</translation>
    </message>
    <message>
        <source>There is no waypoint before the first waypoint of the route.</source>
        <translation>Il n’y a pas de point de passage avant le premier de l’itinéraire.</translation>
    </message>
</context>
<context>
    <name>tiller::RunBar</name>
    <message>
        <source>Run (hold)</source>
        <translation>Lancer (maintenir)</translation>
    </message>
    <message>
        <source>Run the program (hold)</source>
        <translation>Exécuter le programme, maintenir</translation>
    </message>
    <message>
        <source>Move to start (hold)</source>
        <translation>Au départ (maintenir)</translation>
    </message>
    <message>
        <source>Move to the start position (hold)</source>
        <translation>Aller à la position de départ, maintenir</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lancer</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>No program is selected. Create or select a program first.</source>
        <translation>Aucun programme n’est sélectionné. Créez ou sélectionnez d’abord un programme.</translation>
    </message>
    <message>
        <source>Stops the program</source>
        <translation>Arrête le programme</translation>
    </message>
    <message>
        <source>Runs the program at the programmed speed until it ends or is stopped. The arm also stops when Tiller closes or the connection is lost.</source>
        <translation>Exécute le programme à la vitesse programmée jusqu&apos;à sa fin ou son arrêt. Le bras s&apos;arrête aussi si Tiller se ferme ou si la connexion est perdue.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Finish cycle</source>
        <translation>Finir le cycle</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>No program is running.</source>
        <translation>Aucun programme en cours.</translation>
    </message>
    <message>
        <source>Continues the program</source>
        <translation>Continue le programme</translation>
    </message>
    <message>
        <source>Pauses the program before its next step</source>
        <translation>Met le programme en pause avant l&apos;étape suivante</translation>
    </message>
    <message>
        <source>Pause the program first.</source>
        <translation>Mettez d&apos;abord le programme en pause.</translation>
    </message>
    <message>
        <source>Runs one step and then pauses the program</source>
        <translation>Exécute une étape puis met le programme en pause</translation>
    </message>
    <message>
        <source>The program has no endless loop.</source>
        <translation>Le programme n&apos;a pas de boucle sans fin.</translation>
    </message>
    <message>
        <source>Ends the program before the next cycle of its endless loop</source>
        <translation>Termine le programme avant le prochain cycle de sa boucle sans fin</translation>
    </message>
    <message>
        <source>Start from here</source>
        <translation>D&apos;ici</translation>
    </message>
    <message>
        <source>Select one step.</source>
        <translation>Sélectionnez une étape.</translation>
    </message>
    <message>
        <source>Moves all joints to the start position while the button is held</source>
        <translation>Déplace tous les axes à la position de départ tant que le bouton est maintenu</translation>
    </message>
    <message>
        <source>Continue at %1</source>
        <translation>Reprendre à %1</translation>
    </message>
    <message>
        <source>Continue (hold)</source>
        <translation>Reprendre (maintenir)</translation>
    </message>
    <message>
        <source>The program is paused on the robot. Resume it on the teach pendant.</source>
        <translation>Le programme est en pause sur le robot. Reprenez-le sur le pupitre.</translation>
    </message>
    <message>
        <source>Run program</source>
        <translation>Exécuter le programme</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>The value of “%1” is being changed.</source>
        <translation>La valeur de « %1 » est en cours de modification.</translation>
    </message>
    <message>
        <source>Continue program</source>
        <translation>Continuer le programme</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>From step %1 ✕</source>
        <translation>Dès %1 ✕</translation>
    </message>
    <message>
        <source>Starts the program at the selected step. Move the arm to the start position first.</source>
        <translation>Démarre le programme à l’étape sélectionnée. Amenez d’abord le bras à la position de départ.</translation>
    </message>
    <message>
        <source>Hold “Continue (hold)” to continue.</source>
        <translation>Maintenez « Reprendre (maintenir) » pour reprendre.</translation>
    </message>
    <message>
        <source>The preview did not run %1, so these steps were not checked for collisions and other problems. Test them with “Run (hold)”, or set the inputs and preview the program again.</source>
        <translation>L’aperçu n’a pas exécuté toutes les étapes (%1). Les collisions et autres problèmes dans ces étapes sont inconnus. Testez-les avec « Lancer (maintenir) », ou réglez les entrées et relancez l’aperçu.</translation>
    </message>
    <message>
        <source>A variable was changed. The moves after this change were not previewed, so they were not checked for collisions and other problems.</source>
        <translation>Une variable a été modifiée. Les mouvements qui suivent cette modification n’ont pas été vérifiés dans l’aperçu. Les collisions et autres problèmes sont inconnus.</translation>
    </message>
    <message>
        <source>Runs the program while the button is held, no faster than the jog speed. The program ends when you release the button. If the arm is not at the start position of a complete preview, joint moves are slower so that no possible path exceeds the speed limit.</source>
        <translation>Exécute le programme tant que le bouton est maintenu, au plus à la vitesse de jog. Le programme se termine quand vous relâchez le bouton. Les mouvements articulaires sont plus lents si le bras n’est pas à la position de départ d’un aperçu complet, car la limite de vitesse doit alors être respectée sur toute trajectoire possible.</translation>
    </message>
    <message>
        <source>The program starts at step %1. Press to start from the beginning instead.</source>
        <translation>Le programme commence à l’étape %1. Appuyez pour recommencer depuis le début.</translation>
    </message>
    <message>
        <source>The program started with a jog speed of %1 and cannot continue at a lower speed. Select this speed again, or stop the program.</source>
        <translation>Le programme a démarré avec une vitesse manuelle de %1 et ne peut pas continuer plus lentement. Sélectionnez à nouveau cette vitesse ou arrêtez le programme.</translation>
    </message>
    <message>
        <source>%1 Preview the program with the current inputs, or select a higher jog speed, so that the program can run to the end.</source>
        <translation>%1 Simulez le programme avec les entrées actuelles ou sélectionnez une vitesse manuelle plus élevée pour qu’il puisse aller jusqu’à sa fin.</translation>
    </message>
</context>
<context>
    <name>tiller::SceneDock</name>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>No joint positions to replay</source>
        <translation>Aucune position d’axe à rejouer</translation>
    </message>
    <message>
        <source>Robot model unknown</source>
        <translation>Modèle de robot inconnu</translation>
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
        <translation>Vue par défaut (en perspective)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Look from the front: base X to the right, Z up</source>
        <translation>Regarder de face : X de la base à droite, Z en haut</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Look from the side: base Y to the right, Z up</source>
        <translation>Regarder de côté : Y de la base à droite, Z en haut</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Look from above: base X to the right, Y up</source>
        <translation>Regarder d’en haut : X de la base à droite, Y en haut</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Cadrer</translation>
    </message>
    <message>
        <source>Fit the arm, target and waypoints in the view</source>
        <translation>Ajuster bras, cible et points de passage à la vue</translation>
    </message>
</context>
<context>
    <name>tiller::SceneView</name>
    <message>
        <source>Arm view</source>
        <translation>Vue du bras</translation>
    </message>
    <message>
        <source>Drag or use the arrow keys to rotate the view; hold Shift or the right button to pan. Zoom with the wheel or with plus and minus. Double-click or press Home for the default view. The robot does not move.</source>
        <translation>Glissez ou utilisez les flèches pour tourner la vue ; avec Maj ou le bouton droit pour la déplacer. Zoomez avec la molette ou avec plus et moins. Double-cliquez ou appuyez sur Début pour la vue par défaut. Le robot ne bouge pas.</translation>
    </message>
    <message>
        <source>NO DATA</source>
        <translation>SANS DONNÉES</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Non connecté</translation>
    </message>
    <message>
        <source>ghost “%1” · out of reach</source>
        <translation>fantôme « %1 » · hors de portée</translation>
    </message>
    <message>
        <source>ghost “%1” · reachable · largest rotation %2 %3 · %4 s at %5</source>
        <translation>fantôme « %1 » · accessible · plus grande rotation %2 %3 · %4 s à %5</translation>
    </message>
    <message>
        <source>1 name hidden: zoom in</source>
        <translation>1 nom caché : approchez-vous</translation>
    </message>
    <message numerus="yes">
        <source>%n names hidden: zoom in</source>
        <translation>
            <numerusform>%n nom caché : approchez-vous</numerusform>
            <numerusform>%n noms cachés : approchez-vous</numerusform>
        </translation>
    </message>
    <message>
        <source>ghost “%1” · reachable</source>
        <translation>fantôme « %1 » · accessible</translation>
    </message>
    <message>
        <source>ghost “%1” · %2 · largest rotation %3 %4 · %5 s at %6</source>
        <translation>fantôme « %1 » · %2 · plus grande rotation %3 %4 · %5 s à %6</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Après : %1</translation>
    </message>
    <message>
        <source>Before: %1</source>
        <translation>Avant : %1</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>RELECTURE</translation>
    </message>
    <message>
        <source>LIVE ARM</source>
        <translation>BRAS EN DIRECT</translation>
    </message>
    <message>
        <source>ghost “%1” · taught with a different robot model</source>
        <translation>fantôme « %1 » · appris avec un autre modèle de robot</translation>
    </message>
</context>
<context>
    <name>tiller::SignalStore</name>
    <message>
        <source>compute a signal</source>
        <translation>calculer un signal</translation>
    </message>
    <message>
        <source>%1 is not part of the same RTDE packets as the other signals.</source>
        <translation>%1 n’est pas dans les mêmes paquets RTDE que les autres signaux.</translation>
    </message>
    <message>
        <source>Derived</source>
        <translation>Dérivés</translation>
    </message>
    <message>
        <source>The robot cannot send this many signals at once. Remove other signals first.</source>
        <translation>Le robot ne peut pas envoyer autant de signaux à la fois : retirez d’abord d’autres signaux.</translation>
    </message>
    <message>
        <source>The recording %1 contains no samples. Open a different recording.</source>
        <translation>L’enregistrement %1 ne contient aucun échantillon. Ouvrez un autre enregistrement.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>The history memory is too small to show %1. Increase the memory in the “Layout” menu.</source>
        <translation>La mémoire d’historique est trop petite pour afficher %1 : augmentez-la dans le menu Disposition.</translation>
    </message>
    <message>
        <source>%1 could not be computed completely: %2</source>
        <translation>%1 n’a pas pu être calculé entièrement : %2</translation>
    </message>
</context>
<context>
    <name>tiller::SignalTree</name>
    <message>
        <source>Search signals</source>
        <translation>Chercher des signaux</translation>
    </message>
    <message>
        <source>Robot signals</source>
        <translation>Signaux du robot</translation>
    </message>
    <message>
        <source>New: |F| [N] = norm(…)</source>
        <translation>Nouveau : |F| [N] = norm(…)</translation>
    </message>
    <message>
        <source>Derived signal</source>
        <translation>Signal dérivé</translation>
    </message>
    <message>
        <source>%1: not sent by this robot.</source>
        <translation>%1 : ce robot ne l’envoie pas.</translation>
    </message>
    <message>
        <source>Enter a name, an optional unit in brackets, and an expression that uses signals. Drag signals here to insert their names. Functions: norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ and standard functions. Press Return to create the signal.</source>
        <translation>Saisissez un nom, une unité facultative entre crochets et une expression de signaux. Faites glisser des signaux ici pour insérer leurs noms. Fonctions : norm(a, b, …), deriv(a, 0.02), mean(a, 0.5), median(a, 0.1), integral(a, 0.5), lowpass(a, 10), highpass(a, 1), + − * / ^ et fonctions standard. Entrée crée le signal.</translation>
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
        <translation>Ce robot est simulé. Aucun robot réel ne bouge.</translation>
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
        <translation>Curseur de vitesse</translation>
    </message>
    <message>
        <source>Robot speed slider, 2 to 100 %</source>
        <translation>Curseur de vitesse du robot, 2 à 100 %</translation>
    </message>
    <message>
        <source>SPEED</source>
        <translation>VITESSE</translation>
    </message>
</context>
<context>
    <name>tiller::StatusLine</name>
    <message>
        <source>Recording, project and last message</source>
        <translation>Enregistrement, projet et dernier message</translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation>REC %1</translation>
    </message>
    <message>
        <source>%1 samples · %2 · %3 free</source>
        <translation>%1 valeurs · %2 · %3 libres</translation>
    </message>
    <message>
        <source>Recording stopped</source>
        <translation>Enregistrement terminé</translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation>Pas d’enregistrement</translation>
    </message>
</context>
<context>
    <name>tiller::StepForm</name>
    <message>
        <source>Select one step to edit it.</source>
        <translation>Sélectionnez une étape pour la modifier.</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(aucun)</translation>
    </message>
</context>
<context>
    <name>tiller::StepPalette</name>
    <message>
        <source>Steps to add</source>
        <translation>Étapes disponibles</translation>
    </message>
</context>
<context>
    <name>tiller::StepTree</name>
    <message>
        <source>Program steps</source>
        <translation>Étapes du programme</translation>
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
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Software stop. Not an emergency stop. Power stays on.</source>
        <translation>Arrêt logiciel. Pas un arrêt d’urgence. L’alimentation reste active.</translation>
    </message>
    <message>
        <source>Space and Esc also stop the arm.</source>
        <translation>Espace et Échap arrêtent aussi le bras.</translation>
    </message>
    <message>
        <source>Click to stop the arm. Space and Esc stop the arm only while this window is in control.</source>
        <translation>Cliquez pour arrêter. Espace et Échap n’arrêtent que si cette fenêtre a le contrôle.</translation>
    </message>
    <message>
        <source>Space / Esc</source>
        <translation>Espace / Échap</translation>
    </message>
    <message>
        <source>click</source>
        <translation>clic</translation>
    </message>
    <message>
        <source>not an e-stop</source>
        <translation>pas un arrêt d’urg.</translation>
    </message>
</context>
<context>
    <name>tiller::StopPlot</name>
    <message>
        <source>Maximum in the last five seconds: %1</source>
        <translation>Maximum des cinq dernières secondes : %1</translation>
    </message>
    <message>
        <source>max %1</source>
        <translation>max %1</translation>
    </message>
    <message>
        <source>no data before the stop</source>
        <translation>aucune donnée avant l’arrêt</translation>
    </message>
</context>
<context>
    <name>tiller::TcpPage</name>
    <message>
        <source>In use</source>
        <translation>Utilisé</translation>
    </message>
    <message>
        <source>Enter a name for the TCP.</source>
        <translation>Saisissez un nom pour le TCP.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renommer « %1 » en « %2 »</translation>
    </message>
    <message>
        <source>TCPs</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>No TCPs yet.
Press “From robot” to store the active TCP, or “Teach…” to teach a TCP with the arm.</source>
        <translation>Pas encore de TCP.
Appuyez sur « Du robot » pour enregistrer le TCP actif, ou sur « Apprendre… » pour en apprendre un avec le bras.</translation>
    </message>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>Relative to the flange. Press Return to apply the value to the project. The robot&apos;s TCP does not change.</source>
        <translation>Par rapport à la bride. Entrée l’applique au projet. Le TCP du robot ne change pas.</translation>
    </message>
    <message>
        <source>Set on robot</source>
        <translation>Régler sur le robot</translation>
    </message>
    <message>
        <source>Use this TCP and set it on the robot</source>
        <translation>Utiliser ce TCP et le régler sur le robot</translation>
    </message>
    <message>
        <source>Teach…</source>
        <translation>Apprendre…</translation>
    </message>
    <message>
        <source>Teach a TCP with the arm</source>
        <translation>Apprendre un TCP avec le bras</translation>
    </message>
    <message>
        <source>From robot</source>
        <translation>Du robot</translation>
    </message>
    <message>
        <source>Store the active TCP of the robot</source>
        <translation>Garder le TCP actif du robot</translation>
    </message>
    <message>
        <source>Teach the selected TCP again…</source>
        <translation>Réapprendre le TCP choisi…</translation>
    </message>
    <message>
        <source>Enter new TCP</source>
        <translation>Saisir un nouveau TCP</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>outil</translation>
    </message>
    <message>
        <source>Rename TCP</source>
        <translation>Renommer le TCP</translation>
    </message>
    <message>
        <source>Duplicate TCP</source>
        <translation>Dupliquer le TCP</translation>
    </message>
    <message>
        <source>Delete TCP</source>
        <translation>Supprimer le TCP</translation>
    </message>
    <message>
        <source>Change the TCP “%1”</source>
        <translation>Changer le TCP « %1 »</translation>
    </message>
    <message>
        <source>Teach the TCP “%1” again</source>
        <translation>Réapprendre le TCP « %1 »</translation>
    </message>
    <message>
        <source>Add the TCP “%1”</source>
        <translation>Ajouter le TCP « %1 »</translation>
    </message>
    <message>
        <source>No robot is connected. Connect a robot, or try the simulator.</source>
        <translation>Aucun robot connecté. Connectez-en un, ou essayez le simulateur.</translation>
    </message>
    <message>
        <source>The active TCP of the robot is already stored as “%1”.</source>
        <translation>Le TCP actif du robot est déjà enregistré sous « %1 ».</translation>
    </message>
    <message>
        <source>Teach “%1” again</source>
        <translation>Réapprendre « %1 »</translation>
    </message>
    <message>
        <source>Teach a new TCP</source>
        <translation>Apprendre un nouveau TCP</translation>
    </message>
    <message>
        <source>Select the TCP to set.</source>
        <translation>Choisissez un TCP à régler.</translation>
    </message>
    <message>
        <source>Use the TCP “%1”</source>
        <translation>Utiliser le TCP « %1 »</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller n’a pas le contrôle. Prenez d’abord le contrôle.</translation>
    </message>
    <message>
        <source>Delete the TCP “%1”</source>
        <translation>Supprimer le TCP « %1 »</translation>
    </message>
    <message>
        <source>%1, relative to the flange</source>
        <translation>%1, depuis la bride</translation>
    </message>
    <message>
        <source>%1, active on the robot</source>
        <translation>%1, actif sur le robot</translation>
    </message>
    <message>
        <source>%1, %2 from the robot&apos;s TCP</source>
        <translation>%1, à %2 du TCP du robot</translation>
    </message>
    <message>
        <source>The robot&apos;s TCP differs from “%1”</source>
        <translation>Le TCP du robot diffère de « %1 »</translation>
    </message>
    <message>
        <source>On the robot: %1. In the project: %2. Difference: %3. Nothing was changed.</source>
        <translation>Sur le robot : %1. Dans le projet : %2. Distance : %3. Rien n’a été changé.</translation>
    </message>
    <message>
        <source>Set “%1” on the robot</source>
        <translation>Régler « %1 » sur le robot</translation>
    </message>
    <message>
        <source>Set TCP on robot</source>
        <translation>Régler le TCP du robot</translation>
    </message>
    <message>
        <source>A TCP named “%1” already exists. Choose a different name.</source>
        <translation>Un TCP nommé « %1 » existe déjà. Choisissez un autre nom.</translation>
    </message>
</context>
<context>
    <name>tiller::TcpTeacher</name>
    <message>
        <source>Record pose</source>
        <translation>Prendre la pose</translation>
    </message>
    <message>
        <source>Redo least accurate pose</source>
        <translation>Refaire la pire pose</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Prendre</translation>
    </message>
    <message>
        <source>Keep TCP</source>
        <translation>Garder le TCP</translation>
    </message>
    <message>
        <source>Teach the TCP</source>
        <translation>Apprendre le TCP</translation>
    </message>
    <message>
        <source>Record pose for the tool orientation</source>
        <translation>Prendre la pose d’orientation</translation>
    </message>
    <message>
        <source>Tool orientation</source>
        <translation>Orientation de l’outil</translation>
    </message>
    <message>
        <source>Keep current orientation</source>
        <translation>Orientation inchangée</translation>
    </message>
    <message>
        <source>Orientation from one pose: tool straight down</source>
        <translation>Orientation par une pose : outil droit vers le bas</translation>
    </message>
    <message>
        <source>Orientation from three poses: along +Z, towards +X</source>
        <translation>Orientation par trois poses : selon +Z, vers +X</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Tip at %1. The poses agree within %2 (RMS); pose %3 deviates most, by %4.</source>
        <translation>Pointe à %1. Les poses concordent à %2 (RMS) ; la pose %3 s’écarte le plus, de %4.</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the poses again.</source>
        <translation>Le robot a envoyé une position non valide. Reprenez les poses.</translation>
    </message>
    <message>
        <source>The tool keeps the current orientation.</source>
        <translation>L’outil garde l’orientation actuelle.</translation>
    </message>
    <message>
        <source>Rotate the tool until it points straight down and its X axis is parallel to the base X axis, then record the pose.</source>
        <translation>Tournez l’outil jusqu’à ce qu’il pointe droit vers le bas et que son axe X soit parallèle à l’axe X de la base, puis prenez la pose.</translation>
    </message>
    <message>
        <source>Orientation recorded. Record another pose to replace the orientation.</source>
        <translation>Orientation prise. Reprenez-la pour la remplacer.</translation>
    </message>
    <message>
        <source>Record the pose at the current position. After that, do not rotate the tool: jog along X, Y and Z only.</source>
        <translation>Prenez la pose à la position actuelle. Ne tournez plus l’outil à partir d’ici : déplacez seulement X, Y et Z.</translation>
    </message>
    <message>
        <source>Move the tool along its +Z direction, away from the flange, by at least %1, and record the pose.</source>
        <translation>Déplacez l’outil dans sa direction +Z, en l’éloignant de la bride, d’au moins %1, et prenez la pose.</translation>
    </message>
    <message>
        <source>Now move the tool along its +X direction by at least %1, and record the pose.</source>
        <translation>Déplacez maintenant l’outil dans sa direction +X d’au moins %1 et prenez la pose.</translation>
    </message>
    <message>
        <source>Orientation recorded: %1 along +Z, %2 along +X; maximum flange rotation %3 at pose %4.</source>
        <translation>Orientation prise : %1 selon +Z, %2 selon +X ; rotation maximale de la bride %3 à la pose %4.</translation>
    </message>
    <message>
        <source>The flange rotated by up to %1 (pose %2). Record the three poses again without rotating the tool.</source>
        <translation>La bride a tourné de %1 au plus (pose %2). Reprenez les trois poses sans tourner l’outil.</translation>
    </message>
    <message>
        <source>The distance along +Z is only %1. Record the three poses again, at least %2 apart.</source>
        <translation>La distance selon +Z n’est que de %1. Reprenez les trois poses, espacées d’au moins %2.</translation>
    </message>
    <message>
        <source>The distance along +X is only %1. Record the three poses again, at least %2 apart.</source>
        <translation>La distance selon +X n’est que de %1. Reprenez les trois poses, espacées d’au moins %2.</translation>
    </message>
    <message>
        <source>The three poses are collinear: the third pose is only %1 from the line. Record the three poses again.</source>
        <translation>Les trois poses sont alignées : la troisième n’est qu’à %1 de la droite. Reprenez les trois poses.</translation>
    </message>
    <message>
        <source>The robot sent an invalid position. Record the three poses again.</source>
        <translation>Le robot a envoyé une position non valide. Reprenez les trois poses.</translation>
    </message>
    <message>
        <source>Redo last pose</source>
        <translation>Reprendre la dernière pose</translation>
    </message>
    <message>
        <source>Record pose %1</source>
        <translation>Prendre la pose %1</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>Pose %1</translation>
    </message>
    <message>
        <source>  ◀ least accurate</source>
        <translation>  ◀ la moins précise</translation>
    </message>
    <message>
        <source>Poses can be recorded only while the robot sends data. Connect to a robot, or wait for new data.</source>
        <translation>Les poses ne peuvent être prises que lorsque le robot envoie des données. Connectez-vous à un robot ou attendez de nouvelles données.</translation>
    </message>
    <message>
        <source>The tool orientations are too similar. Record one more pose with the tool tilted by at least 30° in a different direction.</source>
        <translation>Les orientations de l’outil sont trop semblables. Prenez une autre pose, inclinée de 30° ou plus dans une autre direction.</translation>
    </message>
    <message>
        <source>Jog the tip to a fixed, sharp point and record the pose. Record four poses in total, each with the tip on the same point and the tool tilted in a different direction.</source>
        <translation>Amenez la pointe à un point fixe et aigu et prenez la pose. Prenez quatre poses au total, chacune avec la pointe au même point et l’outil incliné dans une autre direction.</translation>
    </message>
    <message numerus="yes">
        <source>Tilt the tool in a different direction, move the tip to the same point again, and record the pose. Poses still needed: %n.</source>
        <translation>
            <numerusform>Inclinez l’outil dans une autre direction, ramenez la pointe au même point et prenez la pose. Poses restantes : %n.</numerusform>
            <numerusform>Inclinez l’outil dans une autre direction, ramenez la pointe au même point et prenez la pose. Poses restantes : %n.</numerusform>
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
        <translation>Charge utile</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positions</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cellule</translation>
    </message>
    <message>
        <source>TCP, payload, positions or cell</source>
        <translation>TCP, charge utile, positions ou cellule</translation>
    </message>
</context>
<context>
    <name>tiller::TravelWatch</name>
    <message>
        <source>%1: %2 left until %3 is %4 from %5</source>
        <translation>%1 : encore %2 jusqu’à ce que %3 soit à %4 de %5</translation>
    </message>
    <message>
        <source>%1: %2 left until the %3 joint limit</source>
        <translation>%1 : reste %2 jusqu’à la limite de %3</translation>
    </message>
    <message>
        <source>%1: %2 left until the reach limit or a singularity</source>
        <translation>%1 : reste %2 jusqu’à la limite de portée ou une singularité</translation>
    </message>
</context>
<context>
    <name>tiller::VariableList</name>
    <message>
        <source>Program variables</source>
        <translation>Variables du programme</translation>
    </message>
    <message>
        <source>The variable list changed during editing, so the value was not applied. Enter the value again.</source>
        <translation>La liste des variables a changé pendant la saisie, la valeur n’a donc pas été appliquée. Saisissez-la à nouveau.</translation>
    </message>
</context>
<context>
    <name>tiller::VariableModel</name>
    <message>
        <source>%1 (changing…)</source>
        <translation>%1 (modification…)</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
</context>
<context>
    <name>tiller::VectorEditor</name>
    <message>
        <source>%1. Press Return to apply the value. The robot does not move.</source>
        <translation>%1. Entrée pour appliquer. Le robot ne bouge pas.</translation>
    </message>
</context>
<context>
    <name>tiller::ViewCard</name>
    <message>
        <source>Collapse</source>
        <translation>Replier</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>The view is too small to expand this card</source>
        <translation>La vue est trop petite pour déplier cette carte</translation>
    </message>
    <message>
        <source>Expand</source>
        <translation>Déplier</translation>
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
        <translation>Dans le repère du point. Appuyez sur Entrée pour appliquer. Seul le point de passage change ; le robot ne bouge pas.</translation>
    </message>
    <message>
        <source>Selected waypoint</source>
        <translation>Point de passage choisi</translation>
    </message>
    <message>
        <source>Waypoint frame</source>
        <translation>Repère du point de passage</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Repères</translation>
    </message>
    <message numerus="yes">
        <source>used in %n steps</source>
        <translation>
            <numerusform>utilisé dans %n étape</numerusform>
            <numerusform>utilisé dans %n étapes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 from the current pose</source>
        <translation>à %1 de la pose actuelle</translation>
    </message>
    <message>
        <source>joints have priority</source>
        <translation>priorité aux articulations</translation>
    </message>
    <message>
        <source>pose has priority</source>
        <translation>priorité à la pose</translation>
    </message>
    <message>
        <source>cell of “%1”</source>
        <translation>emplacement de « %1 »</translation>
    </message>
    <message>
        <source>corner of “%1”</source>
        <translation>coin de « %1 »</translation>
    </message>
    <message>
        <source>home position “%1”</source>
        <translation>origine, « %1 »</translation>
    </message>
    <message>
        <source>position “%1”</source>
        <translation>position « %1 »</translation>
    </message>
    <message>
        <source>Run route</source>
        <translation>Itinéraire</translation>
    </message>
    <message>
        <source>Shows the route controls instead of the values.</source>
        <translation>Affiche les commandes de l’itinéraire au lieu des valeurs.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Shows the values instead of the route controls.</source>
        <translation>Affiche les valeurs au lieu des commandes de l’itinéraire.</translation>
    </message>
    <message>
        <source>TCP “%1”</source>
        <translation>TCP « %1 »</translation>
    </message>
    <message>
        <source>TCP at the flange</source>
        <translation>TCP à la bride</translation>
    </message>
    <message>
        <source>TCP %1 from the flange</source>
        <translation>TCP à %1 de la bride</translation>
    </message>
    <message>
        <source>Reference frame of the waypoint. Changing the frame does not move the waypoint. “—” means no frame: the joint positions have priority.</source>
        <translation>Repère de référence du point de passage. La position dans l’espace ne change pas. « — » : sans repère, les articulations ont priorité</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointDialogs</name>
    <message>
        <source>Select waypoints to change.</source>
        <translation>Choisissez des points à changer.</translation>
    </message>
    <message numerus="yes">
        <source>Change the properties of %n waypoints</source>
        <translation>
            <numerusform>Changer les propriétés de %n point</numerusform>
            <numerusform>Changer les propriétés de %n points</numerusform>
        </translation>
    </message>
    <message>
        <source>Select waypoints to move.</source>
        <translation>Choisissez des points à déplacer.</translation>
    </message>
    <message>
        <source>Change the pattern “%1”</source>
        <translation>Changer le motif « %1 »</translation>
    </message>
    <message>
        <source>Create the pattern “%1”</source>
        <translation>Créer le motif « %1 »</translation>
    </message>
    <message>
        <source>Convert the pattern “%1” to waypoints</source>
        <translation>Convertir le motif « %1 » en points de passage</translation>
    </message>
    <message>
        <source>Select a waypoint that belongs to a pattern.</source>
        <translation>Sélectionnez un emplacement d’un motif.</translation>
    </message>
    <message>
        <source>Delete the pattern “%1”</source>
        <translation>Supprimer le motif « %1 »</translation>
    </message>
    <message>
        <source>Select a waypoint to see its history.</source>
        <translation>Choisissez un point pour voir son historique.</translation>
    </message>
    <message>
        <source>Restore an earlier version of “%1”</source>
        <translation>Restaurer une version antérieure de « %1 »</translation>
    </message>
    <message>
        <source>Import waypoints</source>
        <translation>Importer des points de passage</translation>
    </message>
    <message>
        <source>Waypoint files (*.csv *.txt *.json *.tiller);;All files (*)</source>
        <translation>Points de passage (*.csv *.txt *.json *.tiller);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Export waypoints</source>
        <translation>Exporter des points de passage</translation>
    </message>
    <message>
        <source>CSV file (*.csv);;JSON file (*.json)</source>
        <translation>Fichier CSV (*.csv);;Fichier JSON (*.json)</translation>
    </message>
    <message>
        <source>Import failed</source>
        <translation>Échec de l’importation</translation>
    </message>
    <message>
        <source>%1 is too large. The maximum size of a waypoint file is 64 MB.</source>
        <translation>%1 est trop grand. La taille maximale d’un fichier de points de passage est de 64 Mo.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>point de passage</translation>
    </message>
    <message numerus="yes">
        <source>Import %n waypoints</source>
        <translation>
            <numerusform>Importer %n point</numerusform>
            <numerusform>Importer %n points</numerusform>
        </translation>
    </message>
    <message>
        <source>The project contains no waypoints to export. Teach a waypoint first.</source>
        <translation>Le projet ne contient pas de points de passage à exporter. Apprenez d’abord un point de passage.</translation>
    </message>
    <message>
        <source>Export failed</source>
        <translation>Échec de l’exportation</translation>
    </message>
    <message numerus="yes">
        <source>%n waypoints exported to %1</source>
        <translation>
            <numerusform>%n point écrit dans %1</numerusform>
            <numerusform>%n points écrits dans %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the waypoints to add actions to.</source>
        <translation>Sélectionnez les points de passage auxquels ajouter des actions.</translation>
    </message>
    <message numerus="yes">
        <source>Change the actions at %n waypoints</source>
        <translation>
            <numerusform>Modifier les actions à %n point</numerusform>
            <numerusform>Modifier les actions à %n points</numerusform>
        </translation>
    </message>
    <message>
        <source>Teach three waypoints at the corners of the pattern first.</source>
        <translation>Apprenez d’abord trois points de passage aux coins du motif.</translation>
    </message>
    <message>
        <source>The earlier version cannot be restored because its frame was deleted from the project. Select a different version.</source>
        <translation>La version antérieure ne peut pas être restaurée, car son repère a été supprimé du projet. Sélectionnez une autre version.</translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>Décaler, tourner ou mettre en miroir %n point</numerusform>
            <numerusform>Décaler, tourner ou mettre en miroir %n points</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 contains no waypoints. Choose a different file.</source>
        <translation>Il n’y a pas de points dans %1. Choisissez un autre fichier.</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointEditing</name>
    <message>
        <source>Duplicate “%1”</source>
        <translation>Dupliquer « %1 »</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n waypoints</source>
        <translation>
            <numerusform>Dupliquer %n point de passage</numerusform>
            <numerusform>Dupliquer %n points de passage</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste failed</source>
        <translation>Échec du collage</translation>
    </message>
    <message>
        <source>The clipboard contains no waypoints. Copy waypoints first.</source>
        <translation>Le presse-papiers ne contient pas de points de passage. Copiez d’abord des points de passage.</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>point de passage</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n waypoints</source>
        <translation>
            <numerusform>Coller %n point de passage</numerusform>
            <numerusform>Coller %n points de passage</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::WaypointHistoryDialog</name>
    <message>
        <source>History of “%1”</source>
        <translation>Historique de « %1 »</translation>
    </message>
    <message>
        <source>Changes, newest first</source>
        <translation>Changements, le plus récent d’abord</translation>
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
        <translation>Restaurer la version d’avant cette modification</translation>
    </message>
    <message>
        <source>Name: “%1” → “%2”</source>
        <translation>Nom : « %1 » → « %2 »</translation>
    </message>
    <message>
        <source>Position: moved by %1 (%2, base frame)</source>
        <translation>Position : déplacée de %1 (%2, repère de base)</translation>
    </message>
    <message>
        <source>Joints: largest change %2 (%1)</source>
        <translation>Articulations : plus grand changement %2 (%1)</translation>
    </message>
    <message>
        <source>none (joints have priority)</source>
        <translation>aucun (priorité aux articulations)</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>a deleted frame</source>
        <translation>un repère supprimé</translation>
    </message>
    <message>
        <source>Frame: %1 → %2</source>
        <translation>Repère : %1 → %2</translation>
    </message>
    <message>
        <source>Move: MoveL → MoveJ</source>
        <translation>Type : MoveL → MoveJ</translation>
    </message>
    <message>
        <source>Move: MoveJ → MoveL</source>
        <translation>Type : MoveJ → MoveL</translation>
    </message>
    <message>
        <source>MoveJ speed: %1 → %2</source>
        <translation>Vitesse de MoveJ : %1 → %2</translation>
    </message>
    <message>
        <source>MoveL speed: %1 → %2</source>
        <translation>Vitesse de MoveL : %1 → %2</translation>
    </message>
    <message>
        <source>Blend: %1 → %2</source>
        <translation>Raccordement : %1 → %2</translation>
    </message>
    <message>
        <source>TCP: taught with a different TCP</source>
        <translation>TCP : appris avec un autre TCP</translation>
    </message>
    <message>
        <source>Group: “%1” → “%2”</source>
        <translation>Groupe : « %1 » → « %2 »</translation>
    </message>
    <message>
        <source>Colour: %1 → %2</source>
        <translation>Couleur : %1 → %2</translation>
    </message>
    <message>
        <source>Note: “%1” → “%2”</source>
        <translation>Note : « %1 » → « %2 »</translation>
    </message>
    <message>
        <source>Actions: changed</source>
        <translation>Actions : modifiées</translation>
    </message>
    <message>
        <source>No changes have been recorded for this waypoint.</source>
        <translation>Aucune modification n’a été enregistrée pour ce point de passage.</translation>
    </message>
    <message>
        <source>The version before this change is identical to the current version.</source>
        <translation>La version d’avant cette modification est identique à l’actuelle.</translation>
    </message>
    <message>
        <source>Changes from the version before this change to the current version:</source>
        <translation>Différences entre la version avant cette modification et la version actuelle :</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointModel</name>
    <message>
        <source>✕ joint</source>
        <translation>✕ artic.</translation>
    </message>
    <message>
        <source>✕ frame</source>
        <translation>✕ repère</translation>
    </message>
    <message>
        <source>✕ line</source>
        <translation>✕ ligne</translation>
    </message>
    <message>
        <source>✕ reach</source>
        <translation>✕ portée</translation>
    </message>
    <message>
        <source>Out of reach. Touch up the waypoint closer to the base.</source>
        <translation>Hors de portée. Retouchez le point plus près de la base.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>MoveJ: all joints start and stop together</source>
        <translation>MoveJ : toutes les articulations partent et s’arrêtent ensemble</translation>
    </message>
    <message>
        <source>MoveL: the TCP moves along a straight line</source>
        <translation>MoveL : le TCP se déplace en ligne droite</translation>
    </message>
    <message>
        <source>Joints have priority: the arm returns to the same configuration</source>
        <translation>Priorité aux articulations : le bras revient dans la même configuration</translation>
    </message>
    <message>
        <source>The pose has priority: the waypoint moves with its frame</source>
        <translation>Priorité à la pose : le point se déplace avec son repère</translation>
    </message>
    <message>
        <source>Within reach</source>
        <translation>À portée</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Blend %1</source>
        <translation>Raccord %1</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Portée</translation>
    </message>
    <message>
        <source>Enter a name for the waypoint.</source>
        <translation>Saisissez un nom pour le point de passage.</translation>
    </message>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renommer « %1 » en « %2 »</translation>
    </message>
    <message>
        <source>Change “%1” to MoveJ</source>
        <translation>Passer « %1 » en MoveJ</translation>
    </message>
    <message>
        <source>Change “%1” to MoveL</source>
        <translation>Passer « %1 » en MoveL</translation>
    </message>
    <message>
        <source>Change the pose of “%1”</source>
        <translation>Changer la pose de « %1 »</translation>
    </message>
    <message>
        <source>Use joint positions for “%1”</source>
        <translation>Utiliser les positions articulaires pour « %1 »</translation>
    </message>
    <message>
        <source>Change the frame of “%1” to %2</source>
        <translation>Changer le repère de « %1 » en %2</translation>
    </message>
    <message>
        <source>Set the blend of “%1”</source>
        <translation>Régler le raccordement de « %1 »</translation>
    </message>
    <message>
        <source>Set the speed of “%1”</source>
        <translation>Régler la vitesse de « %1 »</translation>
    </message>
    <message>
        <source>Group: %1</source>
        <translation>Groupe : %1</translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation>Couleur : %1</translation>
    </message>
    <message>
        <source>Name %1, next waypoint</source>
        <translation>Nom %1, point suivant</translation>
    </message>
    <message>
        <source>Actions: %1</source>
        <translation>Actions : %1</translation>
    </message>
    <message>
        <source>Name %1</source>
        <translation>Nom %1</translation>
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
        <translation>✕ modèle</translation>
    </message>
    <message>
        <source>✕ path</source>
        <translation>✕ trajet</translation>
    </message>
    <message>
        <source>The arm cannot reach this pose, so “%1” was not changed. Enter a different pose.</source>
        <translation>Le bras ne peut pas atteindre cette pose. « %1 » n’a pas été modifié. Saisissez une autre pose.</translation>
    </message>
    <message>
        <source>“%1” is not a number. Enter a number.</source>
        <translation>« %1 » n’est pas un nombre. Saisissez un nombre.</translation>
    </message>
    <message>
        <source>%1 is out of range. Enter a value from %2 to %3.</source>
        <translation>%1 est hors plage. Saisissez une valeur de %2 à %3.</translation>
    </message>
    <message>
        <source>A joint would exceed its limit. Touch up the waypoint with a different arm configuration.</source>
        <translation>Une articulation dépasserait sa course. Retouchez le point avec une autre configuration du bras.</translation>
    </message>
    <message>
        <source>The frame of the waypoint is not in this project. Choose a different frame.</source>
        <translation>Le repère du point de passage n’est pas dans ce projet. Choisissez un autre repère.</translation>
    </message>
    <message>
        <source>The straight line from the current position leaves the reach of the arm. Use MoveJ, or start from a different position.</source>
        <translation>La ligne droite depuis la position actuelle sort de la portée du bras. Utilisez MoveJ ou partez d’une autre position.</translation>
    </message>
    <message>
        <source>Waypoint %2 is already named “%1”. Choose a different name.</source>
        <translation>Le point %2 s’appelle déjà « %1 ». Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>The project has no frame named “%1”. Choose a different frame.</source>
        <translation>Le projet n’a pas de repère « %1 ». Choisissez un autre repère.</translation>
    </message>
    <message>
        <source>The project was taught with a different robot model. Use “Adapt project to this robot…” first.</source>
        <translation>Le projet a été appris avec un autre modèle de robot. Utilisez d’abord « Adapter le projet à ce robot… ».</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointProperties</name>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Bleu</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Vert</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>Rose</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Jaune</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Bleu ciel</translation>
    </message>
    <message>
        <source>Only the selected properties are changed.</source>
        <translation>Seules les propriétés sélectionnées sont modifiées.</translation>
    </message>
    <message>
        <source>Properties of “%1”</source>
        <translation>Propriétés de « %1 »</translation>
    </message>
    <message numerus="yes">
        <source>Properties of %n waypoints</source>
        <translation>
            <numerusform>Propriétés de %n point</numerusform>
            <numerusform>Propriétés de %n points</numerusform>
        </translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>MoveJ speed</source>
        <translation>Vitesse de MoveJ</translation>
    </message>
    <message>
        <source>MoveL speed</source>
        <translation>Vitesse de MoveL</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Raccordement</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointSearch</name>
    <message>
        <source>Find waypoints</source>
        <translation>Chercher des points</translation>
    </message>
    <message>
        <source>Find waypoints by name, group or note</source>
        <translation>Chercher des points par nom, groupe ou note</translation>
    </message>
    <message>
        <source>Name, group or note</source>
        <translation>Nom, groupe ou note</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout montrer</translation>
    </message>
    <message>
        <source>Show all waypoints</source>
        <translation>Montrer tous les points</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n trouvé</numerusform>
            <numerusform>%n trouvés</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tiller::WaypointShift</name>
    <message>
        <source>Transformation type</source>
        <translation>Type de transformation</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Miroir</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Tool of each waypoint</source>
        <translation>Outil de chaque point de passage</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Offset X, Y, Z</source>
        <translation>Décalage X, Y, Z</translation>
    </message>
    <message>
        <source>Offset %1</source>
        <translation>Décalage %1</translation>
    </message>
    <message>
        <source>Rotation axis or mirror normal</source>
        <translation>Axe de rotation ou normale du miroir</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>The arm cannot reach these waypoints after the move: %1. Choose a different offset, rotation or mirror plane. No waypoint will be moved.</source>
        <translation>Le bras ne peut pas atteindre ces points de passage après le déplacement : %1. Choisissez un autre décalage, une autre rotation ou un autre plan de symétrie. Aucun point de passage ne sera déplacé.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the moved waypoints will be out of reach. They will be kept and marked.</source>
        <translation>
            <numerusform>%n d’entre eux serait hors de portée. Il est conservé et marqué.</numerusform>
            <numerusform>%n d’entre eux seraient hors de portée. Ils sont conservés et marqués.</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirrors across the plane through the origin that is perpendicular to the axis. The tool approaches from the mirrored side.</source>
        <translation>Symétrie par rapport au plan passant par l’origine et perpendiculaire à l’axe. L’outil approche du côté symétrique.</translation>
    </message>
    <message>
        <source>All waypoints remain within reach.</source>
        <translation>Tous restent à portée.</translation>
    </message>
    <message numerus="yes">
        <source>Offset, rotate or mirror %n waypoints</source>
        <translation>
            <numerusform>Décaler, tourner ou mettre en miroir %n point</numerusform>
            <numerusform>Décaler, tourner ou mettre en miroir %n points</numerusform>
        </translation>
    </message>
    <message>
        <source>The frame of a selected waypoint is not in the project. Choose a different frame for the waypoint first.</source>
        <translation>Le repère d’un point de passage sélectionné n’est pas dans le projet. Choisissez d’abord un autre repère pour ce point.</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointTable</name>
    <message>
        <source>Waypoints</source>
        <translation>Points de passage</translation>
    </message>
</context>
<context>
    <name>tiller::WaypointsTab</name>
    <message>
        <source>Waypoints</source>
        <translation>Points de passage</translation>
    </message>
    <message>
        <source>Teach here  T</source>
        <translation>Apprendre ici  T</translation>
    </message>
    <message>
        <source>Teach here</source>
        <translation>Apprendre ici</translation>
    </message>
    <message>
        <source>Touch up  U</source>
        <translation>Retoucher  U</translation>
    </message>
    <message>
        <source>Touch up</source>
        <translation>Retoucher</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>No waypoints yet.
Jog the arm to a position and press “Teach here” (T).</source>
        <translation>Pas encore de points de passage.
Amenez le bras à une position et appuyez sur « Apprendre ici » (T).</translation>
    </message>
    <message>
        <source>Select a waypoint to go to.</source>
        <translation>Choisissez un point de passage où aller.</translation>
    </message>
    <message>
        <source>Tiller is not in control. Take control first.</source>
        <translation>Tiller n’a pas le contrôle. Prenez d’abord le contrôle.</translation>
    </message>
    <message>
        <source>Add the current position after the selection (T)</source>
        <translation>Ajouter la position actuelle après la sélection (T)</translation>
    </message>
    <message>
        <source>Replace the selected waypoint with the current position (U)</source>
        <translation>Remplacer le point sélectionné par la position actuelle (U)</translation>
    </message>
    <message>
        <source>Select a waypoint to touch up.</source>
        <translation>Choisissez un point de passage à retoucher.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Descendre</translation>
    </message>
    <message>
        <source>Copy as table</source>
        <translation>Copier en tableau</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>waypoint</source>
        <translation>point de passage</translation>
    </message>
    <message>
        <source>Teach “%1”</source>
        <translation>Apprendre « %1 »</translation>
    </message>
    <message>
        <source>The current position is %1 away (%2, base frame). Largest joint change: %3 %4.</source>
        <translation>La position actuelle est à %1 (%2, repère de base). Plus grand changement articulaire : %3 %4.</translation>
    </message>
    <message>
        <source>Touch up “%1”?</source>
        <translation>Retoucher « %1 » ?</translation>
    </message>
    <message>
        <source>Touch up “%1”</source>
        <translation>Retoucher « %1 »</translation>
    </message>
    <message>
        <source>Path recorded</source>
        <translation>Trajectoire enregistrée</translation>
    </message>
    <message>
        <source>Import waypoints…</source>
        <translation>Importer des points de passage…</translation>
    </message>
    <message>
        <source>Export waypoints…</source>
        <translation>Exporter des points de passage…</translation>
    </message>
    <message>
        <source>Find waypoints</source>
        <translation>Chercher des points de passage</translation>
    </message>
    <message>
        <source>Group, colour, note, speeds…</source>
        <translation>Groupe, couleur, note, vitesses…</translation>
    </message>
    <message>
        <source>Offset, rotate or mirror…</source>
        <translation>Décaler, tourner ou mettre en miroir…</translation>
    </message>
    <message>
        <source>History…</source>
        <translation>Historique…</translation>
    </message>
    <message>
        <source>Convert pattern to waypoints</source>
        <translation>Convertir le motif en points de passage</translation>
    </message>
    <message>
        <source>Delete pattern and its waypoints</source>
        <translation>Supprimer le motif et ses points</translation>
    </message>
    <message>
        <source>Actions…</source>
        <translation>Actions…</translation>
    </message>
    <message>
        <source>Import and export</source>
        <translation>Importer et exporter</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajectoire</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projet</translation>
    </message>
    <message>
        <source>Taught “%1”</source>
        <translation>« %1 » appris</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Create or edit pattern…</source>
        <translation>Créer ou modifier un motif…</translation>
    </message>
    <message>
        <source>The frame of “%1” is not in this project. Choose a different frame first.</source>
        <translation>Le repère de « %1 » n’est pas dans ce projet. Choisissez d’abord un autre repère.</translation>
    </message>
</context>
<context>
    <name>tiller::app::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Rechercher des commandes</translation>
    </message>
    <message>
        <source>Type a command or keyword</source>
        <translation>Saisissez une commande ou un mot-clé</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Commandes trouvées</translation>
    </message>
    <message>
        <source>not available now</source>
        <translation>indisponible pour l’instant</translation>
    </message>
</context>
<context>
    <name>tiller::app::ConnectDialog</name>
    <message>
        <source>Enter the robot&apos;s address, as shown on the teach pendant under About.</source>
        <translation>Saisissez l’adresse du robot, comme le pupitre la montre sous À propos.</translation>
    </message>
    <message>
        <source>An IP address consists of four numbers from 0 to 255, e.g. 192.168.0.10.</source>
        <translation>Une adresse IP comporte quatre nombres de 0 à 255, p. ex. 192.168.0.10.</translation>
    </message>
    <message>
        <source>A host name contains only letters, digits, dots and hyphens.</source>
        <translation>Un nom d’hôte ne contient que des lettres, des chiffres, des points et des traits d’union.</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Oublier</translation>
    </message>
    <message>
        <source>Start the simulated robot</source>
        <translation>Démarrer le robot simulé</translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation>Ouvrir un exemple…</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connecter</translation>
    </message>
    <message>
        <source>Before you move a real arm: keep everyone out of its reach, keep the emergency stop within reach, check the payload and the TCP, and start slowly. STOP in this window is not an emergency stop.</source>
        <translation>Avant de déplacer un bras réel : tenez tout le monde hors de sa portée, gardez l’arrêt d’urgence à portée de main, vérifiez la charge utile et le TCP, et commencez lentement. STOP dans cette fenêtre n’est pas un arrêt d’urgence.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Ouvrir un projet…</translation>
    </message>
    <message>
        <source>Opens a project without a robot, to view and edit waypoints and programs.</source>
        <translation>Ouvre un projet sans robot, pour voir et modifier les points de passage et les programmes.</translation>
    </message>
    <message>
        <source>Try the simulator</source>
        <translation>Essayer le simulateur</translation>
    </message>
    <message>
        <source>A simulated UR5e that runs in Tiller. All functions are available without risk.</source>
        <translation>Un UR5e simulé qui s’exécute dans Tiller. Toutes les fonctions sont disponibles sans risque.</translation>
    </message>
    <message>
        <source>Starts the simulated robot and opens a project with taught waypoints.</source>
        <translation>Démarre le robot simulé et ouvre un projet avec des points de passage appris.</translation>
    </message>
    <message>
        <source>Connect to a robot</source>
        <translation>Connecter un robot</translation>
    </message>
    <message>
        <source>Address or host name of the robot</source>
        <translation>Adresse ou nom d’hôte du robot</translation>
    </message>
    <message>
        <source>Display name of the robot</source>
        <translation>Nom affiché du robot</translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation>UR5e du labo</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Recently connected robots</source>
        <translation>Robots connectés récemment</translation>
    </message>
    <message>
        <source>Removes the selected robot from this list (Delete). The robot itself is not affected.</source>
        <translation>Retire le robot sélectionné de cette liste (Suppr). Le robot n’est pas modifié.</translation>
    </message>
</context>
<context>
    <name>tiller::app::Demonstration</name>
    <message>
        <source>Cannot create the folder %1. Choose a folder that you have permission to write to.</source>
        <translation>Impossible de créer le dossier %1. Choisissez un dossier où vous avez le droit d’écrire.</translation>
    </message>
    <message>
        <source>connect</source>
        <translation>connecter</translation>
    </message>
    <message>
        <source>power on</source>
        <translation>mettre sous tension</translation>
    </message>
    <message>
        <source>release the brakes</source>
        <translation>desserrer les freins</translation>
    </message>
    <message>
        <source>take control</source>
        <translation>prendre le contrôle</translation>
    </message>
    <message>
        <source>start recording</source>
        <translation>commencer l’enregistrement</translation>
    </message>
    <message>
        <source>teach the first waypoint</source>
        <translation>apprendre le premier point de passage</translation>
    </message>
    <message>
        <source>jog X+ in Base for 50 mm</source>
        <translation>aller en X+ en Base sur 50 mm</translation>
    </message>
    <message>
        <source>teach the second waypoint</source>
        <translation>apprendre le second point de passage</translation>
    </message>
    <message>
        <source>move to the first waypoint (button held)</source>
        <translation>aller au premier point de passage (tenu)</translation>
    </message>
    <message>
        <source>digital output 0 on</source>
        <translation>sortie numérique 0 activée</translation>
    </message>
    <message>
        <source>digital output 0 off</source>
        <translation>sortie numérique 0 désactivée</translation>
    </message>
    <message>
        <source>take the screenshots</source>
        <translation>prendre les captures d’écran</translation>
    </message>
    <message>
        <source>Cannot write the screenshots to %1. Check the permissions of the folder and the free disk space.</source>
        <translation>Impossible d’écrire les captures d’écran dans %1. Vérifiez les droits du dossier et l’espace disque libre.</translation>
    </message>
    <message>
        <source>stop recording</source>
        <translation>arrêter l’enregistrement</translation>
    </message>
    <message>
        <source>%1: not completed within %2 s (%3)</source>
        <translation>%1 : non terminé en %2 s (%3)</translation>
    </message>
    <message>
        <source>the robot reported no reason</source>
        <translation>le robot n’a indiqué aucune raison</translation>
    </message>
    <message>
        <source>pressed again        %1 times: the motion had stopped before the button was released</source>
        <translation>nouvel appui         %1 fois : le mouvement s’était arrêté avant le relâchement du bouton</translation>
    </message>
    <message>
        <source>jogged               </source>
        <translation>déplacé               </translation>
    </message>
    <message>
        <source>release to standstill </source>
        <translation>du lâcher à l’arrêt </translation>
    </message>
    <message>
        <source>packets              </source>
        <translation>paquets              </translation>
    </message>
    <message>
        <source> received, </source>
        <translation> reçus, </translation>
    </message>
    <message>
        <source> late, </source>
        <translation> en retard, </translation>
    </message>
    <message>
        <source> lost
</source>
        <translation> perdus
</translation>
    </message>
    <message>
        <source>recorded             </source>
        <translation>enregistré             </translation>
    </message>
    <message>
        <source> rows, </source>
        <translation> lignes, </translation>
    </message>
    <message>
        <source>files                </source>
        <translation>fichiers                </translation>
    </message>
    <message>
        <source>the window has no button “%1”</source>
        <translation>la fenêtre n’a pas de bouton « %1 »</translation>
    </message>
    <message>
        <source>release the jog button</source>
        <translation>relâcher le bouton de déplacement</translation>
    </message>
    <message>
        <source>release the “Go to” button</source>
        <translation>relâcher le bouton « Aller à »</translation>
    </message>
</context>
<context>
    <name>tiller::app::DeviceSettings</name>
    <message>
        <source>Jog device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Test device…</source>
        <translation>Tester l’appareil…</translation>
    </message>
    <message>
        <source>Shows the live values of each device and the direction in which the arm would move.</source>
        <translation>Affiche les valeurs actuelles de chaque appareil et la direction dans laquelle le bras irait.</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>Manette</translation>
    </message>
    <message>
        <source>SpaceMouse</source>
        <translation>SpaceMouse</translation>
    </message>
    <message>
        <source>%1 dead zone</source>
        <translation>Zone morte : %1</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Deflection below which the device does not move the arm.</source>
        <translation>Déviation en dessous de laquelle l’appareil ne déplace pas le bras.</translation>
    </message>
    <message>
        <source>%1 curve</source>
        <translation>Courbe : %1</translation>
    </message>
    <message>
        <source>exponent </source>
        <translation>exposant </translation>
    </message>
    <message>
        <source>1: linear. Higher values: finer near the centre, faster at full deflection.</source>
        <translation>1 : linéaire. Plus haut : plus fin près du centre, plus rapide en fin de course.</translation>
    </message>
    <message>
        <source>Dominant axis only</source>
        <translation>Axe dominant seulement</translation>
    </message>
    <message>
        <source>%1: dominant axis only</source>
        <translation>%1 : axe dominant seulement</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>Zone morte</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>No gamepad or SpaceMouse found. Connect a device. Tiller detects the device automatically.</source>
        <translation>Aucune manette ni SpaceMouse trouvée. Branchez-en une ; elle est détectée automatiquement.</translation>
    </message>
    <message>
        <source>The device moves the arm only while the hold-to-run button is held. The selection is not stored: after a restart, no device moves the arm.</source>
        <translation>Déplace le bras seulement tant que le bouton de validation est maintenu. Non enregistré : après un redémarrage, aucun appareil ne déplace le bras.</translation>
    </message>
</context>
<context>
    <name>tiller::app::DockStage</name>
    <message>
        <source>No panels are shown. Select a perspective at the lower right, or show a panel from the View menu.</source>
        <translation>Aucun panneau n’est affiché. Choisissez une perspective en bas à droite, ou affichez un panneau par le menu Vue.</translation>
    </message>
</context>
<context>
    <name>tiller::app::HelpPage</name>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>Exercices</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuel (en anglais)</translation>
    </message>
    <message>
        <source>Jogging and keys</source>
        <translation>Déplacement et touches</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>&lt;h2&gt;The manual is not installed on this PC&lt;/h2&gt;&lt;p&gt;The Debian package of Tiller contains the manual. To add the manual to your own build, install the package python3-sphinx:&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;Then build again. You can also read the pages as text in the folder packaging/manual of the source code. The page “Jogging and keys” of this window contains the jogging rules and all shortcuts.&lt;/p&gt;</source>
        <translation>&lt;h2&gt;Le manuel n’est pas installé sur cet ordinateur&lt;/h2&gt;&lt;p&gt;Le paquet Debian de Tiller le contient. Pour l’ajouter à votre propre compilation, installez le paquet python3-sphinx :&lt;/p&gt;&lt;pre&gt;apt-get install python3-sphinx&lt;/pre&gt;&lt;p&gt;Compilez ensuite de nouveau. Vous pouvez aussi lire ses pages comme du texte dans le dossier packaging/manual du code source. Les règles du déplacement et toutes les touches sont sur l’autre page de cette fenêtre.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;h2&gt;Moving the arm&lt;/h2&gt;&lt;p&gt;The arm moves while you hold a jog button, and stops when you release it. It also stops when&lt;/p&gt;&lt;ul&gt;&lt;li&gt;the pointer leaves the button, a different mouse button is pressed, or a second input device is used;&lt;/li&gt;&lt;li&gt;a modifier or an opposite key is pressed while a keyboard key is held;&lt;/li&gt;&lt;li&gt;the window loses focus, a dialog or menu opens, or the frame, speed, step or tab changes;&lt;/li&gt;&lt;li&gt;data from the robot are late, Tiller hangs, or the robot mode, the safety mode or Remote control changes;&lt;/li&gt;&lt;li&gt;the screen is locked, the PC goes to sleep, or the input device is unplugged or stops sending data;&lt;/li&gt;&lt;li&gt;the key-state check fails: on X11, Tiller checks every 10 ms with the display server that the button or key is still pressed. If the button or key is not pressed, or if the server does not respond for 100 ms, the motion ends. If the check is not available, the header and Settings show a note;&lt;/li&gt;&lt;li&gt;the maximum hold time is reached: %1 s for a jog (Settings), five minutes for Freedrive, the duration of the move plus 5 s for a move to a position. The last 3 s are counted down.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;After a stop, press the button or key again to move the arm. While Tiller is in control, &lt;b&gt;Space&lt;/b&gt; and &lt;b&gt;Esc&lt;/b&gt; stop the arm from every window, dialog and text field. When Tiller is not in control, they act on the focused element; click &lt;b&gt;STOP&lt;/b&gt; to stop a program from another client. This is a software stop, not an emergency stop: keep the emergency stop within reach.&lt;/p&gt;&lt;p&gt;Hold &lt;b&gt;Ctrl&lt;/b&gt; for one-tenth of the speed, or &lt;b&gt;Shift&lt;/b&gt; for three times the speed, up to the speed cap. On a keyboard without Latin letters, the letters below refer to key positions on a US keyboard.&lt;/p&gt;&lt;h2&gt;Commands&lt;/h2&gt;</source>
        <translation>&lt;h2&gt;Déplacer le bras&lt;/h2&gt;&lt;p&gt;Le bras bouge tant que vous maintenez un bouton de déplacement, et s’arrête quand vous le relâchez. Il s’arrête aussi quand&lt;/p&gt;&lt;ul&gt;&lt;li&gt;le pointeur quitte le bouton, un autre bouton de souris est pressé ou un second périphérique est utilisé ;&lt;/li&gt;&lt;li&gt;un modificateur ou la touche contraire est enfoncé pendant qu’une touche du clavier est maintenue ;&lt;/li&gt;&lt;li&gt;la fenêtre perd le focus, un dialogue ou un menu s’ouvre, ou le repère, la vitesse, le pas ou l’onglet change ;&lt;/li&gt;&lt;li&gt;les données du robot sont en retard, ce programme ne répond plus, ou le robot quitte « En marche », son mode de sécurité ou la commande à distance ;&lt;/li&gt;&lt;li&gt;l’écran est verrouillé, le PC se met en veille, ou le périphérique est débranché ou n’envoie plus de données ;&lt;/li&gt;&lt;li&gt;le contrôle de touche échoue : sous X11, Tiller vérifie toutes les 10 ms auprès du serveur d’affichage que le bouton ou la touche est encore enfoncé. Si ce n’est pas le cas, ou si le serveur ne répond pas pendant 100 ms, le mouvement se termine. Si ce contrôle n’est pas disponible, l’en-tête et les réglages l’indiquent ;&lt;/li&gt;&lt;li&gt;la durée maximale d’appui est atteinte : %1 s pour un déplacement manuel (réglages), cinq minutes pour Freedrive, la durée du mouvement plus 5 s pour aller à une position. Les 3 dernières secondes sont décomptées.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;Après un arrêt, un nouvel appui est nécessaire. Tant que Tiller a le contrôle, &lt;b&gt;Espace&lt;/b&gt; et &lt;b&gt;Échap&lt;/b&gt; arrêtent le bras depuis chaque fenêtre, dialogue et champ de texte. Quand Tiller n’a pas le contrôle, ils agissent sur l’élément qui a le focus ; cliquez sur &lt;b&gt;STOP&lt;/b&gt; pour arrêter un programme d’un autre client. C’est un arrêt logiciel, pas un arrêt d’urgence : gardez l’arrêt d’urgence à portée de main.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl&lt;/b&gt; rend le mouvement dix fois plus fin, &lt;b&gt;Maj&lt;/b&gt; trois fois plus rapide, mais jamais au-dessus du plafond. Sur un clavier sans lettres latines, une lettre ci-dessous désigne sa position sur un clavier américain.&lt;/p&gt;&lt;h2&gt;Commandes&lt;/h2&gt;</translation>
    </message>
</context>
<context>
    <name>tiller::app::ImportDialog</name>
    <message>
        <source>Colours, sizes and units</source>
        <translation>Couleurs, tailles et unités</translation>
    </message>
    <message>
        <source>Speed cap and maximum hold time</source>
        <translation>Plafond de vitesse et durée maximale de maintien</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>Gamepad and SpaceMouse</source>
        <translation>Manette et SpaceMouse</translation>
    </message>
    <message>
        <source>Robots and their grippers</source>
        <translation>Robots et leurs pinces</translation>
    </message>
    <message>
        <source>I/O names and scales</source>
        <translation>Noms et échelles des entrées et sorties</translation>
    </message>
    <message>
        <source>Window layout</source>
        <translation>Disposition de la fenêtre</translation>
    </message>
    <message>
        <source>Other settings</source>
        <translation>Autres réglages</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Importer des réglages</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed.</source>
        <translation>%1 n’a pas été importé. Rien n’a été changé.</translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1:</source>
        <translation>Les réglages sélectionnés sont remplacés par ceux de %1 :</translation>
    </message>
    <message>
        <source>The selected settings are replaced by the settings in %1 (written by Tiller %2):</source>
        <translation>Les réglages sélectionnés sont remplacés par ceux de %1 (écrit par Tiller %2) :</translation>
    </message>
    <message>
        <source>%1: identical</source>
        <translation>%1 : identique</translation>
    </message>
    <message>
        <source>%1: not in the file</source>
        <translation>%1 : absent du fichier</translation>
    </message>
    <message>
        <source>%1: %2 in Tiller, %3 in the file</source>
        <translation>%1 : %2 dans Tiller, %3 dans le fichier</translation>
    </message>
    <message>
        <source>The replaced settings are saved to a separate file, which can be imported again.</source>
        <translation>Les réglages remplacés sont enregistrés dans un fichier à part, qui peut être réimporté.</translation>
    </message>
    <message>
        <source>All settings in the file match the current settings.</source>
        <translation>Tous les réglages du fichier correspondent aux réglages actuels.</translation>
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
        <translation>Clavier désarmé</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Tracés</translation>
    </message>
    <message>
        <source>Waypoints</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Repères</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/S</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>%1 disconnected. The arm was stopped.</source>
        <translation>%1 débranché. Le bras a été arrêté.</translation>
    </message>
    <message>
        <source>%1 stopped sending data while it was moving the arm. The arm was stopped. Release the device; if the problem persists, reconnect it.</source>
        <translation>%1 a cessé d’envoyer des données pendant le mouvement du bras. Le bras a été arrêté. Lâchez l’appareil ; si le problème persiste, rebranchez-le.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Open recent project</source>
        <translation>Ouvrir un projet récent</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Ouvrir un projet…</translation>
    </message>
    <message>
        <source>Opens a project file.</source>
        <translation>Ouvre un fichier de projet.</translation>
    </message>
    <message>
        <source>Open sample project…</source>
        <translation>Ouvrir un projet d’exemple…</translation>
    </message>
    <message>
        <source>Opens a copy of a sample project to try on the simulated robot.</source>
        <translation>Ouvre une copie d’un projet d’exemple à essayer sur le robot simulé.</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>Enregistrer le projet sous…</translation>
    </message>
    <message>
        <source>Saves the project to a different file, and saves all further changes to that file automatically.</source>
        <translation>Enregistre maintenant dans ce fichier, puis chaque modification automatiquement.</translation>
    </message>
    <message>
        <source>Show waypoints</source>
        <translation>Montrer les points de passage</translation>
    </message>
    <message>
        <source>Show frames</source>
        <translation>Montrer les repères</translation>
    </message>
    <message>
        <source>Show I/O</source>
        <translation>Montrer les E/S</translation>
    </message>
    <message>
        <source>Show log</source>
        <translation>Montrer le journal</translation>
    </message>
    <message>
        <source>Shows this tab.</source>
        <translation>Affiche cet onglet.</translation>
    </message>
    <message>
        <source>Show gripper</source>
        <translation>Montrer la pince</translation>
    </message>
    <message>
        <source>Shows the Gripper page of the I/O tab.</source>
        <translation>Affiche la page Pince de l’onglet E/S.</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Réinitialiser la disposition</translation>
    </message>
    <message>
        <source>Restores the panel layout of the current perspective.</source>
        <translation>Rétablit la disposition des panneaux de la perspective actuelle.</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Couleurs claires</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Couleurs sombres</translation>
    </message>
    <message>
        <source>Changes the colour theme. The setting is stored.</source>
        <translation>Change le thème de couleurs. Le réglage est enregistré.</translation>
    </message>
    <message>
        <source>Zero the force in the plots, or show the measured force</source>
        <translation>Mettre à zéro la force dans les tracés, ou la montrer telle que mesurée</translation>
    </message>
    <message>
        <source>Subtracts the current TCP force in the plots. Press again to show the measured force.</source>
        <translation>Soustrait la force TCP actuelle dans les tracés. Appuyez de nouveau pour afficher la force mesurée.</translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation>Commandes…</translation>
    </message>
    <message>
        <source>Finds a command by name.</source>
        <translation>Trouve une commande par son nom.</translation>
    </message>
    <message>
        <source>Settings…</source>
        <translation>Réglages…</translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation>Exporter les réglages…</translation>
    </message>
    <message>
        <source>Saves all settings to one file, for another computer or as a backup.</source>
        <translation>Enregistre tous les réglages dans un fichier, pour un autre ordinateur ou comme sauvegarde.</translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation>Importer des réglages…</translation>
    </message>
    <message>
        <source>Shows which settings a file will replace, then imports them.</source>
        <translation>Affiche les réglages qu’un fichier remplacera, puis les importe.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Stops the arm, ends the connection and closes the window.</source>
        <translation>Arrête le bras, termine la connexion et ferme la fenêtre.</translation>
    </message>
    <message>
        <source>Load program</source>
        <translation>Charger un programme</translation>
    </message>
    <message>
        <source>Name of the program on the robot, as shown on the teach pendant</source>
        <translation>Nom du programme sur le robot, tel qu’affiché sur le pupitre</translation>
    </message>
    <message>
        <source>Name of the program on the robot, e.g. pick.urp</source>
        <translation>Nom du programme sur le robot, p. ex. pick.urp</translation>
    </message>
    <message>
        <source>Speed cap set to %1</source>
        <translation>Plafond de vitesse réglé à %1</translation>
    </message>
    <message>
        <source>A recording is running. Stop the recording first.</source>
        <translation>Un enregistrement est en cours. Arrêtez-le d’abord.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message numerus="yes">
        <source>The cell has more boxes or planes than the simulated robot supports: %n are ignored.</source>
        <translation>
            <numerusform>%n boîte ou plan de la cellule dépasse la limite du robot simulé, qui l’ignore.</numerusform>
            <numerusform>%n boîtes ou plans de la cellule dépassent la limite du robot simulé, qui les ignore.</numerusform>
        </translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Signaler un problème…</translation>
    </message>
    <message>
        <source>Shows versions, log and settings, then saves them to one file for support.</source>
        <translation>Affiche versions, journal et réglages, puis les enregistre dans un fichier pour l’assistance.</translation>
    </message>
    <message>
        <source>Report saved: %1</source>
        <translation>Rapport enregistré : %1</translation>
    </message>
    <message>
        <source>Tiller closed unexpectedly</source>
        <translation>Tiller s’est fermé de façon inattendue</translation>
    </message>
    <message>
        <source>Tiller saved a crash log. You can attach it to a problem report.</source>
        <translation>Tiller a enregistré un journal de plantage. Vous pouvez le joindre à un rapport de problème.</translation>
    </message>
    <message>
        <source>Opens the manual page for the focused control, the list of commands and shortcuts, and the jogging rules.</source>
        <translation>Ouvre la page du manuel de l’élément actif, la liste des commandes et raccourcis, et les règles du déplacement manuel.</translation>
    </message>
    <message>
        <source>The settings could not be saved. %1</source>
        <translation>Impossible d’enregistrer les réglages. %1</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Annulé : %1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>Rétabli : %1</translation>
    </message>
    <message>
        <source>Adapt project to this robot…</source>
        <translation>Adapter le projet à ce robot…</translation>
    </message>
    <message>
        <source>Take control</source>
        <translation>Prendre le contrôle</translation>
    </message>
    <message>
        <source>A program is paused on the robot.</source>
        <translation>Un programme est en pause sur le robot.</translation>
    </message>
    <message>
        <source>A program is running on the robot.</source>
        <translation>Un programme est en cours sur le robot.</translation>
    </message>
    <message>
        <source>The program “%1” is paused on the robot.</source>
        <translation>Le programme « %1 » est en pause sur le robot.</translation>
    </message>
    <message>
        <source>The program “%1” is running on the robot.</source>
        <translation>Le programme « %1 » est en cours sur le robot.</translation>
    </message>
    <message>
        <source>Taking control stops the program. The program cannot be resumed, only restarted.</source>
        <translation>Prendre le contrôle arrête le programme. Il ne peut pas être repris, seulement redémarré.</translation>
    </message>
    <message>
        <source>Stop program and take control</source>
        <translation>Arrêter le programme et prendre le contrôle</translation>
    </message>
    <message>
        <source>Keep program</source>
        <translation>Garder le programme</translation>
    </message>
    <message>
        <source>Waypoints, Program, Frames, Tools, I/O, Log</source>
        <translation>Points, Programme, Repères, Outils, E/S, Journal</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Powering off stops the program. The program cannot be resumed, only restarted.</source>
        <translation>La mise hors tension arrête le programme. Il ne peut pas être repris, seulement redémarré.</translation>
    </message>
    <message>
        <source>Stop program and power off</source>
        <translation>Arrêter le programme et mettre hors tension</translation>
    </message>
    <message>
        <source>A path is being recorded. Stop the path recording first.</source>
        <translation>Une trajectoire est en cours d’enregistrement. Arrêtez-la d’abord.</translation>
    </message>
    <message>
        <source>Close window</source>
        <translation>Fermer la fenêtre</translation>
    </message>
    <message>
        <source>A recording is running.</source>
        <translation>Un enregistrement est en cours.</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>Nouveau projet…</translation>
    </message>
    <message>
        <source>Starts an empty project in a new file.</source>
        <translation>Commence un projet vide dans un nouveau fichier.</translation>
    </message>
    <message>
        <source>The change takes effect immediately and may disturb the program.</source>
        <translation>Le changement prend effet immédiatement et peut perturber le programme.</translation>
    </message>
    <message>
        <source>Change anyway</source>
        <translation>Changer quand même</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Change while a program is active</source>
        <translation>Modification avec un programme actif</translation>
    </message>
    <message>
        <source>Change connection</source>
        <translation>Changer de connexion</translation>
    </message>
    <message>
        <source>Do not ask again during this program</source>
        <translation>Ne plus demander pendant ce programme</translation>
    </message>
    <message>
        <source>A program is loaded on the robot.</source>
        <translation>Un programme est chargé sur le robot.</translation>
    </message>
    <message>
        <source>The program “%1” is loaded on the robot.</source>
        <translation>Le programme « %1 » est chargé sur le robot.</translation>
    </message>
    <message>
        <source>Pausing stops the arm until the program is resumed.</source>
        <translation>Le bras s’arrête jusqu’à la reprise du programme.</translation>
    </message>
    <message>
        <source>The program cannot be resumed, only restarted.</source>
        <translation>Le programme ne peut pas être repris, seulement redémarré.</translation>
    </message>
    <message>
        <source>The arm may move immediately. Make sure that no one is within reach of the arm.</source>
        <translation>Le bras peut bouger immédiatement. Vérifiez que personne n’est à portée du bras.</translation>
    </message>
    <message>
        <source>Resume program</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Start program</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Arrêter et fermer</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>Laisser en marche</translation>
    </message>
    <message>
        <source>Stop and continue</source>
        <translation>Arrêter et continuer</translation>
    </message>
    <message>
        <source>A program is running. Stop the program first.</source>
        <translation>Un programme est en cours d’exécution. Arrêtez d’abord le programme.</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>Keyboard jogging was disarmed, because an input field has the focus: the keys now edit the field. Arm the keyboard again to jog.</source>
        <translation>Le clavier a été désarmé, car un champ de saisie a le focus : les touches modifient maintenant le champ. Réarmez le clavier pour déplacer le bras.</translation>
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
        <translation>Clavier armé : les flèches déplacent en X et Y, Pg préc et Pg suiv en Z ; avec Alt, elles tournent l’outil. Maintenez 1 à 6 et appuyez sur + ou − pour déplacer une articulation. Espace et Échap arrêtent le bras.</translation>
    </message>
    <message>
        <source>Changes the theme, sizes, units, speed cap, devices and keyboard shortcuts.</source>
        <translation>Thème, tailles, unités, plafond de vitesse, appareils et raccourcis clavier.</translation>
    </message>
    <message>
        <source>This activity stops when you close the window.</source>
        <translation>Cela s’arrête à la fermeture de la fenêtre.</translation>
    </message>
    <message>
        <source>This activity stops when you change the connection.</source>
        <translation>Cela s’arrête au changement de connexion.</translation>
    </message>
    <message>
        <source>Saves the project now. Tiller also saves all changes automatically. If another window or program has changed the file, Tiller asks whether to reload the file or keep both versions.</source>
        <translation>Enregistre le projet maintenant. Tiller enregistre aussi automatiquement toutes les modifications. Si une autre fenêtre ou un autre programme a modifié le fichier, demande s’il faut le recharger ou conserver les deux versions.</translation>
    </message>
    <message>
        <source>Converts a project for a different robot model, keeping either the poses or the joint positions.</source>
        <translation>Convertit un projet pour un autre modèle de robot en conservant les poses ou les positions articulaires.</translation>
    </message>
    <message>
        <source>A program is running. Stop the program before you open a different project.</source>
        <translation>Un programme est en cours d’exécution. Arrêtez-le avant d’ouvrir un autre projet.</translation>
    </message>
</context>
<context>
    <name>tiller::app::PanelDock</name>
    <message>
        <source>Dock</source>
        <translation>Ancrer</translation>
    </message>
    <message>
        <source>Moves this panel back to the main window.</source>
        <translation>Replace ce panneau dans la fenêtre principale.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Closes this panel. Use the View menu to show it again.</source>
        <translation>Ferme ce panneau. Utilisez le menu Vue pour l’afficher de nouveau.</translation>
    </message>
    <message>
        <source>Move, float or close %1</source>
        <translation>Déplacer, détacher ou fermer %1</translation>
    </message>
    <message>
        <source>Click to move, float or close this panel. Drag to move it.</source>
        <translation>Cliquez pour déplacer, détacher ou fermer ce panneau. Glissez pour le déplacer.</translation>
    </message>
</context>
<context>
    <name>tiller::app::PerspectiveActions</name>
    <message>
        <source>Save perspective</source>
        <translation>Enregistrer la perspective</translation>
    </message>
    <message>
        <source>Saves the current panel layout to the current perspective.</source>
        <translation>Enregistre la disposition actuelle des panneaux dans la perspective actuelle.</translation>
    </message>
    <message>
        <source>Save perspective as…</source>
        <translation>Enregistrer la perspective sous…</translation>
    </message>
    <message>
        <source>Saves the current panel layout under a new name.</source>
        <translation>Enregistre la disposition actuelle des panneaux sous un nouveau nom.</translation>
    </message>
    <message>
        <source>Save perspective as</source>
        <translation>Enregistrer la perspective sous</translation>
    </message>
    <message>
        <source>Rename perspective…</source>
        <translation>Renommer la perspective…</translation>
    </message>
    <message>
        <source>Renames the current perspective.</source>
        <translation>Renomme la perspective actuelle.</translation>
    </message>
    <message>
        <source>Rename perspective</source>
        <translation>Renommer la perspective</translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be renamed.</source>
        <translation>Cette perspective est prédéfinie et ne peut pas être renommée.</translation>
    </message>
    <message>
        <source>Delete perspective…</source>
        <translation>Supprimer la perspective…</translation>
    </message>
    <message>
        <source>Deletes the current perspective. The panel layout does not change.</source>
        <translation>Supprime la perspective actuelle. La disposition des panneaux ne change pas.</translation>
    </message>
    <message>
        <source>This perspective is built in and cannot be deleted.</source>
        <translation>Cette perspective est prédéfinie et ne peut pas être supprimée.</translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation>Perspective %1</translation>
    </message>
    <message>
        <source>Perspective %1. Select a panel layout, or save the current layout.</source>
        <translation>Perspective %1. Sélectionnez une disposition de panneaux ou enregistrez l’actuelle.</translation>
    </message>
    <message>
        <source>Perspective name</source>
        <translation>Nom de la perspective</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Delete perspective</source>
        <translation>Supprimer la perspective</translation>
    </message>
    <message>
        <source>Delete the perspective “%1”? This cannot be undone.</source>
        <translation>Supprimer la perspective « %1 » ? Cela ne peut être annulé.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>This perspective is built in. Save it under a different name.</source>
        <translation>Cette perspective est prédéfinie. Enregistrez-la sous un autre nom.</translation>
    </message>
</context>
<context>
    <name>tiller::app::Perspectives</name>
    <message>
        <source>Teach</source>
        <translation>Apprendre</translation>
    </message>
    <message>
        <source>Shows the view, the waypoints next to it and the plots below.</source>
        <translation>Montre la vue, les points de passage à côté et les tracés dessous.</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>Surveiller</translation>
    </message>
    <message>
        <source>Shows inputs and outputs, a smaller view next to them and taller plots below.</source>
        <translation>Montre entrées et sorties, une vue plus petite à côté et des tracés plus hauts dessous.</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Tracés</translation>
    </message>
    <message>
        <source>Shows only the plots, as large as possible.</source>
        <translation>Affiche seulement les tracés, aussi grands que possible.</translation>
    </message>
    <message>
        <source>Shows the panels as you saved them.</source>
        <translation>Montre les panneaux comme vous les avez enregistrés.</translation>
    </message>
    <message>
        <source>The perspective “%1” cannot be shown because the stored layout is damaged. Arrange the panels and save the perspective again.</source>
        <translation>La perspective « %1 » ne peut pas être affichée : sa disposition enregistrée est endommagée. Disposez les panneaux et enregistrez-la de nouveau.</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>Saisissez un nom.</translation>
    </message>
    <message>
        <source>The maximum number of perspectives has been reached. Delete a perspective first.</source>
        <translation>Le nombre maximal de perspectives est atteint. Supprimez-en d’abord une.</translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the layout of the earlier version is not compatible. Arrange the panels again. The new layout is saved automatically.</source>
        <translation>La disposition des panneaux a été réinitialisée à la perspective « %1 » : celle de la version antérieure n’est pas compatible. Disposez de nouveau les panneaux. La nouvelle disposition est enregistrée automatiquement.</translation>
    </message>
    <message>
        <source>The panel layout was reset to the perspective “%1”: the stored layout is damaged or from another version. Arrange the panels again. The new layout is saved automatically.</source>
        <translation>La disposition des panneaux a été réinitialisée à la perspective « %1 » : la disposition enregistrée est endommagée ou vient d’une autre version. Disposez de nouveau les panneaux. La nouvelle disposition est enregistrée automatiquement.</translation>
    </message>
    <message>
        <source>The name is too long. Enter a shorter name.</source>
        <translation>Le nom est trop long. Saisissez un nom plus court.</translation>
    </message>
    <message>
        <source>A perspective with this name already exists. Choose a different name.</source>
        <translation>Une perspective de ce nom existe déjà. Choisissez un autre nom.</translation>
    </message>
</context>
<context>
    <name>tiller::app::RecordingSettings</name>
    <message>
        <source>Folder for recordings</source>
        <translation>Dossier des enregistrements</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Choose the folder for recordings</source>
        <translation>Choisir le dossier des enregistrements</translation>
    </message>
    <message>
        <source>File name pattern</source>
        <translation>Modèle de nom de fichier</translation>
    </message>
    <message>
        <source>{date}, {time}, {robot} and {number} are replaced when a recording starts.</source>
        <translation>{date}, {time}, {robot} et {number} sont remplacés au début d’un enregistrement.</translation>
    </message>
    <message>
        <source>Packets/row</source>
        <translation>Paquets/ligne</translation>
    </message>
    <message>
        <source>Search signals</source>
        <translation>Chercher des signaux</translation>
    </message>
    <message>
        <source>Signals in a recording</source>
        <translation>Signaux d’un enregistrement</translation>
    </message>
    <message>
        <source>All signals</source>
        <translation>Tous les signaux</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>File name</source>
        <translation>Nom de fichier</translation>
    </message>
    <message>
        <source>Lab UR5e</source>
        <translation>UR5e du labo</translation>
    </message>
    <message>
        <source>Example: %1. {date}, {time}, {robot}, {number} are placeholders. Existing files are never overwritten.</source>
        <translation>Exemple : %1. {date}, {time}, {robot} et {number} sont des champs remplacés. Les fichiers existants ne sont jamais écrasés.</translation>
    </message>
    <message numerus="yes">
        <source>%n packet(s) per row: %1 rows per second from a robot that sends 500 packets per second.</source>
        <translation>
            <numerusform>%n paquet par ligne : %1 lignes par seconde d’un robot qui envoie 500 paquets par seconde.</numerusform>
            <numerusform>%n paquets par ligne : %1 lignes par seconde d’un robot qui envoie 500 paquets par seconde.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording format</source>
        <translation>Format d’enregistrement</translation>
    </message>
    <message>
        <source>Free disk space to keep, in megabytes</source>
        <translation>Espace disque libre à conserver, en mégaoctets</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> Mo</translation>
    </message>
    <message>
        <source>Recording stops, and the file is saved, before the free disk space falls below this value.</source>
        <translation>Un enregistrement s’arrête et se termine avant que l’espace libre passe sous cette valeur.</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Keep free</source>
        <translation>Garder libre</translation>
    </message>
    <message>
        <source>Maximum duration of a file, in minutes</source>
        <translation>Durée maximale d’un fichier, en minutes</translation>
    </message>
    <message>
        <source>Maximum size of a file, in megabytes</source>
        <translation>Taille maximale d’un fichier, en mégaoctets</translation>
    </message>
    <message>
        <source>Recorded time before the trigger, in seconds</source>
        <translation>Durée enregistrée avant le déclencheur, en secondes</translation>
    </message>
    <message>
        <source>Recorded time after the trigger, in seconds</source>
        <translation>Durée enregistrée après le déclencheur, en secondes</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Sans limite</translation>
    </message>
    <message>
        <source>A longer recording continues in a new file without losing packets.</source>
        <translation>Un enregistrement plus long continue dans un nouveau fichier sans perte de paquets.</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Metadata of recordings</source>
        <translation>Métadonnées des enregistrements</translation>
    </message>
    <message>
        <source>When to enter metadata</source>
        <translation>Quand saisir les métadonnées</translation>
    </message>
    <message>
        <source>Use for each recording</source>
        <translation>Utiliser pour chaque enregistrement</translation>
    </message>
    <message>
        <source>Ask before each recording</source>
        <translation>Demander avant chaque enregistrement</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Déclencheur</translation>
    </message>
    <message>
        <source>None: recording starts at once</source>
        <translation>Aucun : l’enregistrement commence aussitôt</translation>
    </message>
    <message>
        <source>Combine conditions with “and” and “or”, for example:
norm(actual_TCP_force_0, actual_TCP_force_1) &gt; 20 and robot_mode = 7
actual_digital_input_bits:3 = 1
runtime_state changes
program starts</source>
        <translation>Combinez les conditions avec « and » et « or », par exemple :
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
        <translation>Nouveau fichier après</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>Métadonnées</translation>
    </message>
    <message>
        <source>Before trigger</source>
        <translation>Avant le déclencheur</translation>
    </message>
    <message>
        <source>after</source>
        <translation>après</translation>
    </message>
    <message>
        <source>Metadata…</source>
        <translation>Métadonnées…</translation>
    </message>
    <message numerus="yes">
        <source>Metadata (%n field(s))…</source>
        <translation>
            <numerusform>Métadonnées (%n champ)…</numerusform>
            <numerusform>Métadonnées (%n champs)…</numerusform>
        </translation>
    </message>
    <message>
        <source>With a trigger, Tiller records only while the condition is true, in numbered files.</source>
        <translation>Avec un déclencheur, Tiller n’enregistre que tant que la condition est vraie, dans des fichiers numérotés.</translation>
    </message>
</context>
<context>
    <name>tiller::app::ReportDialog</name>
    <message>
        <source>Include names and addresses of robots, inputs, outputs and files</source>
        <translation>Avec les noms et adresses des robots, entrées, sorties et fichiers</translation>
    </message>
    <message>
        <source>Report a problem</source>
        <translation>Signaler un problème</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Ce qui s’est passé</translation>
    </message>
    <message>
        <source>What did you do? What did you expect? What happened?</source>
        <translation>Qu’avez-vous fait ? Qu’attendiez-vous ? Que s’est-il passé ?</translation>
    </message>
    <message>
        <source>Report files</source>
        <translation>Fichiers du rapport</translation>
    </message>
    <message>
        <source>File content</source>
        <translation>Contenu de ce fichier</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>Enregistrer le rapport…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>The report is one file with the information that support needs. The complete content is listed below. You choose where to save the file. Tiller does not send it.</source>
        <translation>Un fichier avec les informations utiles à l’assistance. Son contenu complet figure ci-dessous. Le fichier est enregistré où vous voulez ; Tiller ne l’envoie pas.</translation>
    </message>
    <message>
        <source>Tiller report %1.zip</source>
        <translation>Rapport Tiller %1.zip</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Zip archives (*.zip)</source>
        <translation>Archives zip (*.zip)</translation>
    </message>
</context>
<context>
    <name>tiller::app::SampleDialog</name>
    <message>
        <source>Open sample project</source>
        <translation>Ouvrir un projet d’exemple</translation>
    </message>
    <message>
        <source>Each project was taught with a UR5e and runs on the simulated robot. You work on a copy. To keep your changes, save the project to a new file.</source>
        <translation>Chaque projet a été appris avec un UR5e et fonctionne sur le robot simulé. Vous travaillez sur une copie : choisissez un nouveau fichier pour l’enregistrer.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open “%1”</source>
        <translation>Ouvrir « %1 »</translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Appearance and motion</source>
        <translation>Aspect et mouvement</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Périphériques</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Export settings…</source>
        <translation>Exporter les réglages…</translation>
    </message>
    <message>
        <source>Save all settings to one file, for another computer or as a backup</source>
        <translation>Enregistrer tous les réglages dans un fichier, pour un autre ordinateur ou comme sauvegarde</translation>
    </message>
    <message>
        <source>Import settings…</source>
        <translation>Importer des réglages…</translation>
    </message>
    <message>
        <source>Show which settings a file will replace, then import them</source>
        <translation>Afficher les réglages qu’un fichier remplacera, puis les importer</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Control size</source>
        <translation>Taille des commandes</translation>
    </message>
    <message>
        <source>Compact</source>
        <translation>Compact</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Souris</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Tactile</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Interface size</source>
        <translation>Taille de l’interface</translation>
    </message>
    <message>
        <source>Length unit</source>
        <translation>Unité de longueur</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimètres</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pouces</translation>
    </message>
    <message>
        <source>Orientation format</source>
        <translation>Format d’orientation</translation>
    </message>
    <message>
        <source>Roll, pitch, yaw in degrees</source>
        <translation>Roulis, tangage, lacet en degrés</translation>
    </message>
    <message>
        <source>Rotation vector in radians, as in scripts</source>
        <translation>Vecteur de rotation en radians, comme dans les scripts</translation>
    </message>
    <message>
        <source>Tiller speed cap</source>
        <translation>Plafond de vitesse de Tiller</translation>
    </message>
    <message>
        <source>Maximum hold time</source>
        <translation>Durée maximale de maintien</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>After this time, a jog stops and its button must be pressed again. Freedrive has a limit of five minutes. A move to a position has a limit of its duration plus 5 s.</source>
        <translation>Après cette durée, un déplacement s’arrête et son bouton doit être pressé de nouveau. Freedrive : cinq minutes. Aller à une position : sa durée plus 5 s.</translation>
    </message>
    <message>
        <source>Touch: large enough for fingers. In windows less than %1 px high, joint buttons, tabs and title bars remain smaller.</source>
        <translation>Tactile : assez grand pour les doigts. Dans les fenêtres de moins de %1 px de haut, les boutons d’articulation, onglets et barres de titre restent plus petits.</translation>
    </message>
    <message>
        <source>Units for displaying and entering lengths, TCP speeds and orientations. The units in plots and files do not change.</source>
        <translation>Unités d’affichage et de saisie des longueurs, vitesses TCP et orientations. Les unités des tracés et des fichiers ne changent pas.</translation>
    </message>
    <message>
        <source>Speed cap</source>
        <translation>Plafond de vitesse</translation>
    </message>
    <message>
        <source>Scales text, controls, plots and the view.</source>
        <translation>Met à l’échelle textes, commandes, tracés et vue.</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted, limited to %1 % on this screen.</source>
        <translation>Prend effet au prochain démarrage de Tiller, limité à %1 % sur cet écran.</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted.</source>
        <translation>Prend effet au prochain démarrage de Tiller.</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>Restore default shortcuts</source>
        <translation>Rétablir les raccourcis</translation>
    </message>
    <message>
        <source>Shortcut for %1</source>
        <translation>Raccourci de %1</translation>
    </message>
    <message>
        <source>%1 is reserved for stopping the arm.</source>
        <translation>%1 est réservée à l’arrêt du bras.</translation>
    </message>
    <message>
        <source>%1 is assigned to “%2”. Remove that shortcut first.</source>
        <translation>%1 est attribuée à « %2 ». Retirez d’abord ce raccourci.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>System language: %1</source>
        <translation>Langue du système : %1</translation>
    </message>
    <message>
        <source>Reopen window</source>
        <translation>Rouvrir la fenêtre</translation>
    </message>
    <message>
        <source>Stops the arm, gives control back and reconnects. The plots restart. The project is saved.</source>
        <translation>Arrête le bras, rend le contrôle et se reconnecte. Les tracés recommencent. Le projet est enregistré.</translation>
    </message>
    <message>
        <source>Language of the window and of the connection check. Files and scripts are not affected.</source>
        <translation>Langue de la fenêtre et de la vérification de connexion. Les fichiers et scripts ne sont pas concernés.</translation>
    </message>
    <message>
        <source>Monitor only</source>
        <translation>Surveillance seule</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>For PCs that only monitor: this window does not take control, set outputs or start programs. STOP still works.</source>
        <translation>Pour les PC qui ne font que surveiller : cette fenêtre ne prend pas le contrôle, ne change pas de sortie et ne démarre aucun programme. STOP reste actif.</translation>
    </message>
    <message>
        <source>Monitor only (set on the command line)</source>
        <translation>Surveillance seule (définie sur la ligne de commande)</translation>
    </message>
    <message>
        <source>Press the new shortcut in the field, or Backspace to remove the shortcut. While Tiller is in control, Space and Esc always stop the arm.</source>
        <translation>Tapez le nouveau raccourci dans le champ ; Retour arrière le supprime. Tant que Tiller a le contrôle, Espace et Échap arrêtent toujours le bras.</translation>
    </message>
    <message>
        <source>Takes effect when Tiller is restarted or the window is reopened. The plots then restart.</source>
        <translation>Prend effet au redémarrage de Tiller ou à la réouverture de la fenêtre. Les tracés recommencent alors.</translation>
    </message>
    <message>
        <source>Maximum speed of the TCP and elbow for all motion commanded by Tiller. A change takes effect immediately and stops any motion.</source>
        <translation>Vitesse maximale du TCP et du coude pour tout mouvement commandé par Tiller. Prend effet aussitôt et arrête le mouvement en cours.</translation>
    </message>
    <message>
        <source>▲ Above %1. Manual mode and the enabling device of the teach pendant do not limit jogging from a PC. The header shows a warning. The cap is reset when Tiller is closed.</source>
        <translation>▲ Au-dessus de %1. Le mode manuel et le dispositif de validation du pupitre ne limitent pas le déplacement depuis un PC. L’en-tête affiche un avertissement. Le plafond est réinitialisé à la fermeture de Tiller.</translation>
    </message>
</context>
<context>
    <name>tiller::app::SettingsTransfer</name>
    <message>
        <source>Tiller settings (*.json)</source>
        <translation>Réglages de Tiller (*.json)</translation>
    </message>
    <message>
        <source>Export settings</source>
        <translation>Exporter les réglages</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Importer des réglages</translation>
    </message>
    <message>
        <source>Settings exported to %1</source>
        <translation>Réglages exportés dans %1</translation>
    </message>
    <message>
        <source>%1 was not imported. Nothing was changed. %2</source>
        <translation>%1 n’a pas été importé. Rien n’a été changé. %2</translation>
    </message>
    <message>
        <source>Settings imported from %1. The previous settings were saved to %2.</source>
        <translation>Réglages importés de %1. Les réglages précédents ont été enregistrés dans %2.</translation>
    </message>
</context>
<context>
    <name>tiller::app::Tutorial</name>
    <message>
        <source>First steps</source>
        <translation>Premiers pas</translation>
    </message>
    <message>
        <source>Shows a checklist in the view, from powering on to recording.</source>
        <translation>Affiche dans la vue une liste de contrôle, de la mise sous tension à l’enregistrement.</translation>
    </message>
    <message>
        <source>Practice tasks</source>
        <translation>Exercices</translation>
    </message>
    <message>
        <source>Five tasks on the simulated robot. Each task checks the result.</source>
        <translation>Cinq exercices sur le robot simulé. Chacun vérifie le résultat.</translation>
    </message>
    <message>
        <source>Practice works only with the built-in simulated robot. The current robot is “%1”. Connect to the simulated robot first.</source>
        <translation>Les exercices ne fonctionnent qu’avec le robot simulé intégré. Le robot actuel est « %1 ». Connectez-vous d’abord au robot simulé.</translation>
    </message>
    <message>
        <source>Practice: add “%1”</source>
        <translation>Exercice : ajouter « %1 »</translation>
    </message>
</context>
</TS>
