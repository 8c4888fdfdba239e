"""Prefect on this machine for people who do not know it: server, work pools, deployments, workers (see DESIGN.md)."""

from flows.service.names import POOLS
from flows.service.state import Service
from flows.service.up import ServiceAsked, down, up
from flows.service.worker import supervise

__all__ = ["POOLS", "Service", "ServiceAsked", "down", "supervise", "up"]
