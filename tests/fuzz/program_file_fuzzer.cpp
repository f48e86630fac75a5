// SPDX-License-Identifier: MIT
// Translates arbitrary program files of the teach pendant. The result must be URScript or an error, and this
// URScript must compile or cause an error with its position.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "robot/simulator/pendant/pendant_program.h"
#include "robot/simulator/urscript/program.h"

using namespace tiller::simulator;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const QByteArray content(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size));
    // Every referenced program is the input itself. Every referenced script or installation is one half of
    // the input.
    pendant::PendantSource source;
    source.files = [&content](const QString& name) -> std::optional<QByteArray> {
        return name.endsWith(QLatin1String(".urp"))            ? content
               : name.endsWith(QLatin1String(".installation")) ? content.right(content.size() / 2)
                                                               : content.left(content.size() / 2);
    };
    source.unknownUrcap = pendant::UnknownUrcap::Skip;
    for (const auto& program :
         {pendant::readUrp(content, QStringLiteral("p"), source), pendant::readUrpx(content)}) {
        if (!program) {
            if (program.error().context.isEmpty()) {
                std::abort();
            }
        } else if (const auto outcome = urscript::compile(program->script);
                   !outcome && outcome.error.text.empty()) {
            std::abort();
        }
    }
    return 0;
}
