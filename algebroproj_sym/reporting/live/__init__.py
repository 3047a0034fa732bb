"""The prover in the pages of the site: what is fetched, what is put beside the pages, and what runs in the browser."""
