#pragma once

#include <kanexpr/base/sentence.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/wording.hpp>

#include <string_view>

namespace kanexpr::mechanics {

/// The names of the points and frames on which loads act, for messages.
class load_names {
public:
  constexpr explicit load_names(const mechanism& m) : m_(m) {}

  constexpr const mechanism& mechanism_used() const { return m_; }

  constexpr std::string_view frame(int f) const { return m_.frames[f].called.view(); }
  constexpr std::string_view point(int p) const { return m_.points[p].called.view(); }
  /// Returns the two points or frames between which a load acts: "P and Q".
  template <class Load>
  constexpr sentence ends_of(const Load& load) const {
    if constexpr (requires { load.point; })
      return sentence({point(load.point), " and ", point(load.against)});
    else
      return sentence({frame(load.frame), " and ", frame(load.against)});
  }
  /// Returns the place where a load acts: "at P", "on A", "between P and Q".
  template <class Load>
  constexpr sentence place_of(const Load& load) const {
    if (load.against != none) return sentence({"between ", ends_of(load).view()});
    if constexpr (requires { load.point; })
      return sentence({"at ", point(load.point)});
    else
      return sentence({"on ", frame(load.frame)});
  }

private:
  const mechanism& m_;
};

} // namespace kanexpr::mechanics
