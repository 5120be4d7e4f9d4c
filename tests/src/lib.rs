//! Where the core meets the reference: domains, generators and the table of tolerances.
