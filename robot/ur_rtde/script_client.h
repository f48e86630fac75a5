// SPDX-License-Identifier: MIT
#pragma once

// Sends URScript to the controller: a file, text, or the built-in control program for the controller's
// software version.

#include <ur_rtde/rtde.h>

#include <cstdint>
#include <memory>
#include <string>

namespace ur_rtde {

class ScriptClient {
public:
    /// major_control_version,
    /// minor_control_version  of the controller; they select lines with a version mark
    explicit ScriptClient(std::string hostname, uint32_t major_control_version,
                          uint32_t minor_control_version, int port = 30003, bool verbose = false);
    virtual ~ScriptClient();
    ScriptClient(const ScriptClient&) = delete;
    ScriptClient& operator=(const ScriptClient&) = delete;

    /// Throws std::runtime_error if the controller cannot be reached within 2 s.
    void connect();
    void disconnect();
    bool isConnected();

    /// File used by sendScript(). Empty: the built-in program.
    void setScriptFile(const std::string& file_name);
    /// Sends the file of setScriptFile(), or the built-in program.
    /// Returns  false if there is no connection or the file cannot be read
    bool sendScript();
    /// Sends a file unchanged.
    bool sendScript(const std::string& file_name);
    /// Sends text. Adds a missing line end.
    bool sendScriptCommand(const std::string& cmd_str);
    /// Inserts `inject_string` after the first `search_string` of every program sent from now on. Replaces an
    /// earlier injection for this search string.
    void setScriptInjection(const std::string& search_string, const std::string& inject_string);
    /// Returns the text that sendScript() would send. Throws std::runtime_error if the file cannot be read.
    std::string getScript();

    /// Removes lines that need a newer software version: lines that start with a version mark, e.g. "$5.4" or
    /// "$5.10|3.15". In the remaining lines, blanks replace the marks.
    /// Returns  false for an invalid mark
    bool removeUnsupportedFunctions(std::string& ur_script);
    /// Inserts the strings of setScriptInjection().
    /// Returns  false if a search string is missing
    bool scanAndInjectAdditionalScriptCode(std::string& ur_script);

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ur_rtde
