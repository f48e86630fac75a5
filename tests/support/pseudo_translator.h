// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A pseudo language. All texts remain legible, contain accented letters, and are about 40 % longer. Unchanged
// texts show that tr() was not called. A text that does not fit would also not fit in some real language.

#include <QHash>
#include <QTranslator>

namespace tiller::test {

inline QString pseudoText(const QString& source) {
    static const QHash<QChar, QChar> accents{
        {'a', u'á'}, {'e', u'ê'}, {'i', u'ï'}, {'o', u'ö'}, {'u', u'ü'}, {'A', u'Å'}, {'E', u'É'},
        {'I', u'Î'}, {'O', u'Ö'}, {'U', u'Ü'}, {'c', u'ç'}, {'n', u'ñ'}, {'s', u'š'}, {'S', u'Š'},
        {'y', u'ý'}, {'z', u'ž'}, {'Z', u'Ž'}, {'C', u'Ç'}, {'N', u'Ñ'}, {'g', u'ğ'}, {'r', u'ř'}};
    QString text;
    double owed = 0;  // number of letters still to be added
    bool inTag = false;
    for (qsizetype i = 0; i < source.size(); ++i) {
        const QChar c = source[i];
        inTag = c == u'<' ? true : inTag;
        if (inTag || (c == u'%' && i + 1 < source.size())) {
            const bool placeholder = !inTag;
            text += c;
            if (placeholder) {
                text += source[++i];
            }
            inTag = c == u'>' ? false : inTag;
            continue;
        }
        text += accents.value(c, c);
        owed += c.isLetter() ? 0.4 : 0;
        if (c.isLetter() && owed >= 1) {
            text += accents.value(c, c).toLower();
            owed -= 1;
        }
    }
    return text;
}

class PseudoTranslator : public QTranslator {
public:
    using QTranslator::QTranslator;

    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* source, const char* /*comment*/,
                      int /*n*/) const override {
        // Qt's own texts are not changed.
        return context == nullptr || context[0] == 'Q' ? QString() : pseudoText(QString::fromUtf8(source));
    }
};

}  // namespace tiller::test
