// SPDX-License-Identifier: MIT
// Program files of the pendant, as anybody may put them into the programs folder: whatever they are, they
// become URScript or a reason, and what becomes URScript compiles or is an error with its place.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "robot/simulator/programs/urp_file.h"
#include "robot/simulator/urscript/program.h"

using namespace tiller::simulator;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const QByteArray content(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size));
    // Whatever a program refers to is this program again, or half of it as a script.
    const FileReader files = [&content](const QString& name) {
        return name.endsWith(QLatin1String(".urp")) ? std::optional(content)
                                                    : std::optional(content.left(content.size() / 2));
    };
    if (const auto script = scriptOfUrp(content, QStringLiteral("p"), files)) {
        const urscript::CompileOutcome outcome = urscript::compile(*script);
        if (!outcome && outcome.error.text.empty()) {
            std::abort();
        }
    }
    return 0;
}
