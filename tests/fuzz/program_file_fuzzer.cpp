// SPDX-License-Identifier: MIT
// Arbitrary program files of the pendant in the programs folder: the result is URScript or an error, and this
// URScript compiles or causes an error with its position.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "robot/simulator/programs/urp_file.h"
#include "robot/simulator/urscript/program.h"

using namespace tiller::simulator;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const QByteArray content(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size));
    // All referenced files contain this program, or half of it as a script.
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
