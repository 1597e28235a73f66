//! Control nets and the patches they span
