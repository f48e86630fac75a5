% SPDX-License-Identifier: MIT
% Reads the robot from MATLAB through the Python module (listing 3 of the ur_rtde paper). Not tested, because the
% project's CI has no MATLAB. Set once which Python the modules were built for, and where they are:
%   pyenv(Version="/usr/bin/python3")
%   insert(py.sys.path, int32(0), "/path/to/build/python")
import py.rtde_receive.RTDEReceiveInterface
rtde_r = RTDEReceiveInterface(pyargs("ip", "localhost"));
actual_q = rtde_r.getActualQ();
% Convert to MATLAB array of double
actual_q_array = cellfun(@double, cell(actual_q));
disp(actual_q_array)
