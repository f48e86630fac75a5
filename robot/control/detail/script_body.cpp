// SPDX-License-Identifier: MIT
#include "robot/control/detail/script_body.h"

#include <QRegularExpression>
#include <QStringList>
#include <vector>

namespace tiller::control {

Result<void> checkBlocks(const QString& body, const QString& context) {
    // Also matches strings and comments, so that keywords inside them are skipped.
    static const QRegularExpression kTokens(QStringLiteral("\"[^\"\\n]*\"?|#[^\\n]*|[A-Za-z_][A-Za-z0-9_]*"));
    static const QStringList kOpening{QStringLiteral("def"), QStringLiteral("thread"), QStringLiteral("sec"),
                                      QStringLiteral("if"), QStringLiteral("while")};
    struct Block {
        QString word;
        int line;
    };
    std::vector<Block> open;
    const QStringList lines = body.split(QLatin1Char('\n'));
    for (int i = 0; i < lines.size(); ++i) {
        for (auto tokens = kTokens.globalMatch(lines[i]); tokens.hasNext();) {
            const QString word = tokens.next().captured();
            if (kOpening.contains(word)) {
                open.push_back({word, i + 1});
            } else if (word == QLatin1String("end")) {
                if (open.empty()) {
                    return Error{
                        ErrorCode::InvalidArgument, context,
                        QStringLiteral("body: the \"end\" on line %1 does not close a block in the body")
                            .arg(i + 1)};
                }
                open.pop_back();
            }
        }
    }
    if (!open.empty()) {
        return Error{ErrorCode::InvalidArgument, context,
                     QStringLiteral("body: the \"%1\" on line %2 has no \"end\"")
                         .arg(open.back().word)
                         .arg(open.back().line)};
    }
    return {};
}

}  // namespace tiller::control
