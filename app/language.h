// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The language of the user interface: translations, including Qt's dialogs, and the decimal separator.

#include <QString>
#include <QTranslator>
#include <QVector>

namespace tiller::app {

struct Language {
    QString code;  ///< code as in the file name: "de", "zh_CN"
    QString name;  ///< native name
};

/// Available languages, English first.
const QVector<Language>& languages();
/// The language to use; English as fallback.
/// chosen  language code; empty or unknown: system language
QString languageFor(const QString& chosen);
/// Code of the language used for new windows.
QString shownLanguage();

/// Loads the texts of one language for the lifetime of the object or until another one is loaded. Displayed and
/// entered numbers use the decimal separator of this language; files do not.
/// Threads  GUI. Existing windows keep their texts
class LanguageTexts {
public:
    explicit LanguageTexts(const QString& chosen = {}) { take(chosen); }
    ~LanguageTexts();
    LanguageTexts(const LanguageTexts&) = delete;
    LanguageTexts& operator=(const LanguageTexts&) = delete;

    void take(const QString& chosen);
    const QString& code() const { return code_; }

private:
    void leave();

    QString code_;
    QTranslator texts_;
    QTranslator qtTexts_;
};

}  // namespace tiller::app
