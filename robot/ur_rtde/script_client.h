// SPDX-License-Identifier: MIT
#pragma once

// Sends URScript: a file, a text, or the built-in control program, adapted to the controller's software version.

#include <ur_rtde/rtde.h>

#include <cstdint>
#include <memory>
#include <string>

namespace ur_rtde {

class ScriptClient {
public:
    /// major_control_version, minor_control_version  of the controller; used for lines marked with a version
    explicit ScriptClient(std::string hostname, uint32_t major_control_version,
                          uint32_t minor_control_version, int port = 30003, bool verbose = false);
    virtual ~ScriptClient();
    ScriptClient(const ScriptClient&) = delete;
    ScriptClient& operator=(const ScriptClient&) = delete;

    /// Throws std::runtime_error if the controller cannot be reached within 2 s.
    void connect();
    void disconnect();
    bool isConnected();

    /// The file used by sendScript() instead of the built-in program; empty: the built-in program.
    void setScriptFile(const std::string& file_name);
    /// Sends the file of setScriptFile(), or the built-in program.
    /// Returns  false without a connection or if the file cannot be read
    bool sendScript();
    /// Sends a file unchanged.
    bool sendScript(const std::string& file_name);
    /// Sends a text; a missing line end is added.
    bool sendScriptCommand(const std::string& cmd_str);
    /// Inserts `inject_string` after the first `search_string` of every program sent from now on, replacing an
    /// earlier injection for it.
    void setScriptInjection(const std::string& search_string, const std::string& inject_string);
    /// The text that sendScript() would send. Throws std::runtime_error if the file cannot be read.
    std::string getScript();

    /// Removes lines that this software version does not support: lines starting with "$5.4" or "$5.10|3.15" for
    /// newer software. Marks of remaining lines are replaced by blanks.
    /// Returns  false for an invalid mark
    bool removeUnsupportedFunctions(std::string& ur_script);
    /// Inserts the texts of setScriptInjection().
    /// Returns  false if a search string is missing
    bool scanAndInjectAdditionalScriptCode(std::string& ur_script);

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ur_rtde
