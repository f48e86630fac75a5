// SPDX-License-Identifier: MIT
#pragma once

// Sends URScript: a file, a text, or the built-in control program, prepared for the controller's software.

#include <ur_rtde/rtde.h>

#include <cstdint>
#include <memory>
#include <string>

namespace ur_rtde {

class ScriptClient {
public:
    /// major_control_version, minor_control_version  of the controller; decide about lines marked with a
    /// version
    explicit ScriptClient(std::string hostname, uint32_t major_control_version,
                          uint32_t minor_control_version, int port = 30003, bool verbose = false);
    virtual ~ScriptClient();
    ScriptClient(const ScriptClient&) = delete;
    ScriptClient& operator=(const ScriptClient&) = delete;

    /// Throws std::runtime_error when the controller cannot be reached within 2 s.
    void connect();
    void disconnect();
    bool isConnected();

    /// The file sendScript() sends instead of the built-in program; empty: the built-in one again.
    void setScriptFile(const std::string& file_name);
    /// Sends the file of setScriptFile(), or the built-in program.
    /// Returns  false when there is no connection or the file cannot be read
    bool sendScript();
    /// Sends a file, as it is.
    bool sendScript(const std::string& file_name);
    /// Sends a text; a missing line end is added.
    bool sendScriptCommand(const std::string& cmd_str);
    /// From now on `inject_string` is put behind the first `search_string` of every program sent, in place of
    /// what was registered for it before.
    void setScriptInjection(const std::string& search_string, const std::string& inject_string);
    /// What sendScript() would send now. Throws std::runtime_error when the file cannot be read.
    std::string getScript();

    /// Drops the lines this software does not understand: those marked "$5.4" or "$5.10|3.15" at their
    /// beginning for newer software. Marks of lines that stay become blanks.
    /// Returns  false when a mark cannot be understood
    bool removeUnsupportedFunctions(std::string& ur_script);
    /// Puts in what setScriptInjection() registered.
    /// Returns  false when one of the places is missing
    bool scanAndInjectAdditionalScriptCode(std::string& ur_script);

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ur_rtde
