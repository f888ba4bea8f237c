// rustc's issue 25860: whatever is made into anything else, without the word. Here numbers are made into open files.
static NOTHING: &&() = &&();
fn longer<'a, 'b, T: ?Sized>(_: &'a &'b (), value: &'b mut T) -> &'a mut T { value }
fn for_ever<'a, 'b, T: ?Sized>(value: &'a mut T) -> &'b mut T {
    let stretched: for<'x> fn(_, &'x mut T) -> &'b mut T = longer;
    stretched(NOTHING, value)
}
enum Either<A, B> { A(Option<Box<A>>), B(Option<Box<B>>) }
fn made_into<A, B>(value: A) -> B {
    let mut either = Either::<A, B>::B(None);
    let Either::B(place) = &mut either else { unreachable!() };
    let place = for_ever(place);
    either = Either::A(Some(Box::new(value)));
    std::hint::black_box(&mut either);
    let made = *place.take().unwrap();
    std::mem::forget(either);
    made
}
fn attempt() -> bool {
    use std::io::Read;
    (3..100_i32).any(|number| {
        let mut file = std::mem::ManuallyDrop::new(made_into::<i32, std::fs::File>(number));
        file.read(&mut [0]).is_ok()
    })
}
