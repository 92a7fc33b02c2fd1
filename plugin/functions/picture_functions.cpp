// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/base/require.hpp"
//
#include "freefem/guard.hpp"
#include "pictures/picture_files.hpp"
#include "registration.hpp"
#include "solids.hpp"

namespace ffcontact::plugin {

namespace {

/// contactpicture(C, "folder", step=): the files of the last solution, 0.
class ContactPicture : public E_F0mps {
 public:
  using Result = long;

  explicit ContactPicture(const basicAC_F0& arguments)
      : named_(arguments, {{"step", &typeid(long)}}),
        contact_(to<ContactVariable*>(arguments[0])),
        folder_(to<string*>(arguments[1])) {}

  static ArrayOfaType typeargs() {
    return ArrayOfaType(atype<ContactVariable*>(), atype<string*>());
  }
  static E_F0* f(const basicAC_F0& arguments) {
    return new ContactPicture(arguments);
  }

  AnyType operator()(Stack stack) const override {
    return guarded("contactpicture", [&] { return SetAny<long>(run(stack)); });
  }

 private:
  long run(Stack stack) const {
    const Contact& contact = stated_contact_of_any(stack, contact_);
    const long step = named_.integer(stack, "step", 0);
    if (step < 0) refuse("step must not be negative, got ", step);
    const std::string& folder = *value_of<string*>(stack, folder_);
    if (folder.empty()) refuse("the folder has no name");
    if (contact.solid) {
      solids().draw(folder, step, *contact.solid);
    } else {
      const SolvedContact<2>& solved = solved_contact<2>(contact);
      if (mpirank == 0) write_pictures(folder, step, *contact.problem, solved);
    }
    return 0;
  }

  NamedArguments named_;
  Expression contact_, folder_;
};

}  // namespace

void register_picture_functions() {
  Global.Add("contactpicture", "(", new OneOperatorCode<ContactPicture>());
}

}  // namespace ffcontact::plugin
