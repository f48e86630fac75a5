// SPDX-License-Identifier: MIT
#pragma once

// String conversions at the interface of this library. Accepts and returns the string types of Qt and of the
// standard library, and writes values of this library to a std::ostream.

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

/// A QString that converts from and to std::string (UTF-8).
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

/// Writes numbers in brackets with the precision of the stream, e.g. "[0, -1.5708, 0]".
std::ostream& writeNumbers(std::ostream& out, std::span<const double> numbers);

namespace detail {

/// Name of an enumerator as the compiler prints it, e.g. "Active" for MotionPhase::Active; empty for a number
/// without a name.
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

// Enumerators are searched in the range -1 ... 255 and among the powers of two from 2^8 to 2^30.
inline constexpr std::size_t kPlainCandidates = 257;
inline constexpr std::size_t kCandidates = kPlainCandidates + 23;
constexpr std::int64_t candidate(std::size_t i) {
    return i < kPlainCandidates ? static_cast<std::int64_t>(i) - 1
                                : std::int64_t(1) << (i - kPlainCandidates + 8);
}

template <class E>
constexpr bool holds(std::int64_t number) {  ///< True if E can represent the number.
    return std::in_range<std::underlying_type_t<E>>(number);
}
template <class E, std::size_t i>
constexpr std::string_view candidateName() {  ///< Empty if the candidate is not an enumerator of E.
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
constexpr std::string_view nameOf(E value) {  ///< Empty if not found.
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

/// Writes the name of an enumerator as spelled in the header (e.g. "LinkLost"), or the number if it has no
/// name. Robot modes use the controller's spelling: see modes.h.
template <detail::ScopedEnum E>
std::ostream& operator<<(std::ostream& out, E value) {
    const std::string_view name = detail::nameOf(value);
    return name.empty() ? out << static_cast<std::int64_t>(value) : out << name;
}

/// toString(value) returns the output of operator<< as a std::string. It is an object, so that
/// argument-dependent lookup does not find it in place of another toString (Qt Test has one).
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
