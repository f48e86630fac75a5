// SPDX-License-Identifier: MIT
#pragma once

// Text across the border of this library: taken from whatever string a program has, given as whatever it
// wants; and how values of this library are written to a std::ostream.

#include <QString>
#include <array>
#include <concepts>
#include <cstdint>
#include <ostream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace tiller {

/// A QString that is made from std::string (UTF-8) too, and becomes one.
class Text : public QString {
public:
    Text() = default;
    Text(const QString& text) : QString(text) {}                              // NOLINT: implicit by intent
    Text(QString&& text) noexcept : QString(std::move(text)) {}               // NOLINT: implicit by intent
    Text(QLatin1String text) : QString(text) {}                               // NOLINT: implicit by intent
    Text(const char* utf8) : QString(QString::fromUtf8(utf8)) {}              // NOLINT: implicit by intent
    Text(const std::string& utf8) : QString(QString::fromStdString(utf8)) {}  // NOLINT: implicit by intent
    Text(std::string_view utf8)                                               // NOLINT: implicit by intent
        : QString(QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()))) {}
    operator std::string() const { return toStdString(); }  // NOLINT: implicit by intent
    friend std::ostream& operator<<(std::ostream& out, const Text& text) { return out << text.toStdString(); }
};

/// Numbers between brackets, with the stream's own precision: "[0, -1.5708, 0]".
std::ostream& writeNumbers(std::ostream& out, std::span<const double> numbers);

namespace detail {

/// What the compiler calls this value: "Active" for MotionPhase::Active; empty for a number without a name.
template <auto value>
constexpr std::string_view enumeratorName() {
#ifdef _MSC_VER
    constexpr std::string_view kAll = __FUNCSIG__;
    constexpr std::size_t kBegin = kAll.find("enumeratorName<") + std::string_view("enumeratorName<").size();
    constexpr std::size_t kEnd = kAll.rfind(">(void)");
#else
    constexpr std::string_view kAll = __PRETTY_FUNCTION__;
    constexpr std::size_t kBegin = kAll.find("value = ") + std::string_view("value = ").size();
    constexpr std::size_t kEnd = kAll.find_first_of(";]", kBegin);
#endif
    constexpr std::string_view kName = kAll.substr(kBegin, kEnd - kBegin);
    if (kName.find('(') != std::string_view::npos) {
        return {};
    }
    const std::size_t colon = kName.rfind(':');
    return colon == std::string_view::npos ? kName : kName.substr(colon + 1);
}

// Enumerators are looked for among these: -1 ... 255 and the powers of two above.
inline constexpr std::size_t kPlainCandidates = 257;
inline constexpr std::size_t kCandidates = kPlainCandidates + 23;
constexpr std::int64_t candidate(std::size_t i) {  ///< The i-th of them.
    return i < kPlainCandidates ? static_cast<std::int64_t>(i) - 1
                                : std::int64_t(1) << (i - kPlainCandidates + 8);
}

template <class E>
constexpr bool holds(std::int64_t number) {  ///< E can hold it.
    return std::in_range<std::underlying_type_t<E>>(number);
}
template <class E, std::size_t i>
constexpr std::string_view candidateName() {  ///< Empty: none of E.
    if constexpr (holds<E>(candidate(i))) {
        return enumeratorName<static_cast<E>(candidate(i))>();
    } else {
        return {};
    }
}
template <class E>
inline constexpr auto kNames = []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array<std::string_view, sizeof...(i)>{candidateName<E, i>()...};
}
(std::make_index_sequence<kCandidates>());

template <class E>
constexpr std::string_view nameOf(E value) {  ///< Empty: not found.
    for (std::size_t i = 0; i < kCandidates; ++i) {
        if (holds<E>(candidate(i)) && static_cast<E>(candidate(i)) == value) {
            return kNames<E>[i];
        }
    }
    return {};
}

template <class E>
concept ScopedEnum = std::is_enum_v<E> && !std::is_convertible_v<E, int>;

}  // namespace detail

/// Writes an enumerator's name as the header spells it ("LinkLost"), a number without a name as a number.
/// The robot's own modes are written in the controller's spelling instead: see modes.h.
template <detail::ScopedEnum E>
std::ostream& operator<<(std::ostream& out, E value) {
    const std::string_view name = detail::nameOf(value);
    return name.empty() ? out << static_cast<std::int64_t>(value) : out << name;
}

/// toString(value): what operator<< writes, as a std::string. An object and not a function, so that it is not
/// found where others look for a toString of their own (Qt Test does).
struct ToString {
    template <class T>
    std::string operator()(const T& value) const {
        std::ostringstream out;
        out << value;
        return out.str();
    }
};
inline constexpr ToString toString;

}  // namespace tiller
