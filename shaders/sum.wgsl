// Sums over a workgroup, as trees of fixed shape.

const GROUP: u32 = 256u;

var<workgroup> tree: array<f32, GROUP>;

fn sum_up(value: f32, local: u32) -> f32 {
    workgroupBarrier();
    tree[local] = value;
    workgroupBarrier();
    for (var half = GROUP / 2u; half > 0u; half /= 2u) {
        if local < half {
            tree[local] += tree[local + half];
        }
        workgroupBarrier();
    }
    return tree[0];
}
