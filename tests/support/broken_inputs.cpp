// SPDX-License-Identifier: MIT
#include "tests/support/broken_inputs.h"

#include "tests/support/raw_client.h"

namespace tiller::test {

namespace {

QByteArray dashboardInput(Chances& in) {
    // Without `shutdown`, which would end the server.
    static const QList<QByteArray> words{"load ",
                                         "play",
                                         "stop",
                                         "pause",
                                         "running",
                                         "programState",
                                         "get ",
                                         "loaded program",
                                         "isProgramSaved",
                                         "installation ",
                                         "robotmode",
                                         "power on",
                                         "power off",
                                         "brake release",
                                         "unlock protective stop",
                                         "close ",
                                         "safety popup",
                                         "popup",
                                         "restart safety",
                                         "safetymode",
                                         "safetystatus",
                                         "quit",
                                         "addToLog ",
                                         "saveLog",
                                         "setUserRole ",
                                         "getUserRole",
                                         "PolyscopeVersion",
                                         "version",
                                         "serial number",
                                         "robot model",
                                         "is in remote control",
                                         "set operational mode ",
                                         "manual",
                                         "generate flight report ",
                                         "generate support file ",
                                         "../",
                                         "\"",
                                         " ",
                                         "\r",
                                         "\0",
                                         "x.urp",
                                         "%n%s",
                                         "\xff\xfe"};
    return in.soup(words, 4) + '\n';
}

QByteArray rtdeInput(Chances& in) {
    static const QList<QByteArray> names{"timestamp",
                                         "actual_q",
                                         "input_int_register_0",
                                         "speed_slider_mask",
                                         "payload",
                                         ",",
                                         ",,",
                                         "input_double_register_47",
                                         "output_bit_register_64",
                                         "no_such_field",
                                         "",
                                         "standard_digital_output_mask",
                                         "standard_digital_output"};
    QByteArray payload;
    const char type = "VvMUOISPx\0\xff"[in.upTo(10)];
    switch (type) {
        case 'V':
            payload = bigEndian(quint16(in.upTo(3)));
            break;
        case 'O':
            payload = bigEndian(double(in.upTo(2000)) - 500) + in.any(names) + ',' + in.any(names);
            break;
        case 'I':
            payload = in.any(names) + ',' + in.any(names);
            break;
        case 'U':
            payload = char(in.upTo(6)) + in.bytes(40);
            break;
        default:
            payload = in.bytes(12);
    }
    QByteArray package = RawRtde::package(type, in.damaged(payload));
    return in.upTo(50) == 0 ? in.damaged(package) : package;
}

QByteArray scriptInput(Chances& in) {
    static const QList<QByteArray> words{"def p():\n",
                                         "end\n",
                                         "sec s():\n",
                                         "movej(",
                                         "[0,-1.5,-2,0,0,0]",
                                         "p[0.1,0.2,0.3,0,0,0]",
                                         ")",
                                         "(",
                                         ",",
                                         "a=1",
                                         "1e308",
                                         "-",
                                         "+",
                                         "*",
                                         "/",
                                         "%",
                                         "\"text\"",
                                         "'",
                                         "[",
                                         "]",
                                         "{",
                                         "}",
                                         "if ",
                                         "True",
                                         ":\n",
                                         "else:\n",
                                         "elif ",
                                         "return ",
                                         "global x=",
                                         "x",
                                         "textmsg(",
                                         "popup(",
                                         "set_digital_out(",
                                         "0",
                                         "9999999999999",
                                         "sleep(",
                                         "sync()",
                                         "\n",
                                         "#",
                                         "\\",
                                         "$ 1 2\n",
                                         "power on\n",
                                         "power off\n",
                                         "stop program\n",
                                         "set robotmode run\n",
                                         "struct(",
                                         ".",
                                         "!",
                                         "thread t():\n",
                                         "run t()",
                                         "kill ",
                                         "break\n",
                                         "and ",
                                         "not ",
                                         "==",
                                         "socket_close(",
                                         "\xc3\x28"};
    return in.soup(words, 12) + '\n';
}

QByteArray interpreterInput(Chances& in) {
    static const QList<QByteArray> lines{"statelastexecuted",
                                         "stateunexecuted",
                                         "statelastcleared",
                                         "skipbuffer",
                                         "abort",
                                         "clear_interpreter()",
                                         "x = 1",
                                         "x = x + 1",
                                         "textmsg(x)",
                                         "sleep(0.01)",
                                         "def f(a): return a end",
                                         "f(2)",
                                         "movej([0,-1.5,-2,0,0,0])",
                                         "x = [1,2",
                                         "y",
                                         "set_digital_out(0, True)"};
    return in.upTo(3) == 0 ? scriptInput(in) : in.damaged(in.any(lines)) + '\n';
}

QByteArray httpInput(Chances& in) {
    static const QList<QByteArray> words{
        "GET ",
        "PUT ",
        "POST ",
        "HEAD ",
        "DELETE ",
        "/universal-robots/robot-api",
        "/programs/v1/",
        "/program/v1/state",
        "/robotstate/v1/state",
        "/openapi.json",
        "..%2f..",
        "%zz",
        "%00",
        " HTTP/1.1\r\n",
        " HTTP/1.0\r\n",
        " HTTP/9.9\r\n",
        "Content-Length: 5\r\n",
        "Content-Length: -1\r\n",
        "Content-Length: 999999999999999999999\r\n",
        "Transfer-Encoding: chunked\r\n",
        "5\r\nhello\r\n",
        "0\r\n\r\n",
        "ffffffffffffffff\r\n",
        "Expect: 100-continue\r\n",
        "Connection: close\r\n",
        "Content-Type: multipart/form-data; boundary=x\r\n",
        "--x\r\nContent-Disposition: form-data; name=\"file\"; filename=\"a\"\r\n\r\n{}\r\n--x--\r\n",
        "{\"action\":\"POWER_ON\"}",
        "{\"name\":",
        "\r\n",
        "\r\n\r\n",
        ":",
        "\0",
        "\xff"};
    static const QList<QByteArray> proper{
        "GET /universal-robots/robot-api/robotstate/v1/robotmode HTTP/1.1\r\n\r\n",
        "PUT /universal-robots/robot-api/program/v1/state HTTP/1.1\r\nContent-Length: "
        "17\r\n\r\n{\"action\":\"play\"}",
        "POST /universal-robots/robot-api/programs/v1/ HTTP/1.1\r\nTransfer-Encoding: "
        "chunked\r\n\r\n3\r\nabc\r\n0\r\n\r\n"};
    return in.upTo(1) == 0 ? in.damaged(in.any(proper)) : in.soup(words, 8);
}

QByteArray gripperInput(Chances& in) {
    static const QList<QByteArray> words{"SET ", "GET ", "ACT ", "GTO ", "POS ", "SPE ", "FOR ",
                                         "ATR ", "ARD ", "1 ",   "0 ",   "255 ", "-1 ",  "99999999999 ",
                                         "x",    "STA",  "OBJ",  "?",    "\r",   "\t",   "\xff"};
    return in.soup(words, 6) + '\n';
}

QByteArray faultInput(Chances& in) {
    static const QList<QByteArray> words{"safeguard ",
                                         "on",
                                         "off",
                                         "delay ",
                                         "0 ",
                                         "1e9 ",
                                         "nan",
                                         "reduced ",
                                         "status",
                                         "help",
                                         "hold-registers ",
                                         "lower",
                                         "release-registers",
                                         "popup ",
                                         "speed ",
                                         "0.5",
                                         "hand ",
                                         "clear",
                                         "calibration ",
                                         "gripper-object ",
                                         "none",
                                         "digital-input ",
                                         "7 ",
                                         "\xff",
                                         "\0"};
    return in.soup(words, 4) + '\n';
}

const AttackedService kServices[] = {
    {"dashboard", &simulator::Ports::dashboard, dashboardInput},
    {"RTDE", &simulator::Ports::rtde, rtdeInput},
    {"primary", &simulator::Ports::primary, scriptInput},
    {"realtime", &simulator::Ports::realtime, scriptInput},
    {"interpreter", &simulator::Ports::interpreter, interpreterInput},
    {"Robot API", &simulator::Ports::robotApi, httpInput},
    {"gripper", &simulator::Ports::gripper, gripperInput},
    {"faults", &simulator::Ports::faults, faultInput},
};

}  // namespace

std::span<const AttackedService> attackedServices() {
    return kServices;
}

}  // namespace tiller::test
