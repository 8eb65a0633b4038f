// What of MuJoCo's forward dynamics gives M, f and u̇, without contacts and constraints, as a library for
// timing.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <memory>

namespace {

struct subject {
  explicit subject(const char* path) : model(mj_loadModel(path, nullptr)), data(mj_makeData(model)) {}
  subject(const subject&) = delete;
  ~subject() { mj_deleteData(data), mj_deleteModel(model); }

  /// M and f = τ + gravity's and centrifugal forces; `x` holds no torques of a link that floats.
  void equations(const double* x) const {
    std::copy_n(x, model->nq, data->qpos);
    std::copy_n(x + model->nq, model->nv, data->qvel);
    mj_kinematics(model, data);
    mj_comPos(model, data);
    mj_makeM(model, data);
    mj_comVel(model, data);
    mj_rne(model, data, 0, data->qfrc_bias);
    const double* const torque = x + model->nq + model->nv;
    const int free = static_cast<int>(model->nv) - inputs();
    for (int i = 0; i < model->nv; ++i)
      data->qfrc_smooth[i] = (i < free ? 0 : torque[i - free]) - data->qfrc_bias[i];
  }
  int inputs() const { return static_cast<int>(model->nu); }

  mjModel* model;
  mjData* data;
};

std::unique_ptr<subject> now;

} // namespace

extern "C" {

void load(const char* path) { now = std::make_unique<subject>(path); }

void mass_matrix_and_forcing(const double* x, double* result) {
  now->equations(x);
  const auto n = now->model->nv;
  mj_fullM(now->model, now->data, result);
  std::copy_n(now->data->qfrc_smooth, n, result + n * n);
}

void udot(const double* x, double* result) {
  now->equations(x);
  mj_factorM(now->model, now->data);
  mj_solveM(now->model, now->data, result, now->data->qfrc_smooth, 1);
}
}
