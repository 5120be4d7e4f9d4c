//! Which step runs when: as many at a time as there are workers, the long ones early, and those that measure time with nothing beside them.

use std::sync::{Condvar, Mutex, PoisonError};
use std::thread;

/// What a job asks for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Terms {
    /// Nothing runs beside it: it measures or limits time, or takes every core itself.
    pub alone: bool,
    /// It begins before the others: it takes long, or tells in a moment what is wrong.
    pub early: bool,
    /// Files that it writes: no other job with the same name here runs beside it.
    pub files: Option<&'static str>,
}

/// What is left to do, and what is being written meanwhile.
struct State {
    waiting: Vec<usize>,
    writing: Vec<&'static str>,
}

/// Does every job, and returns what came of each, in their order. Those that run alone come last.
pub fn run<R: Send>(jobs: &[Terms], workers: usize, work: impl Fn(usize) -> R + Sync) -> Vec<R> {
    let mut waiting: Vec<usize> = (0..jobs.len()).filter(|job| !jobs[*job].alone).collect();
    waiting.sort_by_key(|job| !jobs[*job].early);
    let count = workers.min(waiting.len());
    let state = Mutex::new(State {
        waiting,
        writing: Vec::new(),
    });
    let freed = Condvar::new();
    let done = Mutex::new(Vec::new());
    let one = |job: usize| {
        let result = work(job);
        let mut done = done.lock().unwrap_or_else(PoisonError::into_inner);
        done.push((job, result));
    };
    let worker = || {
        while let Some(job) = next(jobs, &state, &freed) {
            one(job);
            let mut state = state.lock().unwrap_or_else(PoisonError::into_inner);
            state
                .writing
                .retain(|files| Some(*files) != jobs[job].files);
            freed.notify_all();
        }
    };
    thread::scope(|scope| {
        for _ in 0..count {
            scope.spawn(worker);
        }
    });
    (0..jobs.len()).filter(|job| jobs[*job].alone).for_each(one);
    let mut done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    done.sort_by_key(|(job, _)| *job);
    done.into_iter().map(|(_, result)| result).collect()
}

/// Takes the next job that may begin, and waits for one; nothing where none is left.
fn next(jobs: &[Terms], state: &Mutex<State>, freed: &Condvar) -> Option<usize> {
    let mut state = state.lock().unwrap_or_else(PoisonError::into_inner);
    loop {
        if state.waiting.is_empty() {
            return None;
        }
        let writing = &state.writing;
        let may_begin = |job: &usize| jobs[*job].files.is_none_or(|f| !writing.contains(&f));
        if let Some(place) = state.waiting.iter().position(may_begin) {
            let job = state.waiting.remove(place);
            state.writing.extend(jobs[job].files);
            return Some(job);
        }
        state = freed.wait(state).unwrap_or_else(PoisonError::into_inner);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Barrier;
    use std::sync::atomic::{AtomicUsize, Ordering::SeqCst};
    use std::time::Duration;

    const PLAIN: Terms = Terms {
        alone: false,
        early: false,
        files: None,
    };

    /// Who ran beside each job, as a job sees it at its begin and its end.
    fn beside(jobs: &[Terms], workers: usize) -> Vec<Vec<usize>> {
        let running = Mutex::new(Vec::new());
        run(jobs, workers, |job| {
            let look = || running.lock().unwrap().clone();
            running.lock().unwrap().push(job);
            let mut seen: Vec<usize> = look();
            thread::sleep(Duration::from_millis(5));
            seen.extend(look());
            running.lock().unwrap().retain(|other| *other != job);
            seen.retain(|other| *other != job);
            seen
        })
    }

    #[test]
    fn results_come_in_the_order_of_the_jobs() {
        let mut jobs = [PLAIN; 9];
        jobs[2].alone = true;
        jobs[7].early = true;
        for workers in [1, 2, 5, 20] {
            let results = run(&jobs, workers, |job| {
                thread::sleep(Duration::from_millis(9 - job as u64));
                job
            });
            assert_eq!(results, [0, 1, 2, 3, 4, 5, 6, 7, 8], "{workers}");
        }
        assert!(run(&[], 2, |job| job).is_empty());
    }

    #[test]
    fn one_that_fails_does_not_stop_the_others() {
        let mut jobs = [PLAIN; 6];
        jobs[5].alone = true;
        let odd = |job: usize| if job % 2 == 0 { Err(job) } else { Ok(job) };
        for workers in [1, 3] {
            let results = run(&jobs, workers, odd);
            assert_eq!(results, [Err(0), Ok(1), Err(2), Ok(3), Err(4), Ok(5)]);
        }
    }

    #[test]
    fn as_many_run_at_a_time_as_there_are_workers() {
        // Nobody would pass a barrier for three with fewer.
        let barrier = Barrier::new(3);
        run(&[PLAIN; 6], 3, |_| barrier.wait().is_leader());
        let most = AtomicUsize::new(0);
        let now = AtomicUsize::new(0);
        run(&[PLAIN; 12], 2, |_| {
            most.fetch_max(now.fetch_add(1, SeqCst) + 1, SeqCst);
            thread::sleep(Duration::from_millis(2));
            now.fetch_sub(1, SeqCst);
        });
        assert_eq!(most.into_inner(), 2);
    }

    #[test]
    fn alone_means_alone() {
        let mut jobs = [PLAIN; 8];
        jobs[0].alone = true;
        jobs[5].alone = true;
        let beside = beside(&jobs, 4);
        assert!(beside[0].is_empty() && beside[5].is_empty(), "{beside:?}");
        for seen in &beside {
            assert!(!seen.contains(&0) && !seen.contains(&5), "{beside:?}");
        }
        assert!(beside.iter().any(|seen| !seen.is_empty()), "{beside:?}");
    }

    #[test]
    fn the_same_files_are_written_by_one_at_a_time() {
        let mut jobs = [PLAIN; 8];
        for job in [0, 1, 3, 6] {
            jobs[job].files = Some("kernels");
        }
        jobs[2].files = Some("others");
        let beside = beside(&jobs, 4);
        for job in [0, 1, 3, 6] {
            for other in [0, 1, 3, 6] {
                assert!(!beside[job].contains(&other), "{beside:?}");
            }
        }
    }

    #[test]
    fn early_ones_begin_first() {
        let mut jobs = [PLAIN; 4];
        jobs[3].early = true;
        let begun = Mutex::new(Vec::new());
        run(&jobs, 1, |job| begun.lock().unwrap().push(job));
        assert_eq!(begun.into_inner().unwrap(), [3, 0, 1, 2]);
    }
}
